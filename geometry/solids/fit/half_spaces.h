// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/separation.h"

/// Polyhedra from planes. Internal to geometry/solids/fit/.
namespace voussoir::geometry {

/// The part of a box under all planes, as a valid polyhedron in the vertex order of prisms where it is one. \return no faces if that part
/// has no volume, or edges too short for a polyhedron
Polyhedron common_part(std::span<const HalfSpace> planes, const Box3& within);

/// The part of a valid polyhedron under a plane, as `common_part`; where edges would be too short, under one some micrometres
/// deeper, or the whole polyhedron if most of it is under the plane.
Polyhedron part_under(const Polyhedron& p, const HalfSpace& plane);

/// A corner outside other pieces.
struct Farthest {
  double out = 0.0;  // m
  Vec3 corner;
};

/// The corner of some convex pieces that is farthest outside others, by the planes of the piece that it is nearest to.
Farthest farthest_outside(std::span<const Polyhedron> corners_of, std::span<const Polyhedron> others);

double volume_of(std::span<const Polyhedron> pieces);

}  // namespace voussoir::geometry
