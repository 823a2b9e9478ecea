// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// The fictitious masses of a relaxation: element by element such that the step of the world is the largest that all of them bear together
/// (kernels/THEORY.md (33)).
namespace voussoir::solver {

/// The loading spring takes at most this share of the stability limit 4/Δt².
inline constexpr double kSpringShare = 0.1;

/// Finds the masses of all elements anew, from the joints, free patches and ties that there are.
void find_inert_masses(World& w);

}  // namespace voussoir::solver
