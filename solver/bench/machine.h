// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solver/team/team.h"

/// Best performance of the machine, for comparison with that of a step.
namespace voussoir::solver {

/// Multiply-adds in registers on all threads [flop/s]; a multiply-add counts as two.
double peak_flops(int threads);

/// Number of cores that this program may use.
int processors();

/// Current time of each thread [s] for some thirty microseconds of arithmetic of all kinds in registers: longer than at best on a core that
/// is temporarily used by others, or whose other hardware thread is.
std::vector<double> core_times(Team& team);

/// Current mean time [s] until a thread sees a value written by the thread before; 0 for one thread, or for more threads than cores. Cores
/// that share a cache need 25 to 65 ns, others 110 to 180.
double handover_now(Team& team);

/// Bandwidth of the triad a = b + s c of STREAM over arrays far larger than any cache [byte/s].
double peak_bandwidth(int threads);

}  // namespace voussoir::solver
