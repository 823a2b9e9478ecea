// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cases/forward.h"
#include "geometry/assembly.h"
#include "geometry/vec3.h"
#include "solver/limit/limit_ties.h"

/// The model of limit analysis: rigid bodies, the points at which they touch, and the ties that hold them.
namespace voussoir::solver {

/// Elements that move as one rigid body: one element, all elements of one timber member (whose bonds hold), or the pieces of one stone
/// whose joints never break.
struct RigidBody {
  std::vector<std::int32_t> elements;
  double mass = 0.0;  // kg
  Vec3 centre;        // of mass, m
};

/// A contact point of two bodies. The points of a joint are the corners of the convex hull of its segments' points: a force at any other
/// point of the joint is a sum of forces at these, each within the same limits.
struct LimitPoint {
  std::int32_t joint = 0;      // of the assembly
  std::int32_t a = 0, b = -1;  // bodies; −1: the base, or a fixed block
  Vec3 at, normal;             // m; outward of a
  Vec3 first, second;          // unit tangents, axes of the friction cone
  double friction = 0.0;       // tan φ of the joint without its bond
};

struct LimitContacts {
  std::vector<RigidBody> bodies;      // those that can move
  std::vector<std::int32_t> body_of;  // by element; −1: fixed
  std::vector<LimitPoint> points;
  std::vector<LimitTie> ties;
  std::int32_t bonded = 0;  // number of joints with tension or cohesion, which are ignored
};

/// Finds bodies and contact points. \param live  direction of the live forces, along which the friction cones have a corner
LimitContacts limit_contacts(const cases::Model& model, Vec3 live);

/// tan φ of a joint without its bond.
double limit_friction(const cases::Model& model, std::size_t joint);

/// Axes of the friction cone on a joint: the first along the projection of `live` on the joint's plane, else along that of z, else along
/// the joint's own axis.
struct Tangents {
  Vec3 first, second;
};
Tangents limit_tangents(const geometry::Joint& joint, Vec3 normal, Vec3 live);

}  // namespace voussoir::solver
