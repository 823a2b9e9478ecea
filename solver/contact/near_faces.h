// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

namespace voussoir::solver {

/// Sets the bound β of every element, and so the dashpots of sides and patches, by the faces that have something near: a side, or a patch
/// with a candidate (THEORY.md (20d)). A function of the lists of contacts and of which sides are retired, so it gives the same after a
/// restart. To be called when the lists have been replaced.
void bound_dashpots_by_near_faces(World& w);

}  // namespace voussoir::solver
