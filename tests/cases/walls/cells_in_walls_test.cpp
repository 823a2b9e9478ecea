// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "cases/census.h"
#include "tests/cases/cells_checks.h"
#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_spans.h"

// Bricks of walls and houses in cells.
using namespace voussoir;
using namespace voussoir::cases;
using testing::joints_in;
using testing::units_of;

TEST_CASE("the whole bricks of a house are cut, its timber and cut bricks are not") {
  Case c = testing::paper_flat20();
  const Model whole = build_model(c);
  c.house->halves = true;
  c.materials[c.house->material].inside = c.house->joint;
  const Model cut = build_model(c);
  std::size_t bricks = 0;
  double before = 0.0, after = 0.0, area = 0.0;
  for (const Block& b : whole.blocks) bricks += b.kind == PartKind::brick && b.whole ? 1 : 0;
  for (const auto& e : whole.assembly.elements) before += e.mass.volume;
  for (const auto& e : cut.assembly.elements) after += e.mass.volume;
  CHECK(bricks > 0);
  CHECK(cut.blocks.size() == whole.blocks.size() + bricks);
  CHECK(after == doctest::Approx(before).epsilon(1e-12));
  std::size_t cuts = 0;
  for (const geometry::Joint& j : cut.assembly.joints) {
    if (j.element_b == geometry::kBase) continue;
    const Block &a = cut.blocks[static_cast<std::size_t>(j.element_a)], &b = cut.blocks[static_cast<std::size_t>(j.element_b)];
    if (a.unit >= 0 && a.unit == b.unit) ++cuts, area += j.area;
  }
  CHECK(cuts == bricks);
  CHECK(area == doctest::Approx(static_cast<double>(bricks) * c.house->brick[1] * c.house->brick[2]).epsilon(1e-9));
}

namespace {

/// Walls whose whole bricks have cells.
Case walls_in_cells(std::vector<WallSpec> walls, CellCounts n) {
  for (WallSpec& w : walls) w.cells = n;
  Case c = testing::case_of(std::move(walls));
  c.materials["adobe"].inside = "strong";
  return c;
}

/// That every unit of a model has as many joints as a grid of its cells has, and holds as much as in the model without cells.
void check_grids(const Model& m, const Model& whole, const CellCounts& n) {
  double inner = 0.0;
  int pieces = 0;
  for (const auto& [number, u] : units_of(m)) {
    bool is_grid = false;
    for (int i = 1; i <= kMostCells; ++i)
      for (int j = 1; j <= kMostCells; ++j)
        for (int k = 1; k <= n[2]; ++k) is_grid = is_grid || (i * j * k == u.cells && joints_in({i, j, k}) == u.joints);
    CHECK(is_grid);
    pieces += u.cells - 1, inner += u.area;
  }
  CHECK(m.blocks.size() == whole.blocks.size() + static_cast<std::size_t>(pieces));
  CHECK(testing::volume_of(m) == doctest::Approx(testing::volume_of(whole)).epsilon(1e-12));
  const Census in_cells = census(m), before = census(whole);
  CHECK(in_cells.joint_area - inner == doctest::Approx(before.joint_area).epsilon(1e-9));
  CHECK(in_cells.mass == doctest::Approx(before.mass).epsilon(1e-12));
  REQUIRE(in_cells.groups.size() == before.groups.size());
  for (std::size_t i = 0; i < before.groups.size(); ++i) {
    CHECK(in_cells.groups[i].whole == before.groups[i].whole);
    CHECK(in_cells.groups[i].cut == before.groups[i].cut);
  }
}

Model without_cells(Case c) {
  for (WallSpec& w : c.walls) w.cells.reset();
  if (c.house) c.house->cells.reset();
  return build_model(c);
}

}  // namespace

TEST_CASE("bricks of a wall in cells: whole ones as asked for, half ones with fewer along their length") {
  WallSpec w = testing::wall("w", {{0.0, 0.0}, {1.2, 0.0}}, 0.2, 0.8, WallBond::running);
  const Case c = walls_in_cells({w}, {2, 1, 2});
  const Model m = build_model(c), whole = without_cells(c);
  // Four courses: three bricks in one, two and two halves in the next.
  CHECK(whole.blocks.size() == 3 + 4 + 3 + 4);
  CHECK(m.blocks.size() == 10 * 4 + 4 * 2);
  const Census n = census(m);
  CHECK(n.units == 14);
  CHECK(n.cells == 48);
  CHECK(n.cell_joints == 10 * 4 + 4 * 1);
  REQUIRE(n.groups.size() == 1);
  CHECK(n.groups[0].whole == 10);
  CHECK(n.groups[0].cut == 4);
  REQUIRE(n.bill.size() == 2);
  CHECK(n.bill[0].count == 10);
  CHECK(n.bill[0].edges[0] == doctest::Approx(0.4));
  check_grids(m, whole, {2, 1, 2});
  for (const Block& b : m.blocks) {  // the cut of a whole brick is at its middle, where halves have it
    const auto [low, high] = geometry::bounds(b.shape);
    CHECK(high.x - low.x == doctest::Approx(0.2));
    CHECK(high.z - low.z == doctest::Approx(0.1));
  }
}

