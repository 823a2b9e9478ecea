// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "solver/world/world.h"

/// Natural modes of the undamaged structure: K φ = ω² M φ, with the springs of all bonded segments in the reference configuration. Gravity
/// and contact are ignored.
namespace voussoir::solver {

struct Mode {
  double frequency = 0.0;          // Hz; 0: a mechanism, or an unsupported body
  Vec3 mass_share;                 // effective modal mass along x, y, z over the total moving mass
  std::vector<Vec3> displacement;  // by element, of its centroid; scaled: the largest component, or rotation × radius, of a mode is 1 m
  std::vector<Vec3> rotation;      // rad by element, same scale
};

/// Treatment of joints without a bond: ignored, or held as if bonded.
enum class DryJoints : std::uint8_t { open, closed };

/// The modes of lowest frequency, ascending; fewer than `count` if the structure has fewer degrees of freedom.
/// Shift-invert Lanczos (Spectra) over a sparse LDLᵀ factor (Eigen): memory and time grow with the factor, some 20 s for 45 000 degrees of
/// freedom. \pre count > 0 \throw NumericalError if the iteration does not converge
std::vector<Mode> natural_modes(const World& w, int count, DryJoints dry = DryJoints::open);

/// The modes that take part in a motion of the whole along an axis (0: x, 1: y, 2: z), those with the largest shares of the mass first,
/// however many local modes lie below them: Lanczos iteration from the inertia forces of that motion, in which a mode weighs as much as its
/// share of the mass. Mechanisms are left out. \return at most `count` modes, those that converged
std::vector<Mode> modes_along(const World& w, int axis, int count, DryJoints dry = DryJoints::open);

}  // namespace voussoir::solver
