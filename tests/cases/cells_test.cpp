// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/cells.h"

#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "cases/loads/loads.h"
#include "tests/cases/cells_checks.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using testing::joints_in;
using testing::OfUnit;
using testing::product;
using testing::size_of;
using testing::units_of;
using testing::volume_of;

namespace {

/// Two courses of bricks of 0.2 x 0.1 x 0.1 m; those of the lower course in halves.
Case two_courses() {
  Case c;
  c.base = Base{};
  c.materials["brick"] = {1800.0, 1e9, 0.2, "own"};
  c.joint_laws["own"] = {.tension = 3e5, .cohesion = 6e5, .friction = 45.0, .compression = 1e7};
  c.joint_laws["mortar"] = {.tension = 1e4, .cohesion = 1e4, .friction = 30.0, .compression = 1e7};
  c.joints.default_law = "mortar";
  const auto add = [&](const std::string& name, double x, double z, bool halves) {
    BlockSpec b;
    b.name = name, b.material = "brick", b.halves = halves;
    b.box = {{Vec3{x, 0.0, z}, Vec3{x + 0.2, 0.1, z + 0.1}}};
    c.blocks.push_back(b);
  };
  add("a", 0.0, 0.0, true), add("b", 0.2, 0.0, true), add("c", 0.1, 0.1, false);
  return c;
}

std::map<std::string, double> areas_by_law(const Model& m) {
  std::map<std::string, double> areas;
  for (std::size_t i = 0; i < m.joint_law.size(); ++i)
    areas[m.laws[static_cast<std::size_t>(m.joint_law[i])].name] += m.assembly.joints[i].area;
  return areas;
}

}  // namespace

TEST_CASE("a block in halves is two elements, and the law between them is that of its material's inside") {
  const Case c = two_courses();
  const Model m = build_model(c);
  REQUIRE(m.blocks.size() == 5);
  CHECK(m.blocks[0].name == "a/1");
  CHECK(m.blocks[3].name == "b/2");
  CHECK(m.blocks[4].name == "c");
  for (std::size_t i = 0; i < 4; ++i) CHECK(m.assembly.elements[i].mass.volume == doctest::Approx(0.001).epsilon(1e-12));
  CHECK(m.assembly.elements[1].mass.centroid.x == doctest::Approx(0.15).epsilon(1e-12));
  const auto areas = areas_by_law(m);
  CHECK(areas.at("own") == doctest::Approx(2 * 0.01).epsilon(1e-12));               // two cuts
  CHECK(areas.at("mortar") == doctest::Approx(0.01 + 0.04 + 0.02).epsilon(1e-12));  // head joint, base, bed
}

TEST_CASE("blocks in halves are refused where two elements cannot stand for one") {
  const Case c = two_courses();
  const auto refused = [&](const std::function<void(Case&)>& change, const std::string& key, const std::string& says) {
    testing::check_refused(c, change, key, says);
  };
  refused([](Case& x) { x.materials["brick"].inside.reset(); }, "materials.brick.inside", "is missing");
  refused([](Case& x) { x.materials["brick"].inside = "glue"; }, "materials.brick.inside", "glue");
  refused([](Case& x) { x.blocks[0].fixed = true; }, "block[0].halves", "fixed");
  refused([](Case& x) { x.blocks[0].cells = CellCounts{2, 1, 1}; }, "block[0].cells", "does not go with halves");
  const auto cells = [&](const std::function<void(BlockSpec&)>& change, const std::string& says) {
    refused([&](Case& x) { x.blocks[2].cells = CellCounts{2, 2, 1}, change(x.blocks[2]); }, "block[2].cells", says);
  };
  cells([](BlockSpec& b) { b.fixed = true; }, "fixed");
  cells([](BlockSpec& b) { b.cells = CellCounts{2, 0, 1}; }, "0; allowed: three whole numbers from 1 to 16");
  cells([](BlockSpec& b) { b.cells = CellCounts{2, 1, 17}; }, "17; allowed");
  cells(
      [](BlockSpec& b) {
        b.box.reset(), b.extrude = {0.0, 0.1}, b.polygon = {{0.0, 0.1}, {0.2, 0.1}, {0.1, 0.2}};
      },
      "this polygon; allowed: a free box");
  cells(  // its far face and its top lean: a cut between the near and the far face would be warped
      [](BlockSpec& b) {
        b.box.reset();
        const auto at = [](double x, double y, double z) { return Vec3{0.1 + 0.2 * x, 0.1 * y, 0.1 + 0.1 * z}; };
        b.vertices = {at(0, 0, 0),
                      at(1, 0, 0),
                      at(0.7, 1, 0),
                      at(0, 1, 0),
                      at(0, 0, 1),
                      at(0.7 / 0.91, 0, 0.7 / 0.91),
                      at(0.4 / 0.91, 1, 1 - 0.12 / 0.91),
                      at(0, 1, 1)};
      },
      "not plane");
  refused([](Case& x) { x.blocks[2].name = "a/2"; }, "block[2].name", "already the name of block[0]");
  refused([](Case& x) { x.blocks[2].name = "b", x.blocks[1].name = "b/1", x.blocks[1].halves = false, x.blocks[2].halves = true; },
          "block[2].name", "already the name of block[1]");
  refused([](Case& x) { x.loads.emplace_back().block = "a/3"; }, "load[0].block", "there is no [[block]] named \"a/3\"");
  refused([](Case& x) { x.loads.emplace_back().block = "c/1"; }, "load[0].block", "there is no [[block]] named \"c/1\"");
  // The key of a block behind blocks in halves.
  refused([](Case& x) { (*x.blocks[2].box)[0].z = 0.05; }, "block[2]", "overlaps");
}

