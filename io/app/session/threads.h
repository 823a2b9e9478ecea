// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Number of threads, and how long waiting threads spin before they sleep; threads wait for each other many times a step.
namespace voussoir::io {

/// Sets how long threads spin, unless the user has set it (OMP_WAIT_POLICY, GOMP_SPINCOUNT, KMP_BLOCKTIME). By default the runtime's
/// threads spin for milliseconds, which does no harm on a quiet machine, but on a busy one: with another process running, two threads were
/// 20 times slower than one. Where each thread has its own processor, they spin for a tenth of a millisecond, which covers the parts of a
/// step on one thread; waking up takes nearly as long. Else they sleep at once. The runtime reads the setting before main, so the program
/// restarts itself.
/// \param threads  to be used; 0: the default of OpenMP
/// \param watch  measure for a tenth of a second how many processors are idle; else none counts as idle
void let_threads_sleep(char** argv, int threads, bool watch);

/// Whether `threads` threads find an idle processor each. A small part of one may be missing, since some other work is always present.
bool room_for(int threads, double idle_processors);

/// Sets the number of threads for the rest of the program; 0: the default of OpenMP.
void use_threads(int threads);

/// The current setting of waiting threads, in words.
std::string waiting_threads();

}  // namespace voussoir::io
