// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/tables/analysis.h"
#include "solver/world/world.h"

/// Distributions of the forces of a pushover over the elements (kernels/THEORY.md, section 11). By element; times mass and gravity it is
/// the force at a load factor of 1. The mean by mass along the push is 1, so a load factor is still a share of the weight.
namespace voussoir::solver {

/// By mass: the push itself, for all elements that are not fixed.
std::vector<Vec3> mass_shape(const World& w, Vec3 push);

/// By mass times height above the base (without one, above the lowest corner). \param push  unit vector
/// \throw cases::InputError at "analysis.pattern" if nothing lies above the base
std::vector<Vec3> triangular_shape(const World& w, Vec3 push);

/// Shifts the resultant of a distribution across the push by `share` of the plan's width, to the left of the push if it is above zero: the
/// accidental eccentricity of EN 1998-1:2004, 4.3.2. The forces p_i become p_i (1 + k (s_i − s̄)), s the coordinate to the left, with k so
/// chosen that Σ p_i stays and the resultant moves by share times the width, which is that of all elements that are not fixed.
/// \throw cases::InputError at "analysis.eccentricity" if all elements lie in one line along the push, or if some would be pushed back
void shift_shape(std::vector<Vec3>& shape, const World& w, Vec3 push, double share);

}  // namespace voussoir::solver
