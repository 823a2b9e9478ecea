// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/cells.h"

#include <algorithm>
#include <utility>

#include "cases/input_error.h"
#include "geometry/polyhedron.h"

namespace voussoir::cases {
namespace {

constexpr std::array<std::size_t, 3> kEdgeEnds{1, 3, 4};  // vertices of a hexahedron that share an edge with its first

bool is_box(const geometry::Polyhedron& shape) {
  if (shape.vertices.size() != 8) return false;
  const auto [low, high] = geometry::bounds(shape);
  return std::ranges::all_of(shape.vertices, [&](Vec3 v) {
    return (v.x == low.x || v.x == high.x) && (v.y == low.y || v.y == high.y) && (v.z == low.z || v.z == high.z);
  });
}

/// Gives an axis-aligned box the vertices of make_box, with its counts by x, y, z.
void square_up(Block& block) {
  if (!is_box(block.shape)) return;
  CellCounts counts{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = block.shape.vertices[kEdgeEnds[k]] - block.shape.vertices[0];
    counts[edge.x != 0.0 ? 0 : edge.y != 0.0 ? 1 : 2] = block.cells[k];
  }
  const auto [low, high] = geometry::bounds(block.shape);
  block.shape = geometry::make_box(low, high);
  block.cells = counts;
}

/// The point `part` of `parts` of the way; the ends themselves have their bits.
Vec3 between(Vec3 from, Vec3 to, int part, int parts) {
  if (part == 0) return from;
  if (part == parts) return to;
  return from + (static_cast<double>(part) / parts) * (to - from);
}

/// A node of the grid of cells: cuts divide edges into equal parts (trilinear).
Vec3 node(const std::vector<Vec3>& v, const CellCounts& n, int i, int j, int k) {
  const auto on = [&](std::size_t from, std::size_t to) { return between(v[from], v[to], i, n[0]); };
  const auto level = [&](std::size_t at) { return between(on(at, at + 1), on(at + 3, at + 2), j, n[1]); };
  return between(level(0), level(4), k, n[2]);
}

void append_cells(Block unit, std::int32_t number, std::vector<Block>& out) {
  square_up(unit);
  const std::vector<Vec3> corners = unit.shape.vertices;
  const CellCounts n = std::exchange(unit.cells, {1, 1, 1});
  unit.unit = number;
  unit.part_of = unit.name;
  int index = 0;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const auto at = [&](int x, int y, int z) { return node(corners, n, i + x, j + y, k + z); };
        Block cell = unit;
        cell.shape = geometry::make_hexahedron(std::array{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),  //
                                                          at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
        ++index;
        if (!unit.name.empty()) {
          cell.name = unit.name + "/" + std::to_string(index);
          if (unit.tag == unit.name) cell.tag = cell.name;
        }
        out.push_back(std::move(cell));
      }
    }
  }
}

}  // namespace

void check_cells(bool halves, const std::optional<CellCounts>& cells, const std::string& key) {
  if (!cells) return;
  if (halves)
    throw InputError(key + ".cells", "does not go with halves = true, which is cells = [2, 1, 1] of whole units; give one of them");
  for (const int n : *cells)
    if (n < 1 || n > kMostCells)
      throw InputError(key + ".cells", std::to_string(n) + "; allowed: three whole numbers from 1 to " + std::to_string(kMostCells));
}

void set_halves(Block& block) {
  square_up(block);
  const auto [low, high] = geometry::bounds(block.shape);
  if (high.x - low.x >= high.y - low.y)
    block.cells = {2, 1, 1};
  else
    block.cells = {1, 2, 1};
}

void divide_units(std::vector<Block>& blocks, std::int32_t& units) {
  if (std::ranges::all_of(blocks, [](const Block& b) { return b.cells == CellCounts{1, 1, 1}; })) return;
  std::vector<Block> out;
  out.reserve(blocks.size());
  for (Block& block : blocks) {
    if (block.cells == CellCounts{1, 1, 1})
      out.push_back(std::move(block));
    else
      append_cells(std::move(block), units++, out);
  }
  blocks = std::move(out);
}

}  // namespace voussoir::cases
