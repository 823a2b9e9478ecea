// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/loads/loaded_place.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cases/model.h"
#include "geometry/polyhedron.h"

namespace voussoir::cases {

namespace {

constexpr double kInside = 1e-9;  // of an element's size: a point so near to its surface lies on it

}  // namespace

/// An element is convex: the line is in it between the last plane that it enters by and the first that it leaves by.
LoadedPlace place_of_load(const Model& model, Vec3 from, Vec3 direction) {
  LoadedPlace best;
  double nearest = std::numeric_limits<double>::infinity(), off_centre = nearest;
  const geometry::Assembly& a = model.assembly;
  for (std::size_t e = 0; e < a.elements.size(); ++e) {
    double in = 0.0, out = std::numeric_limits<double>::infinity(), size = 0.0;
    const Vec3 centre = a.elements[e].mass.centroid;
    for (const Vec3 v : model.blocks[e].shape.vertices) size = std::max(size, norm(v - centre));
    for (std::size_t f = 0; f < model.blocks[e].shape.faces.size(); ++f) {
      const geometry::FacePlane plane = geometry::face_plane(model.blocks[e].shape, static_cast<int>(f));
      const double slope = dot(plane.normal, direction), off = dot(plane.normal, from - plane.centroid);
      if (std::abs(slope) < kInside) {
        if (off > kInside * size) out = -1.0;
      } else if (slope < 0.0) {
        in = std::max(in, (off - kInside * size) / -slope);
      } else {
        out = std::min(out, (kInside * size - off) / slope);
      }
    }
    if (in > out) continue;
    const Vec3 where = from + in * direction;
    const double off = norm(where - centre);
    // Where two elements meet, that whose centre is nearer, whatever their order.
    const bool nearer = in < nearest - kInside * size, as_near = in <= nearest + kInside * size;
    if (nearer || (as_near && off < off_centre)) nearest = in, off_centre = off, best = {static_cast<std::int32_t>(e), where};
  }
  return best;
}

}  // namespace voussoir::cases
