// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "solver/world/world.h"

/// What the dashpots of the paper give back of an impact at a time step: contact.restitution is not given then.
namespace voussoir::solver {

/// Two equal elements that meet face to face, per area of the face.
struct HeadOn {
  double mass = 0.0;       // kg/m2, of each of the two
  double stiffness = 0.0;  // Pa/m
  double dashpot = 0.0;    // Pa s/m (THEORY.md (20))
  double step = 0.0;       // s
  bool bounded = true;     // contact.dashpots
};

/// An element of the world and its like, which meet with this face of the element.
[[nodiscard]] HeadOn head_on(const World& w, std::int32_t element, std::int32_t face);

/// Speed at which the two part over that at which they meet, by the formulas of the step; mean over the instants at which they may meet.
[[nodiscard]] double restitution_of(const HeadOn& h) noexcept;

}  // namespace voussoir::solver