TEST_CASE("a load on a block in halves acts on the whole: force and moment in all are as given") {
  const Case c = two_courses();
  const Model m = build_model(c);
  Load load;
  load.block = "b", load.force = {10.0, -20.0, 30.0}, load.moment = {1.0, 2.0, 3.0};
  const auto resultant = [&](const std::vector<LoadShare>& shares) {
    Vec3 force, moment;  // about the origin
    for (const LoadShare& s : shares) {
      force += s.part * load.force;
      moment += s.part * load.moment + cross(s.point, s.part * load.force);
    }
    return std::pair{force, moment};
  };
  const auto is = [](Vec3 a, Vec3 b) { return norm(a - b) < 1e-12; };
  const auto middle = load_shares(m, load, 0);
  REQUIRE(middle.size() == 2);
  CHECK(is(resultant(middle).first, load.force));
  CHECK(is(resultant(middle).second, load.moment + cross(Vec3{0.3, 0.05, 0.05}, load.force)));
  load.at = Vec3{0.36, 0.02, 0.1};
  const auto at = load_shares(m, load, 0);
  REQUIRE(at.size() == 1);
  CHECK(m.blocks[static_cast<std::size_t>(at[0].element)].name == "b/2");
  CHECK(is(resultant(at).second, load.moment + cross(*load.at, load.force)));
  load.at->x = 0.3;  // between the two
  CHECK(m.blocks[static_cast<std::size_t>(load_shares(m, load, 0).at(0).element)].name == "b/1");
  load.block = "b/2", load.at.reset();
  const auto half = load_shares(m, load, 0);
  REQUIRE(half.size() == 1);
  CHECK(half[0].part == 1.0);
  CHECK(is(half[0].point, {0.35, 0.05, 0.05}));
}

TEST_CASE("a block in halves may be turned, and may move and spin: its halves move as one body") {
  Case c = two_courses();
  c.blocks.erase(c.blocks.begin() + 1, c.blocks.end());
  c.blocks[0].free = true;
  c.blocks[0].rotate = Rotation{{0, 0, 1}, 90.0, {0.1, 0.05, 0.05}};
  c.blocks[0].velocity = {1.0, 0.0, 0.0}, c.blocks[0].angular_velocity = {0.0, 0.0, 2.0};
  const Model m = build_model(c);
  REQUIRE(m.blocks.size() == 2);
  CHECK(norm(m.assembly.elements[0].mass.centroid - Vec3{0.1, 0.0, 0.05}) < 1e-12);
  CHECK(norm(m.assembly.elements[1].mass.centroid - Vec3{0.1, 0.1, 0.05}) < 1e-12);
  CHECK(norm(m.blocks[0].velocity - Vec3{1.1, 0.0, 0.0}) < 1e-12);
  CHECK(norm(m.blocks[1].velocity - Vec3{0.9, 0.0, 0.0}) < 1e-12);
  CHECK(m.blocks[1].angular_velocity == Vec3{0.0, 0.0, 2.0});
  const auto areas = areas_by_law(m);
  CHECK(areas.at("own") == doctest::Approx(0.01).epsilon(1e-9));
}

