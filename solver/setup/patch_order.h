// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

namespace voussoir::solver {

/// Sorts the free patches by element, those of one element as they were: patches that a step visits one after the other lie beside each
/// other in memory. Lists of patches (Contacts::active) do not hold any more.
void sort_patches(World& w);

/// True where that is worth its time: sides retire in any order, and their patches are appended. Follows from the state alone.
bool patches_lie_apart(const World& w);

}  // namespace voussoir::solver
