// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernels/side.h"

/// Stiffness of a whole side against the motions of its two elements, for computing the stiffness of the structure.
namespace voussoir::solver {

/// A symmetric 12 × 12 matrix for displacement and rotation of the master, then of the slave [N/m, N, N m].
using Stiffness12 = std::array<double, 144>;

/// Side::twist with which a side resists a twist about its normal with k_s times a constant of torsion [m4] (its factor of Eq. 11
/// included); 0 if both agree to the digits of the points.
double twist_of(const kernels::SideConstants& lane0, double constant);

/// Σ Bᵀ D B dA over the contact points of a side (Eqs. 4, 11), with the slip by twist of its bonded segments, THEORY.md (11a).
Stiffness12 side_stiffness(const kernels::Side& side, const kernels::PointsView& points);

}  // namespace voussoir::solver
