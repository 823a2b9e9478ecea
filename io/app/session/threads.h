// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// How many threads there are, and how long those that wait for each other, as they do many times a step, spin before they sleep.
namespace voussoir::io {

/// Settles how long they spin, unless the user has (OMP_WAIT_POLICY, GOMP_SPINCOUNT, KMP_BLOCKTIME). By default the runtime's threads spin
/// for milliseconds, which is harmless on a quiet machine and ruinous on a busy one: with another process running beside, two threads were
/// 20 times slower than one. A tenth of a millisecond is right where each thread has a processor to itself: it covers what a step does on
/// one thread, and waking takes nearly as long. Else they sleep at once. The runtime reads this before main, so the program starts itself
/// again.
/// \param threads  that will be used; 0: as OpenMP decides
/// \param watch  look for a tenth of a second how many processors are idle; else none counts as idle
void let_threads_sleep(char** argv, int threads, bool watch);

/// Whether so many threads find an idle processor each. A small part of one may be missing, since some work always goes on.
bool room_for(int threads, double idle_processors);

/// Sets the number of threads for all that the program does from here on; 0: as OpenMP decides.
void use_threads(int threads);

/// What holds, for people.
std::string waiting_threads();

}  // namespace voussoir::io
