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

constexpr double kOnPlane = 3e-10;   // of the size: corners so near count as on a plane
constexpr double kUnnoticed = 1e-8;  // m: a plane that would cut off less leaves a polyhedron as it is
constexpr double kShift = 3e-8;      // m
constexpr double kDeeper = 3e-6;     // m: where a single cut leaves edges too short, the next is so much deeper
constexpr int kTries = 12;           // with planes shifted by some of these

double height_over(const Polyhedron& p, const HalfSpace& h) {
  double most = -1e300;
  for (const Vec3& v : p.vertices) most = std::max(most, dot(h.normal, v) - h.offset);
  return most;
}

/// How far a plane is shifted [m]: not at all at first, then to either side, each plane by another part of what goes unnoticed.
double shift(std::size_t plane, int attempt) {
  const auto steps = static_cast<int>((plane * 7 + static_cast<std::size_t>(attempt) * 3) % 11) - 5;
  return attempt == 0 ? 0.0 : kShift * steps;
}

/// Cuts in coordinates about a point of the box, so that stones far from the origin keep their digits. Where corners nearly coincide, since
/// a plane passes through one by chance, the planes are shifted by fractions of a micrometre.
Polyhedron cut(const Polyhedron& p, std::span<const HalfSpace> planes, const Box3& box) {
  const Vec3 origin = box.low;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    Polyhedron left = moved(p, -origin);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const HalfSpace h{planes[i].normal, planes[i].offset - dot(planes[i].normal, origin) + shift(i, attempt)};
      if (height_over(left, h) <= kUnnoticed) continue;
      left = clipped(left, h, kOnPlane * size_of(box));
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

Polyhedron part_under(const Polyhedron& p, const HalfSpace& plane) {
  for (int deeper = 0; deeper < 6; ++deeper) {
    const HalfSpace h{plane.normal, plane.offset - kDeeper * deeper};
    if (Polyhedron left = cut(p, {&h, 1}, bounds(p)); !left.faces.empty()) return left;
  }
  Vec3 middle;
  for (const Vec3& v : p.vertices) middle += v / static_cast<double>(p.vertices.size());
  return dot(plane.normal, middle) < plane.offset ? p : Polyhedron{};
}

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
