// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/replay/cells.h"

#include <array>
#include <stdexcept>
#include <string>

namespace voussoir::io {
namespace {

double handedness(const geometry::Polyhedron& p, std::array<int, 4> corner) {
  const auto at = [&](int i) { return p.vertices[static_cast<std::size_t>(i)]; };
  return dot(cross(at(corner[1]) - at(corner[0]), at(corner[2]) - at(corner[0])), at(corner[3]) - at(corner[0]));
}

// VTK wants the bottom of a hexahedron counter-clockwise seen from its top, that of a wedge clockwise.
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

// Sides only of corners i, i + 1 and those above them; then the halves of the vertices are bottom and top.
bool is_prism(const geometry::Polyhedron& p) {
  const int k = static_cast<int>(p.vertices.size()) / 2;
  if (k < 3 || p.vertices.size() % 2 != 0 || p.faces.size() != static_cast<std::size_t>(k + 2)) return false;
  int ends = 0;
  for (const auto& face : p.faces) {
    int below = 0;
    for (const std::int32_t v : face) below += v < k ? 1 : 0;
    const int size = static_cast<int>(face.size());
    if (size == k && (below == 0 || below == k))
      ++ends;
    else if (size != 4 || below != 2)
      return false;
  }
  return ends == 2;
}

}  // namespace

Cells cells_of(const cases::Model& model) {
  Cells cells;
  std::int32_t first = 0, element = 0;
  for (const cases::Block& b : model.blocks) {
    const std::size_t corners = b.shape.vertices.size();
    if (!is_prism(b.shape))
      throw std::invalid_argument("element " + std::to_string(element) + " \"" + (b.name.empty() ? b.tag : b.name) + "\" has " +
                                  std::to_string(corners) + " vertices and " + std::to_string(b.shape.faces.size()) +
                                  " faces: results can hold hexahedra and prisms only");
    corners == 8 ? add_hexahedron(b.shape, first, element, cells) : add_prism(b.shape, first, element, cells);
    first += static_cast<std::int32_t>(corners);
    ++element;
  }
  return cells;
}

}  // namespace voussoir::io
