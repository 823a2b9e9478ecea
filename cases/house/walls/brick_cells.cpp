// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/brick_cells.h"

#include <algorithm>
#include <cmath>

#include "cases/house/house_thickness.h"

namespace voussoir::cases {
namespace {

constexpr std::array<std::size_t, 3> kEdgeEnds{1, 3, 4};  // vertices of a hexahedron that share an edge with its first

constexpr double kHeader = 1.5;  // widths of a brick: pieces that lie deeper in the wall lie across it
constexpr double kTie = 1e-6;    // of a cell: half bricks in three cells are half-way between one and two wherever their wall runs

/// The nearest whole number of cells, halves up within round-off; at least one.
int cells_in(int asked, double share) { return std::clamp(static_cast<int>(std::floor(asked * share + 0.5 + kTie)), 1, kMostCells); }

}  // namespace

CellCounts cells_of_piece(const CellCounts& asked, const std::array<double, 3>& unit, const std::array<double, 3>& piece, bool whole) {
  const bool header = piece[1] > kHeader * unit[1];
  if (whole) return header ? CellCounts{asked[1], asked[0], asked[2]} : asked;
  const int up = cells_in(asked[2], piece[2] / unit[2]);
  if (header) return {cells_in(asked[1], piece[0] / unit[0]), cells_in(asked[0], piece[1] / (2.0 * unit[1])), up};
  return {cells_in(asked[0], piece[0] / unit[0]), cells_in(asked[1], piece[1] / unit[1]), up};
}

CellCounts by_edges(const geometry::Polyhedron& box, Vec3 along, const CellCounts& counts) {
  CellCounts found{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = box.vertices[kEdgeEnds[k]] - box.vertices[0];
    const double up = std::abs(edge.z), forth = std::abs(dot(edge, along)), aside = std::abs(edge.x * along.y - edge.y * along.x);
    found[k] = counts[up > std::max(forth, aside) ? 2 : forth > aside ? 0 : 1];
  }
  return found;
}

std::array<double, 3> cell_unit(const HousePlan& plan, const WallPlan& wall, Interval depth) {
  const Tick leaf = wall.leaf == 0 ? wall.thickness : depth.low < wall.leaf ? wall.leaf : wall.thickness - wall.leaf;
  const double width = metres(leaf) / static_cast<double>(widths_through(plan, leaf));
  const bool header = metres(depth.length()) > kHeader * width;
  return {metres(header ? plan.brick_width : plan.brick_length), width, metres(plan.brick_height)};
}

}  // namespace voussoir::cases
