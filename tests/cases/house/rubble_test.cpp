// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "cases/census.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/house/house_mass.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_joint_areas;
using voussoir::testing::check_nothing_unjoined;

// Rubble: random convex stones that fill the walls.
namespace {

Case of_rubble(int seed) {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.bond = Bond::rubble;
  h.rubble = Rubble{seed, 0.8, 0.2};
  return c;
}

std::uint64_t hash_of(const Model& m) {
  std::uint64_t hash = 1469598103934665603ULL;
  const auto add = [&](double v) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    hash = (hash ^ bits) * 1099511628211ULL;
  };
  for (const Block& b : m.blocks)
    for (const Vec3& v : b.shape.vertices) add(v.x), add(v.y), add(v.z);
  return hash;
}

bool is_stone(const Block& b) { return b.kind == PartKind::brick; }

void check_whole(const Case& c, const Model& m) {
  CHECK(std::abs(census(m).mass / testing::expected_mass(*c.house, c) - 1.0) < 1e-9);
  check_joint_areas(m);
  check_nothing_unjoined(m);
}

}  // namespace

TEST_CASE("rubble fills walls, corners, openings and lintels without gaps") {
  for (const int seed : {1, 2, 3}) {
    CAPTURE(seed);
    const Case c = of_rubble(seed);
    const Model m = build_model(c);
    check_whole(c, m);
    int hexagons = 0, stones = 0, askew = 0;
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
      if (!is_stone(m.blocks[i])) continue;
      ++stones;
      hexagons += m.blocks[i].shape.faces.size() > 6 ? 1 : 0;
      const geometry::Element& e = m.assembly.elements[i];
      for (std::int32_t f = e.first_face; f < e.first_face + e.face_count; ++f) {
        const Vec3 n = m.assembly.faces[static_cast<std::size_t>(f)].normal;
        const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        askew += most < 1.0 - 1e-9 ? 1 : 0;
        CHECK(most > 0.9);  // beds and joints lean a little
      }
    }
    CHECK(hexagons > stones / 2);
    CHECK(askew > 2 * stones);
  }
}

TEST_CASE("a seed gives the same stones in the same bits, another seed others") {
  const std::uint64_t one = hash_of(build_model(of_rubble(1)));
  CHECK(one == hash_of(build_model(of_rubble(1))));
  CHECK(one != hash_of(build_model(of_rubble(2))));
  CHECK(one == 10421751039533072109ULL);  // on any machine: whole numbers alone
}

TEST_CASE("rubble goes with all that walls have") {
  Case c = of_rubble(4);
  House& h = *c.house;
  h.bearing_wall = 0.4;
  h.height = 1.6;
  h.storeys = {Storey{1.2, 0.3, {}}};
  h.openings = {testing::opening("front", 1.0, 0.8, 0.0, 1.0), testing::opening("left", 1.2, 0.6, 0.4, 0.5),
                testing::opening("middle", 1.5, 0.8, 0.0, 1.2)};
  h.openings[0].arch = Arch{0.2, 0.2, 0.2, {}, {}};
  h.openings[2].storey = 1;
  h.inner_walls = {InnerWall{"middle", PlanAxis::y, 2.6, 0.2, {}}};
  h.piers = {Pier{"rear", 1.2, 0.4, 0.4, 1.2}};
  Floor floor;
  floor.beam = {0.12, 0.2}, floor.spacing = 0.5;
  h.floors = {floor};
  h.roof = {};
  h.roof.kind = RoofKind::pitched;
  Leaves leaves;
  leaves.walls = {"front", "rear"};
  leaves.joint = "weak";
  leaves.through = ThroughStones{0.8, 3, {}};
  for (const bool two : {false, true}) {
    CAPTURE(two);
    if (two) h.leaves = leaves;
    const Model m = build_model(c);
    check_whole(c, m);
    int collar = 0, through = 0;
    for (std::size_t k = 0; k < m.assembly.joints.size(); ++k)
      collar += m.laws[static_cast<std::size_t>(m.joint_law[k])].name == "weak" ? 1 : 0;
    for (const Block& b : m.blocks) {
      const geometry::Box3 box = geometry::bounds(b.shape);
      through += is_stone(b) && b.tag == "rear wall, storey 1" && box.high.y - box.low.y > 0.399 ? 1 : 0;
    }
    CHECK((collar > 50) == two);
    CHECK(through > 5);
  }
}

TEST_CASE("upright joints of rubble do not run through two courses") {
  const Model m = build_model(of_rubble(5));
  int near = 0, joints = 0;
  for (const geometry::Joint& a : m.assembly.joints) {
    if (a.element_b < 0) continue;
    const Block &x = m.blocks[static_cast<std::size_t>(a.element_a)], &y = m.blocks[static_cast<std::size_t>(a.element_b)];
    if (x.tag != "rear wall" || y.tag != "rear wall" || std::abs(a.frame().normal.z) < 0.9) continue;
    ++joints;
    const geometry::Box3 p = geometry::bounds(x.shape), q = geometry::bounds(y.shape);
    near += std::min(p.high.x, q.high.x) - std::max(p.low.x, q.low.x) < 0.03 ? 1 : 0;
  }
  CHECK(joints > 200);
  CHECK(near < joints / 20);
}

TEST_CASE("keys of rubble that make no sense are refused by name") {
  const Case c = of_rubble(1);
  testing::check_refused(
      c, [](House& h) { h.rubble->irregularity = 1.5; }, "house.rubble.irregularity", "1.5; allowed: 0 to 1");
  testing::check_refused(
      c, [](House& h) { h.rubble->through = -0.1; }, "house.rubble.through", "-0.1; allowed: 0 to 1");
  testing::check_refused(
      c, [](House& h) { h.halves = true; }, "house.halves", "true does not go with bond = \"rubble\"");
}
