// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cases/model.h"

/// What limit analysis sees of a model: bodies that cannot come apart, and the points at which they touch.
namespace voussoir::solver {

/// Elements that move as one rigid body: one element, or those of one timber member (its bonds hold).
struct RigidBody {
  std::vector<std::int32_t> elements;
  double mass = 0.0;  // kg
  Vec3 centre;        // of mass, m
};

/// Where two bodies touch. The points of a joint are the corners of the convex hull of its segments' points: a force at any other point of
/// it is the sum of forces at these, each within the same limits.
struct LimitPoint {
  std::int32_t joint = 0;      // of the assembly
  std::int32_t a = 0, b = -1;  // bodies; −1: the base, or a fixed block
  Vec3 at, normal;             // m; outward of a
  double friction = 0.0;       // tan φ of the joint without its bond
};

/// Blocks that are prisms across one vertical plane, all as thick, with a live force in that plane: what lies behind one another is one
/// point, nothing moves out of the plane, and by symmetry nothing is lost by that.
struct LimitPlane {
  Vec3 along;           // horizontal unit vector in the plane
  double middle = 0.0;  // m, of the blocks' thickness, along z × `along`
};

struct LimitContacts {
  std::vector<RigidBody> bodies;      // those that can move
  std::vector<std::int32_t> body_of;  // by element; −1: fixed
  std::vector<LimitPoint> points;
  std::optional<LimitPlane> plane;
  std::int32_t bonded = 0;  // joints with tension or cohesion, which do not count
};

/// \param live  horizontal unit vector \param reduce  to a plane, where the model allows it
LimitContacts limit_contacts(const cases::Model& model, Vec3 live, bool reduce);

}  // namespace voussoir::solver
