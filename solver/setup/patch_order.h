// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

namespace voussoir::solver {

/// Sorts the free patches by element, in stable order: patches that a step visits one after the other are then adjacent in memory. Lists of
/// patches (Contacts::active) become invalid.
void sort_patches(World& w);

/// Whether sorting is worth its time: sides retire in any order, and their patches are appended. Depends on the state only.
bool patches_lie_apart(const World& w);

}  // namespace voussoir::solver
