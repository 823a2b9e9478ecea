// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/polygon.h"
#include "geometry/solids/mesh.h"

namespace voussoir::geometry {

/// A face of a mesh with its corners in its plane.
struct FlatFace {
  LoopPlane plane;
  Vec3 axis_s, axis_t;
  Polygon polygon;  // about plane.centre
  bool convex = true;
  double reach = 0.0;  // m, distance of the farthest corner from the centre
};
FlatFace flat_face(const Mesh& m, std::size_t face);

/// Two faces that look at each other: gap and extent of their common area.
struct Facing {
  double low = 0.0, high = 0.0;  // m, least and greatest gap over the common area; negative: overlap
  double tilt = 0.0;             // rad
  double area = 0.0;             // m2, common area
  double width = 0.0;            // m, common area over its greatest length
};

/// Measures how two faces look at each other. std::nullopt if they are not antiparallel within 0.05 rad, share no area, are farther apart
/// than `most` [m], or overlap by more than `most`. Where neither face is convex, the convex hull of the second is taken.
std::optional<Facing> facing(const FlatFace& a, const FlatFace& b, double most);

}  // namespace voussoir::geometry
