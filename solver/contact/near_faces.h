// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "solver/world/world.h"

namespace voussoir::solver {

/// Sets the bound β of every element, and so the dashpots of sides and patches, by the faces that have something near: a side, or a patch
/// with a candidate (THEORY.md (20d)). A function of the lists of contacts and of which sides are retired, so it gives the same after a
/// restart. To be called when the lists have been replaced.
/// \param changed  by patch, 1: its candidates, or poses at its last search or theirs, are others than before; nullptr: all may be
void bound_dashpots_by_near_faces(World& w, const std::vector<std::uint8_t>* changed);

}  // namespace voussoir::solver
