// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "solver/world/world.h"

/// Restitution of a head-on impact with the paper's dashpots at the time step of a run, as without contact.restitution.
namespace voussoir::solver {

/// Two equal elements that meet face to face, per area of the face.
struct HeadOn {
  double mass = 0.0;       // kg/m2, of each of the two
  double stiffness = 0.0;  // Pa/m
  double dashpot = 0.0;    // Pa s/m (THEORY.md (20))
  double step = 0.0;       // s
  bool bounded = true;     // contact.dashpots
};

/// Two elements equal to this one, which meet with this face. \param face  number of the face in the element
[[nodiscard]] HeadOn head_on(const World& w, std::int32_t element, std::int32_t face);

/// Speed at which the two part, over the speed at which they meet, by the formulas of the step: the mean over positions of the instant of
/// contact within a step.
[[nodiscard]] double restitution_of(const HeadOn& h) noexcept;

}  // namespace voussoir::solver
