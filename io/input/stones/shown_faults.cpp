// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/shown_faults.h"

#include <algorithm>

#include "geometry/solids/triangles.h"
#include "io/input/stones/words.h"

namespace voussoir::io {
namespace {

using geometry::Polyhedron;

constexpr double kThickness = 0.004;      // of the size
constexpr std::size_t kMostPlates = 400;  // of one stone
constexpr std::size_t kMostNames = 8;

/// Adds a triangle with some thickness on both sides, unless it is needle-shaped.
void add_plate(const std::array<Vec3, 3>& corners, double thickness, std::vector<cases::StonePiece>& out) {
  const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(norm(across) > 1e-6 * thickness * thickness)) return;
  const Vec3 up = (0.5 * thickness) * normalised(across);
  Polyhedron p;
  for (const double side : {-1.0, 1.0}) {
    for (const Vec3& v : corners) p.vertices.push_back(v + side * up);
  }
  p.faces = {{2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  try {
    geometry::validate(p);
    out.push_back({std::move(p), {}});
  } catch (const geometry::ModelError&) {
    return;  // too narrow to be visible
  }
}

}  // namespace

std::string other_faults(const std::vector<StoneFault>& faults) {
  if (faults.size() < 2) return "";
  const std::size_t more = faults.size() - 1;
  std::string text = " (and " + std::to_string(more) + (more == 1 ? " more stone is at fault: " : " more stones are at fault: ");
  for (std::size_t i = 1; i <= std::min(more, kMostNames); ++i) text += (i > 1 ? ", " : "") + quoted_word(faults[i].stone);
  return text + (more > kMostNames ? ", ...)" : ")");
}

std::vector<cases::StonePiece> plates_of(const geometry::Mesh& mesh) {
  const double size = geometry::diagonal(mesh);
  std::size_t triangles = 0;
  for (const auto& loop : mesh.faces) triangles += loop.size() - 2;
  std::vector<cases::StonePiece> out;
  for (std::size_t f = 0; triangles <= kMostPlates && f < mesh.faces.size(); ++f) {
    for (const auto& t : geometry::triangles_of(mesh, f)) add_plate(t, kThickness * size, out);
  }
  if (!out.empty()) return out;
  const geometry::Box3 box = geometry::bounds(Polyhedron{mesh.vertices, {}});
  const Vec3 least{kThickness * size, kThickness * size, kThickness * size};
  out.push_back({geometry::make_box(box.low - least, box.high + least), {}});
  return out;
}

}  // namespace voussoir::io
