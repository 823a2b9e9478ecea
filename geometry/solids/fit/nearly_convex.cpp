// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "geometry/nth.h"
#include "geometry/solids/fit/fit_planes.h"
#include "geometry/solids/fit/half_spaces.h"
#include "geometry/solids/folds.h"

namespace voussoir::geometry {

namespace {

constexpr double kConvex = 1e-9;  // of the size, as validate()
constexpr double kTurn = 0.5;     // rad, most between faces that become one
constexpr std::size_t kMostOfSolid = 4096;
constexpr double kOfARound = 30.0;  // ns, of a face and a corner

Box3 box_around(const Mesh& m, double limit) {
  Box3 box = box_of(m);
  const Vec3 all{limit, limit, limit};
  return {box.low - all, box.high + all};
}

/// Distance between a solid and the polyhedron of its planes: corners of the one from planes of the other, and corners of faces from
/// theirs.
double distance_of(const Mesh& solid, std::span<const HalfSpace> planes, const Polyhedron& shape) {
  double most = 0.0;
  for (const HalfSpace& h : planes) {
    for (const Vec3& v : solid.vertices) most = std::max(most, dot(h.normal, v) - h.offset);
  }
  std::vector<HalfSpace> drawn;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) drawn.push_back(half_space_of(solid, f));
  // A corner that a plane has cut off may be far from the next corner of the shape, but not from its surface.
  for (const Vec3& v : shape.vertices) {
    double nearest = 1e300;
    for (const Vec3& w : solid.vertices) nearest = std::min(nearest, norm(w - v));
    double out = -1e300;
    for (const HalfSpace& h : drawn) out = std::max(out, dot(h.normal, v) - h.offset);
    most = std::max(most, std::min(nearest, out));
  }
  return most;
}

}  // namespace

std::optional<Polyhedron> nearly_convex(const Mesh& solid, double limit, double& moved, FitWork& work, std::int32_t stone) {
  moved = 0.0;
  const double size = diagonal(solid);
  if (solid.faces.size() > kMostOfSolid) return std::nullopt;
  for (double within = std::max(1e-6 * size, 1e-9); within < 2.0 * limit; within *= 2.0) {
    work.add(kOfARound * static_cast<double>(solid.faces.size()) * static_cast<double>(solid.vertices.size()), stone);
    const Mesh merged = with_merged_faces(solid, std::min(within, limit), kTurn);
    if (merged.faces.size() < 4 || !is_convex(merged, 2.0 * within)) continue;
    std::vector<HalfSpace> planes;
    for (std::size_t f = 0; f < merged.faces.size(); ++f) planes.push_back(half_space_of(merged, f));
    Polyhedron shape = common_part(planes, box_around(solid, 2.0 * limit));
    if (shape.faces.empty()) continue;
    moved = distance_of(solid, planes, shape);
    if (moved <= limit) return shape;
  }
  return std::nullopt;
}

}  // namespace voussoir::geometry
