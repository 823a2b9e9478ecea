// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "fixtures.h"

namespace voussoir::geometry::test {

inline const Face& face_of(const Assembly& a, std::int32_t element, std::int32_t face) {
  return a.faces[static_cast<std::size_t>(a.elements[static_cast<std::size_t>(element)].first_face + face)];
}

/// What every assembly must fulfil, whatever the shapes.
inline void check_invariants(const Assembly& a) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> joined;
  for (const Joint& j : a.joints) {
    CHECK((j.element_b == kBase || j.element_a < j.element_b));
    CHECK(std::abs(sum_of_areas(j.side_a) - j.area) <= 1e-9 * j.area);
    if (j.element_b == kBase || j.merged) {
      CHECK(j.side_b.empty());
    } else {
      CHECK(std::abs(sum_of_areas(j.side_b) - j.area) <= 1e-9 * j.area);
      const FirstMoments b = first_moments(j.side_b);
      CHECK(near(b.s, 0.0, 3e-12 * j.area));
      CHECK(near(b.t, 0.0, 3e-12 * j.area));
    }
    const FirstMoments m = first_moments(j.side_a);
    CHECK(near(m.s, 0.0, 1e-12 * j.area));
    CHECK(near(m.t, 0.0, 1e-12 * j.area));
    const Face& face = face_of(a, j.element_a, j.face_a);
    CHECK(near(j.frame().normal, face.normal, 1e-14));
    CHECK(near(cross(j.frame().axis_s, j.frame().axis_t), j.frame().normal, 1e-14));
    CHECK(near(dot(face.normal, j.centre), face.offset, 1e-9));
    joined[{j.element_a, j.face_a}] += j.area;
    if (j.element_b != kBase) joined[{j.element_b, j.face_b}] += j.area;
  }
  for (const FreePatch& p : a.patches) {
    const FirstMoments m = first_moments(p.segments);
    const double area = sum_of_areas(p.segments);
    CHECK(near(m.s, 0.0, 1e-12 * area));
    CHECK(near(m.t, 0.0, 1e-12 * area));
    joined[{p.element, p.face}] += area;
  }
  // Joints and what is left make up the face; a dropped remainder is under 1 % of a cell.
  for (const auto& [key, area] : joined) CHECK(area == relative(face_of(a, key.first, key.second).area, 0.01));
  const auto key = [](const Joint& j) { return std::array{j.element_a, j.face_a, j.element_b, j.face_b}; };
  CHECK(std::is_sorted(a.joints.begin(), a.joints.end(), [&](const Joint& x, const Joint& y) { return key(x) < key(y); }));
}

inline double free_area(const Assembly& a, std::int32_t element, std::int32_t face) {
  for (const FreePatch& p : a.patches) {
    if (p.element == element && p.face == face) return sum_of_areas(p.segments);
  }
  return 0.0;
}

}  // namespace voussoir::geometry::test
