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
  double reach = 0.0;  // m, of the farthest corner from the centre
};
FlatFace flat_face(const Mesh& m, std::size_t face);

/// Two faces that look at each other: how far apart they are over what they share.
struct Facing {
  double low = 0.0, high = 0.0;  // m; below 0: the planes are inside each other
  double tilt = 0.0;             // rad
  double area = 0.0;             // m2, shared
  double width = 0.0;            // m, shared area over its greatest length
};

/// How two faces look at each other. std::nullopt if they are not antiparallel within 0.05 rad, share no area, or are farther apart than
/// `most` [m]. Where neither face is convex, the hull of the second is taken.
std::optional<Facing> facing(const FlatFace& a, const FlatFace& b, double most);

}  // namespace voussoir::geometry
