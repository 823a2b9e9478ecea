// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/solids/halves.h"

#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "cases/loads/loads.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;

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
