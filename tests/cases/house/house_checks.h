// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "cases/house/house_case.h"
#include "cases/model.h"
#include "geometry/grid.h"
#include "geometry/polygon.h"

/// What holds of every house that is built: areas of joints, nothing unjoined, no slivers.
namespace voussoir::testing {

using namespace voussoir::cases;

inline double area_of(geometry::SegmentList side) {
  return std::accumulate(side.begin(), side.end(), 0.0, [](double sum, const geometry::Segment& s) { return sum + s.area; });
}

inline geometry::Polygon in_frame(const geometry::Polyhedron& shape, int face, const geometry::Frame& f) {
  geometry::Polygon polygon;
  for (const std::int32_t v : shape.faces[static_cast<std::size_t>(face)]) {
    const Vec3 p = shape.vertices[static_cast<std::size_t>(v)] - f.centre;
    polygon.push_back({dot(p, f.axis_s), dot(p, f.axis_t)});
  }
  return polygon;
}

/// The area of a joint is that of both its sides, and that of what the two faces share.
inline void check_joint_areas(const Model& m) {
  double worst_side = 0.0, worst_overlap = 0.0;
  for (const geometry::Joint& j : m.assembly.joints) {
    worst_side = std::max(worst_side, std::abs(area_of(j.side_a) / j.area - 1.0));
    if (j.element_b == geometry::kBase) continue;
    if (!j.merged) worst_side = std::max(worst_side, std::abs(area_of(j.side_b) / j.area - 1.0));
    const geometry::Polygon a = in_frame(m.blocks[static_cast<std::size_t>(j.element_a)].shape, j.face_a, j.frame());
    geometry::Polygon b = in_frame(m.blocks[static_cast<std::size_t>(j.element_b)].shape, j.face_b, j.frame());
    std::reverse(b.begin(), b.end());  // seen from the other side
    const double overlap = geometry::region(geometry::intersection(a, b)).area;
    worst_overlap = std::max(worst_overlap, std::abs(overlap - j.area) / (std::abs(overlap) + 1e-4));
  }
  CHECK(worst_side < 1e-9);
  CHECK(worst_overlap < 1e-9);
}

inline bool is_inside(const Model& m, std::int32_t element, Vec3 p) {
  const geometry::Element& e = m.assembly.elements[static_cast<std::size_t>(element)];
  for (std::int32_t f = e.first_face; f < e.first_face + e.face_count; ++f) {
    const geometry::Face& face = m.assembly.faces[static_cast<std::size_t>(f)];
    if (dot(face.normal, p) > face.offset) return false;
  }
  return true;
}

constexpr double kNoArea = 1e-12;  // m2: what round-off leaves of a face that a joint covers

/// The largest segment of each face, in joints and free: a whole cell, unless every cell of the face is cut.
inline std::map<std::pair<std::int32_t, std::int32_t>, double> largest_segments(const Model& m) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> largest;
  const auto count = [&](std::int32_t element, std::int32_t face, geometry::SegmentList segments) {
    double& most = largest[{element, face}];
    for (const geometry::Segment& s : segments) most = std::max(most, s.area);
  };
  for (const geometry::Joint& j : m.assembly.joints) {
    count(j.element_a, j.face_a, j.side_a);
    if (j.element_b != geometry::kBase) count(j.element_b, j.face_b, j.merged ? j.side_a : j.side_b);
  }
  for (const geometry::FreePatch& patch : m.assembly.patches) count(patch.element, patch.face, patch.segments);
  return largest;
}

/// Before no free segment lies another element. Of cells that a joint cut, an L for one, the centre may lie in the joint.
inline void check_nothing_unjoined(const Model& m) {
  std::vector<geometry::Box3> boxes;
  for (const Block& b : m.blocks) boxes.push_back(geometry::bounds(b.shape));
  geometry::UniformGrid grid;
  grid.build(boxes);
  const auto largest = largest_segments(m);
  std::vector<std::int32_t> near;
  int unjoined = 0;
  for (const geometry::FreePatch& patch : m.assembly.patches) {
    const double whole = largest.at({patch.element, patch.face}), cell = m.blocks[static_cast<std::size_t>(patch.element)].segment_size;
    if (patch.segments.size() == 1 && whole < 0.75 * cell * cell) continue;  // what a foot left of a face about it
    for (const geometry::Segment& s : patch.segments) {
      if (s.area < 0.9 * whole || s.area < kNoArea) continue;
      const Vec3 p = patch.centre + s.s * patch.frame().axis_s + s.t * patch.frame().axis_t + 1e-5 * patch.frame().normal;
      near.clear();
      grid.query({p, p}, near);
      unjoined += static_cast<int>(std::count_if(near.begin(), near.end(), [&](std::int32_t e) { return is_inside(m, e, p); }));
    }
  }
  CHECK(unjoined == 0);
}

/// Bricks are at least two thirds of a brick wide, half a brick long (behind a beam that is narrower as long as that is wide) and half a
/// course high, and no face of them is nearer to the centroid than an eighth of a course. \param true_to_thickness  walls are no whole
/// number of brick widths thick
inline void check_no_slivers(const Model& m, const House& h, bool true_to_thickness = false) {
  const std::array<double, 3> whole{h.brick[0] + h.mortar, h.brick[1] + h.mortar, h.brick[2] + h.mortar};
  const double brick = whole[0] * whole[1] * whole[2];
  double least = 1.0, nearest = 1.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].kind != PartKind::brick) continue;
    const geometry::Element& e = m.assembly.elements[i];
    least = std::min(least, e.mass.volume / brick);
    for (std::int32_t f = 0; f < e.face_count; ++f)
      nearest = std::min(nearest, m.assembly.faces[static_cast<std::size_t>(e.first_face + f)].distance / whole[2]);
  }
  double narrow = 1.0;
  for (const Floor& f : h.floors) narrow = std::min(narrow, f.beam[0] / (0.5 * whole[0]));
  if (true_to_thickness) narrow *= h.floors.empty() ? 2.0 / 3.0 : 0.5;  // behind a beam half a brick's width
  if (h.bond == Bond::rubble) narrow *= 0.6;  // stones within the wall are less deep, and their beds rise and fall
  CHECK(least > 0.25 * narrow - 1e-9);
  CHECK(nearest > 0.125);
}

}  // namespace voussoir::testing