TEST_CASE("a block in cells has the mass, centroid and inertia of the whole, and the joints that counting gives") {
  for (const CellCounts n : {CellCounts{1, 1, 2}, CellCounts{2, 1, 2}, CellCounts{3, 2, 4}, CellCounts{5, 5, 5}}) {
    CAPTURE(product(n));
    for (const double turn : {0.0, 33.0}) {
      Case c = two_courses();
      c.blocks.resize(1);
      BlockSpec& b = c.blocks[0];
      b.halves = false, b.cells = n, b.free = true;
      b.box = {{Vec3{1.0, 0.7, 0.5}, Vec3{1.1, 0.5, 0.575}}};  // its length is along y
      if (turn != 0.0) b.rotate = Rotation{{1.0, 2.0, 3.0}, turn, {0.4, 0.2, 0.1}};
      Case w = c;
      w.blocks[0].cells.reset();
      const Model m = build_model(c), whole = build_model(w);
      const auto units = units_of(m);
      REQUIRE(units.size() == 1);
      const OfUnit& u = units.at(0);
      CHECK(u.cells == product(n));
      CHECK(u.joints == joints_in(n));
      const double length = 0.2, thickness = 0.1, height = 0.075;
      CHECK(
          u.area ==
          doctest::Approx((n[0] - 1) * thickness * height + (n[1] - 1) * length * height + (n[2] - 1) * length * thickness).epsilon(1e-9));
      const geometry::MassProperties& mass = whole.assembly.elements[0].mass;
      CHECK(u.volume == doctest::Approx(mass.volume).epsilon(1e-12));
      CHECK(norm(u.centroid - mass.centroid) < 1e-12);
      CHECK(size_of(u.inertia - mass.inertia) < 1e-12 * size_of(mass.inertia));
      const auto by_law = areas_by_law(m);
      if (product(n) > 1) CHECK(by_law.at("own") == doctest::Approx(u.area).epsilon(1e-12));
    }
  }
}

TEST_CASE("cells = [2, 1, 1] is what halves = true is, bit by bit") {
  for (const bool along_y : {false, true}) {
    Case c = two_courses();
    if (along_y) {
      for (BlockSpec& b : c.blocks)
        for (Vec3& corner : *b.box) std::swap(corner.x, corner.y);
    }
    Case d = c;
    for (BlockSpec& b : d.blocks)
      if (b.halves) b.halves = false, b.cells = CellCounts{2, 1, 1};
    const Model m = build_model(c), n = build_model(d);
    REQUIRE(m.blocks.size() == n.blocks.size());
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
      CHECK(m.blocks[i].name == n.blocks[i].name);
      CHECK(m.blocks[i].shape.vertices == n.blocks[i].shape.vertices);
      CHECK(m.blocks[i].shape.faces == n.blocks[i].shape.faces);
    }
    CHECK(m.joint_law == n.joint_law);
  }
}

TEST_CASE("cells of a voussoir: wedges that fill it, from a polygon of either winding") {
  Case c = two_courses();
  c.blocks.resize(1);
  BlockSpec& b = c.blocks[0];
  b.halves = false, b.box.reset(), b.free = true, b.cells = CellCounts{3, 2, 1};
  b.extrude = {0.0, 0.4};
  b.polygon = {{0.0, 1.0}, {0.3, 1.0}, {0.35, 1.5}, {-0.05, 1.5}};
  const Model m = build_model(c);
  CHECK(m.blocks.size() == 6);
  CHECK(volume_of(m) == doctest::Approx(0.4 * 0.5 * 0.5 * (0.3 + 0.4)).epsilon(1e-12));
  const auto cut = [](const Model& model) {  // width of the first cell's foot
    const auto [low, high] = geometry::bounds(model.blocks[0].shape);
    return Vec3{high.x - low.x, high.y - low.y, high.z - low.z};
  };
  CHECK(cut(m).x == doctest::Approx(0.2));
  CHECK(cut(m).z == doctest::Approx(0.5));
  std::reverse(b.polygon.begin() + 1, b.polygon.end());  // its first edge is now the upright one
  const Model turned = build_model(c);
  CHECK(cut(turned).x == doctest::Approx(0.2));
  CHECK(cut(turned).z == doctest::Approx(0.5 / 3.0));
  CHECK(volume_of(turned) == doctest::Approx(volume_of(m)).epsilon(1e-12));
}

TEST_CASE("loads and names of a block in cells are of the whole") {
  Case c = two_courses();
  c.blocks[2].cells = CellCounts{2, 2, 3};
  c.loads.emplace_back().block = "c", c.loads[0].force = {1.0, 0.0, 0.0};
  const Model m = build_model(c);
  CHECK(parts_named(m, "c").at(0).size() == 12);
  CHECK(parts_named(m, "c/12").at(0).size() == 1);
  const auto shares = load_shares(m, c.loads[0], 0);
  REQUIRE(shares.size() == 12);
  Vec3 moment;
  for (const LoadShare& s : shares) moment += cross(s.point - Vec3{0.2, 0.05, 0.15}, s.part * Vec3{1.0, 0.0, 0.0});
  CHECK(norm(moment) < 1e-12);
  testing::check_refused(c, std::function<void(Case&)>([](Case& x) { x.loads[0].block = "c/13"; }), "load[0].block",
                         "there is no [[block]] named \"c/13\"");
}
