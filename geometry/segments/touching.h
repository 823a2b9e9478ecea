// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/segments/face_grid.h"

namespace voussoir::geometry {

/// Map from the plane coordinates of a face B to those of the face A that B touches. The outward normals are opposite, so the map is a
/// reflection: p_A = shift + (c s; s −c) p_B. Lengths and areas are kept to round-off; for aligned bricks every step is exact.
struct PlaneMap {
  double c = 1.0, s = 0.0;
  Point2 shift;  // m

  [[nodiscard]] Point2 to_a(Point2 b) const noexcept { return {shift.s + (c * b.s + s * b.t), shift.t + (s * b.s - c * b.t)}; }
  [[nodiscard]] Point2 to_b(Point2 a) const noexcept {
    const double ds = a.s - shift.s, dt = a.t - shift.t;
    return {c * ds + s * dt, s * ds - c * dt};
  }
};

/// \pre the planes of the two faces coincide and the normals are opposite, within the tolerances of find_contacts.
PlaneMap plane_map(const PlacedGrid& a, const PlacedGrid& b);

/// Two faces that touch. Against the base (element_b = kBase, face_b = −1) `overlap` is the whole face.
struct Contact {
  std::int32_t element_a = 0, face_a = 0;
  std::int32_t element_b = 0, face_b = 0;
  PlaneMap map;
  Polygon overlap;    // coordinates of face_a
  double area = 0.0;  // m2, of the overlap
};

/// All elements with their faces, and data derived from them once.
struct Scene {
  std::span<const Part> parts;
  std::span<const Element> elements;
  std::span<const PlacedGrid> grids;  // of the faces, by element
  std::span<const Box3> boxes;        // by element
  int threads = 1;                    // number of threads to work with
};

/// Penetration depth of two elements [m]: the least overlap along any face normal or product of two edges. Zero or less: the elements are
/// apart. Stops as soon as a value of at most `enough` is found, and returns that value.
double penetration(const Scene& scene, std::int32_t a, std::int32_t b, double enough);

/// Finds the pairs of faces that touch: opposite normals within 1e-6, planes within 1e-6 m, overlap above 1e-8 m2 and wider than 2e-6 m.
/// Sorted by (element_a, face_a, element_b, face_b), element_a < element_b, the base first.
/// \throw ModelError if two elements overlap by more than 1e-6 m, or one reaches more than 1e-6 m below the base.
std::vector<Contact> find_contacts(const Scene& scene, std::optional<double> base_z);

}  // namespace voussoir::geometry
