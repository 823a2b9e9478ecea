// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>

#include "cases/house/house_parts.h"
#include "cases/house/house_ties.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr std::int32_t kNone = -1;
constexpr double kMostNodes = 1e6;

/// Positions of nodes in one direction: as many as fit, half of the remainder at either end.
struct Places {
  int count = 1;
  double first = 0.0, step = 0.0;
  Places(double low, double high, double spacing) : step(spacing) {
    count = std::max(1, static_cast<int>((high - low) / spacing + 1e-9));
    first = 0.5 * (low + high - (count - 1) * spacing);
  }
  [[nodiscard]] double at(int k) const { return first + k * step; }
};

/// Nodes of one face of one wall, by column and row; kNone where there is no node.
struct Sheet {
  int columns = 0, rows = 0;
  std::vector<std::int32_t> nodes;
  [[nodiscard]] std::int32_t at(int column, int row) const { return nth(nodes, row * columns + column); }
};

/// Builds the mesh of one house, in axes of the house.
class Builder {
 public:
  Builder(const HousePlan& plan, const HouseMesh& mesh, std::string key)
      : plan_(plan), mesh_(mesh), key_(std::move(key)), rows_(mesh.from, top(), mesh.spacing[1]) {
    out_.cell = mesh.spacing[0] * mesh.spacing[1];
  }

  PlannedMesh all() {
    const std::vector<Side> walls = chosen_walls(plan_, mesh_.walls, key_);
    check_size(walls);
    std::map<Side, Sheet> outside;
    for (const Side side : walls) {
      std::optional<Sheet> outer, inner;
      if (mesh_.faces != MeshFaces::inside) outer = sheet(side, false);
      if (mesh_.faces != MeshFaces::outside) inner = sheet(side, true);
      if (outer && inner && mesh_.connectors) connect(*outer, *inner);
      if (outer) outside[side] = *outer;
    }
    join(outside, Side::front, true, Side::right, false);
    join(outside, Side::right, true, Side::rear, true);
    join(outside, Side::rear, false, Side::left, true);
    join(outside, Side::left, false, Side::front, false);
    return std::move(out_);
  }

 private:
  [[nodiscard]] double top() const {
    const double height = metres(plan_.height), to = mesh_.to.value_or(height);
    if (to > height + 1e-9) throw InputError(key_ + ".to", text(to) + " m is above the top of the walls (" + text(height) + " m)");
    if (to <= mesh_.from)
      throw InputError(key_ + ".from", text(mesh_.from) + " m is not below the upper edge of the mesh (" + text(to) + " m)");
    return to;
  }
  void check_size(const std::vector<Side>& walls) const {
    double nodes = 0.0;
    for (const Side side : walls) nodes += 2.0 * metres(plan_.wall(side).length) / mesh_.spacing[0] * rows_.count;
    if (nodes > kMostNodes)
      throw InputError(key_ + ".spacing", "makes about " + text(nodes) + " nodes (allowed: " + text(kMostNodes) + ")");
  }
  /// Adds the nodes of one face and the straps between them. An inner face ends at the walls that it meets.
  Sheet sheet(Side side, bool inner) {
    const WallPlan& wall = plan_.wall(side);
    const Places columns(0.0, metres(wall.length), mesh_.spacing[0]);
    Sheet s{columns.count, rows_.count, {}};
    for (int row = 0; row < s.rows; ++row) {
      const WallPlan& here = plan_.wall_at(side, ticks(rows_.at(row)));  // the wall of this storey
      const double low = inner && here.meets[0] ? metres(here.corner) : 0.0;
      const double high = metres(here.length) - (inner && here.meets[1] ? metres(here.corner) : 0.0);
      for (int column = 0; column < s.columns; ++column) {
        const double along = columns.at(column);
        const bool there = along >= low && along <= high;
        s.nodes.push_back(there ? static_cast<std::int32_t>(out_.nodes.size()) : kNone);
        if (there) out_.nodes.push_back(on_wall(plan_, side, along, inner ? metres(here.thickness) : 0.0, rows_.at(row)));
      }
    }
    for (int row = 0; row < s.rows; ++row) {
      for (int column = 0; column < s.columns; ++column) {
        if (column + 1 < s.columns) strap(s.at(column, row), s.at(column + 1, row), mesh_.spacing[1]);
        if (row + 1 < s.rows) strap(s.at(column, row), s.at(column, row + 1), mesh_.spacing[0]);
      }
    }
    return s;
  }
  void strap(std::int32_t a, std::int32_t b, double width) {
    if (a != kNone && b != kNone) out_.straps.push_back({{a, b}, width});
  }
  void connect(const Sheet& outer, const Sheet& inner) {
    const int every = mesh_.connectors->every;
    for (int row = 0; row < outer.rows; row += every) {
      for (int column = 0; column < outer.columns; column += every) {
        if (inner.at(column, row) != kNone) out_.connectors.push_back({outer.at(column, row), inner.at(column, row)});
      }
    }
  }
  /// Adds straps round the corner between the last columns of two walls, at their high or low ends.
  void join(const std::map<Side, Sheet>& sheets, Side a, bool a_high, Side b, bool b_high) {
    const auto first = sheets.find(a), second = sheets.find(b);
    if (first == sheets.end() || second == sheets.end()) return;
    const auto end = [](const Sheet& s, bool high, int row) { return s.at(high ? s.columns - 1 : 0, row); };
    for (int row = 0; row < rows_.count; ++row) strap(end(first->second, a_high, row), end(second->second, b_high, row), mesh_.spacing[1]);
  }

  const HousePlan& plan_;
  const HouseMesh& mesh_;
  std::string key_;
  Places rows_;
  PlannedMesh out_;
};

}  // namespace

PlannedMesh house_mesh(const House& house, std::size_t index, double foot) {
  const HousePlan plan = plan_house(house);
  const PlannedMesh one = Builder(plan, house.meshes[index], indexed_key("house.mesh", index, "")).all();
  PlannedMesh all;
  all.cell = one.cell;
  for (int j = 0; j < house.copies[1]; ++j) {
    for (int i = 0; i < house.copies[0]; ++i) {
      const auto first = static_cast<std::int32_t>(all.nodes.size());
      for (const Vec3 node : one.nodes) all.nodes.push_back(in_case(house, plan, i, j, node) + Vec3{0, 0, foot});
      for (const PlannedMesh::Strap& s : one.straps) all.straps.push_back({{first + s.nodes[0], first + s.nodes[1]}, s.width});
      for (const auto& [a, b] : one.connectors) all.connectors.push_back({first + a, first + b});
    }
  }
  return all;
}

}  // namespace voussoir::cases
