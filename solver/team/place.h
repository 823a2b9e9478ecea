// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace voussoir::solver {

/// Where the user binds threads to places (OMP_PROC_BIND, OMP_PLACES, GOMP_CPU_AFFINITY), binds the calling thread to that of thread
/// number `thread` of a team. The OpenMP runtime has bound the first thread to the first place, which those that it starts inherit.
void place_thread(int thread);

}  // namespace voussoir::solver