TEST_CASE("walls of many plans in cells: every unit is a grid, and mass and bill are of the whole units") {
  using testing::wall;
  for (const WallBond bond : {WallBond::english, WallBond::running, WallBond::header, WallBond::through}) {
    CAPTURE(static_cast<int>(bond));
    for (const CellCounts n : {CellCounts{2, 1, 1}, CellCounts{3, 2, 2}}) {
      WallSpec a = wall("a", {{0.0, 0.0}, {3.137, 0.0}, {3.9, 2.6}, {0.2, 2.4}}, 0.41, 1.3, bond);
      a.openings = {{0.713, 0.9, 0.0, 0.813, WallLintel{0.2, 0.137, "wood"}, {}}};
      WallSpec b = wall("b", {{1.9, 0.3}, {1.7, 2.3}}, 0.25, 1.0, bond);
      b.gable = 1.6;
      const Case c = walls_in_cells({a, b}, n);
      const Model m = build_model(c);
      testing::check_nothing_unjoined(m);
      testing::check_stands(m);
      check_grids(m, without_cells(c), n);
      for (const double angle : {0.0, 0.7}) testing::check_same(m, build_model(testing::moved(c, angle, true)));
    }
  }
}

TEST_CASE("closed walls of stretched bricks: as many whole bricks, cells and joints wherever they stand") {
  WallSpec ring =
      testing::closed(testing::wall("ring", {{0.0, 0.0}, {1.424, 0.0}, {1.424, 1.427}, {0.0, 1.427}}, 0.229, 0.634, WallBond::through));
  ring.line = WallLine::right;
  const Case c = walls_in_cells({ring}, {3, 2, 1});
  const Census straight = census(build_model(c));
  for (const double angle : {0.3, 2.13}) {
    const Census turned = census(build_model(testing::moved(c, angle, false)));
    CHECK(turned.cells == straight.cells);
    CHECK(turned.cell_joints == straight.cell_joints);
    REQUIRE(turned.groups.size() == straight.groups.size());
    for (std::size_t i = 0; i < straight.groups.size(); ++i) CHECK(turned.groups[i].whole == straight.groups[i].whole);
  }
}

TEST_CASE("houses in cells: every unit is a grid in each bond, and halves are the cells [2, 1, 1] of whole bricks") {
  for (const Bond bond : {Bond::english, Bond::running, Bond::header, Bond::flemish}) {
    CAPTURE(static_cast<int>(bond));
    Case c = testing::paper_flat20();
    c.house->bond = bond;
    c.house->turn = 90.0;
    c.materials[c.house->material].inside = c.house->joint;
    c.house->cells = CellCounts{2, 1, 1};
    const Model m = build_model(c);
    check_grids(m, without_cells(c), {2, 1, 1});
    Case h = c;
    h.house->cells.reset(), h.house->halves = true;
    const Model halves = build_model(h);
    const auto cut_bricks = [](const Model& x) {
      std::vector<std::vector<Vec3>> all;
      for (const Block& b : x.blocks)
        if (b.kind == PartKind::brick && b.whole && b.unit >= 0) all.push_back(b.shape.vertices);
      return all;
    };
    const auto in_cells = cut_bricks(m), in_halves = cut_bricks(halves);
    REQUIRE(in_cells.size() == in_halves.size());
    CHECK(std::ranges::is_permutation(in_cells, in_halves));
    c.house->cells = CellCounts{2, 2, 2};
    check_grids(build_model(c), without_cells(c), {2, 2, 2});
  }
}

TEST_CASE("houses and walls refuse cells that they cannot have") {
  Case c = testing::paper_flat20();
  c.materials[c.house->material].inside = c.house->joint;
  const auto refused = [&](const std::function<void(House&)>& change, const std::string& key, const std::string& says) {
    testing::check_refused(c, change, key, says);
  };
  refused([](House& h) { h.cells = CellCounts{2, 1, 1}, h.bond = Bond::rubble; }, "house.cells", "rubble");
  refused([](House& h) { h.cells = CellCounts{2, 1, 1}, h.halves = true; }, "house.cells", "halves");
  refused([](House& h) { h.cells = CellCounts{2, 1, -1}; }, "house.cells", "-1; allowed");
  const Case walls = walls_in_cells({testing::wall("w", {{0.0, 0.0}, {1.2, 0.0}}, 0.2, 0.8)}, {2, 1, 17});
  testing::check_refused(walls, std::function<void(Case&)>([](Case&) {}), "wall[0].cells", "17; allowed");
  testing::check_refused(walls, std::function<void(Case&)>([](Case& x) {
                           x.walls[0].cells = CellCounts{2, 1, 1}, x.materials["adobe"].inside.reset();
                         }),
                         "materials.adobe.inside", "wall.cells");
}
