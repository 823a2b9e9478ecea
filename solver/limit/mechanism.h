// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "solver/limit/limit.h"

/// The mechanism of a collapse: which bodies move as one, and how these parts move against each other.
namespace voussoir::solver {

/// Bodies that move as one.
struct MechanismPart {
  std::vector<std::int32_t> bodies;
  double mass = 0.0;      // kg
  Vec3 centre;            // of mass, m
  kernels::Twist motion;  // about the centre; the fastest point of the mechanism has the speed 1
};

/// What two parts do where they touch.
struct MechanismSeam {
  std::int32_t a = -1, b = -1;  // parts; −1: the ground, with all that stands
  int joints = 0;
  double slide = 0.0, open = 0.0;  // largest speed of points against each other, along the joint and across it
  bool hinge = false;              // it opens, and some point of it does not move
};

struct Mechanism {
  std::vector<MechanismPart> parts;  // that move, heaviest first
  std::vector<MechanismSeam> seams;  // in the order of their parts
  double standing = 0.0;             // kg, of what does not move
};

Mechanism mechanism_of(const LimitContacts& contacts, const LimitState& state);

}  // namespace voussoir::solver
