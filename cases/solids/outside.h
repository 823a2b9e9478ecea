// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "geometry/assembly.h"
#include "geometry/nth.h"

namespace voussoir::cases {

/// Signed distance of a point from an element [m]: the greatest distance outside any of its faces; below 0 inside.
inline double distance_outside(const geometry::Assembly& a, std::size_t element, Vec3 point) {
  double most = -std::numeric_limits<double>::infinity();
  const geometry::Element& e = a.elements[element];
  for (std::int32_t f = 0; f < e.face_count; ++f) {
    const geometry::Face& face = nth(a.faces, e.first_face + f);
    most = std::max(most, dot(face.normal, point) - face.offset);
  }
  return most;
}

}  // namespace voussoir::cases
