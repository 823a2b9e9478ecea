// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/assembly.h"

/// How stiff joints of solid blocks are against a twist about their normals (THEORY.md (11a)-(11c)).
namespace voussoir::geometry {

/// Saint-Venant's constant J of a rectangle [m4]: the torque is G J times the twist per length. Timoshenko and Goodier, Theory of
/// Elasticity, section 109. \pre both edges are positive
double torsion_constant(double a, double b);

/// Constants of torsion of a joint [m4].
struct JointTorsion {
  double solid = 0.0;  // J of the overlap in a solid
  double polar = 0.0;  // I_p of the overlap: faces that stay plane
};

/// By joint. An overlap that is a rectangle along the joint's axes has J of a bar where all its edges are free, and of a plate where both
/// of one pair are free and material goes on beyond the others; where it goes on beyond edges of both pairs, J = I_p. Any other overlap has
/// A⁴/(40 I_p), Saint-Venant's substitute, but no more than I_p, if all four edges of the rectangle round it are free, else I_p. An edge is
/// free if at two of four places nothing lies beyond it on one of the two sides of the joint.
std::vector<JointTorsion> joint_torsion(const Assembly& a);

}  // namespace voussoir::geometry
