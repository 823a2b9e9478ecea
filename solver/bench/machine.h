// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

/// What the machine can do at best, to measure a step against.
namespace voussoir::solver {

/// Multiply-adds in registers on all threads [flop/s], a multiply-add counting two.
double peak_flops(int threads);

/// What each thread takes just now [s] for some thirty microseconds of arithmetic of all kinds, in registers: more than at best on a core
/// that others have for a while, or whose other half is at work for others.
std::vector<double> core_times(int threads);

/// What it takes a thread just now to see what the one before it has written [s], on the average over the team; 0 for one thread, or for
/// more than the machine has cores. Cores that share a cache need 25 to 65 ns, others 110 to 180.
double handover_now(int threads);

/// The triad a = b + s c of STREAM over arrays far larger than any cache [byte/s].
double peak_bandwidth(int threads);

}  // namespace voussoir::solver
