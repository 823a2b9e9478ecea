// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What the machine can do at best, to measure a step against.
namespace voussoir::solver {

/// Multiply-adds in registers on all threads [flop/s], a multiply-add counting two.
double peak_flops(int threads);

/// The same just now, in a millisecond: of a core that is shared with others less than at best.
double flops_now(int threads);

/// What it takes a thread just now to see what the one before it has written [s], on the average over the team; 0 for one thread, or for
/// more than the machine has cores. Cores that share a cache need 25 to 60 ns, others 110 to 180.
double handover_now(int threads);

/// The triad a = b + s c of STREAM over arrays far larger than any cache [byte/s].
double peak_bandwidth(int threads);

}  // namespace voussoir::solver
