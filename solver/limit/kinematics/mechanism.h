// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "solver/limit/limit.h"

/// The mechanism of a collapse: bodies that move as one part, and relative motions of the parts.
namespace voussoir::solver {

/// Bodies that move as one.
struct MechanismPart {
  std::vector<std::int32_t> bodies;
  double mass = 0.0;      // kg
  Vec3 centre;            // of mass, m
  kernels::Twist motion;  // about the centre; the fastest point of the mechanism has the speed 1
};

/// Relative motion of two parts at their contacts.
struct MechanismSeam {
  std::int32_t a = -1, b = -1;  // parts; −1: the ground, with all parts at rest
  int joints = 0;
  double slide = 0.0, open = 0.0;  // largest relative speed of points, along the joint and across it
  bool hinge = false;              // the joint opens, and some point of it is at rest
};

struct Mechanism {
  std::vector<MechanismPart> parts;  // moving parts, heaviest first
  std::vector<MechanismSeam> seams;  // in the order of their parts
  double standing = 0.0;             // kg, mass at rest
};

Mechanism mechanism_of(const LimitContacts& contacts, const LimitState& state);

}  // namespace voussoir::solver
