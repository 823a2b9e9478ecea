// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/fit/half_spaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/mass.h"
#include "geometry/prism.h"
#include "geometry/solids/pieces.h"

namespace voussoir::geometry {

namespace {

double size_of(const Box3& box) { return norm(box.high - box.low); }

/// Corners count as on a plane within this, of the size; if the outcome has edges too short, the next is tried.
constexpr double kOnPlane[] = {3e-10, 1e-9, 3e-11, 3e-9};

/// Cuts in coordinates about a point of the box, so that stones far from the origin keep their digits.
Polyhedron cut(const Polyhedron& p, std::span<const HalfSpace> planes, const Box3& box) {
  const Vec3 origin = box.low;
  for (const double on_plane : kOnPlane) {
    Polyhedron left = moved(p, -origin);
    for (const HalfSpace& h : planes) {
      left = clipped(left, {h.normal, h.offset - dot(h.normal, origin)}, on_plane * size_of(box));
      if (left.faces.size() < 4) return {};
    }
    try {
      left = in_prism_order(left);
      validate(left);
    } catch (const ModelError&) {
      continue;
    }
    return moved(left, origin);
  }
  return {};
}

}  // namespace

Polyhedron common_part(std::span<const HalfSpace> planes, const Box3& within) {
  return cut(make_box(within.low, within.high), planes, within);
}

Polyhedron part_under(const Polyhedron& p, const HalfSpace& plane) { return cut(p, {&plane, 1}, bounds(p)); }

Farthest farthest_outside(std::span<const Polyhedron> corners_of, std::span<const Polyhedron> others) {
  std::vector<std::vector<FacePlane>> planes;
  for (const Polyhedron& q : others) {
    planes.emplace_back();
    for (std::size_t f = 0; f < q.faces.size(); ++f) planes.back().push_back(face_plane(q, static_cast<int>(f)));
  }
  Farthest farthest;
  for (const Polyhedron& p : corners_of) {
    for (const Vec3& v : p.vertices) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& of : planes) {
        double out = 0.0;
        for (const FacePlane& plane : of) out = std::max(out, dot(plane.normal, v - plane.centroid));
        least = std::min(least, out);
      }
      if (std::isfinite(least) && least > farthest.out) farthest = {least, v};
    }
  }
  return farthest;
}

double volume_of(std::span<const Polyhedron> pieces) {
  double sum = 0.0;
  for (const Polyhedron& p : pieces) sum += signed_volume(p);
  return sum;
}

}  // namespace voussoir::geometry
