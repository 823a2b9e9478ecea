// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/cells.h"

#include <algorithm>
#include <array>

#include "cases/model.h"
#include "geometry/nth.h"
#include "geometry/prism.h"

namespace voussoir::io {
namespace {

double handedness(const geometry::Polyhedron& p, std::array<int, 4> corner) {
  const auto at = [&](int i) { return nth(p.vertices, i); };
  return dot(cross(at(corner[1]) - at(corner[0]), at(corner[2]) - at(corner[0])), at(corner[3]) - at(corner[0]));
}

// VTK requires the bottom of a hexahedron counter-clockwise seen from its top, that of a wedge clockwise.
void add_hexahedron(const geometry::Polyhedron& p, std::int32_t first, std::int32_t element, Cells& cells) {
  const bool right = handedness(p, {0, 1, 3, 4}) > 0;
  const std::array<int, 8> order = right ? std::array{0, 1, 2, 3, 4, 5, 6, 7} : std::array{0, 3, 2, 1, 4, 7, 6, 5};
  for (const int i : order) cells.corners.push_back(first + i);
  cells.type.push_back(kHexahedron);
  cells.element.push_back(element);
}

void add_prism(const geometry::Polyhedron& p, std::int32_t first, std::int32_t element, Cells& cells) {
  const int k = static_cast<int>(p.vertices.size()) / 2;
  const bool turn = handedness(p, {0, 1, 2, k}) > 0;
  for (int i = 1; i + 1 < k; ++i) {
    const int b = turn ? i + 1 : i, c = turn ? i : i + 1;
    for (const int v : {0, b, c, k, k + b, k + c}) cells.corners.push_back(first + v);
    cells.corners.insert(cells.corners.end(), 2, -1);
    cells.type.push_back(kWedge);
    cells.element.push_back(element);
  }
}

void add_tetrahedra(const geometry::Polyhedron& p, std::int32_t first, std::int32_t element, Cells& cells) {
  for (const auto& face : p.faces) {
    if (std::find(face.begin(), face.end(), 0) != face.end()) continue;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {  // a face is counter-clockwise from outside, VTK's base from the fourth corner
      for (const std::int32_t v : {face[0], face[i + 1], face[i], 0}) cells.corners.push_back(first + v);
      cells.corners.insert(cells.corners.end(), 4, -1);
      cells.type.push_back(kTetrahedron);
      cells.element.push_back(element);
    }
  }
}

}  // namespace

Cells cells_of(const cases::Model& model) {
  Cells cells;
  std::int32_t first = 0, element = 0;
  for (const cases::Block& b : model.blocks) {
    const std::size_t corners = b.shape.vertices.size();
    if (!geometry::is_prism(b.shape)) {
      add_tetrahedra(b.shape, first, element, cells);
    } else {
      corners == 8 ? add_hexahedron(b.shape, first, element, cells) : add_prism(b.shape, first, element, cells);
    }
    first += static_cast<std::int32_t>(corners);
    ++element;
  }
  return cells;
}

int corners_of(std::uint8_t type) noexcept { return type == kTetrahedron ? 4 : type == kWedge ? 6 : 8; }

}  // namespace voussoir::io
