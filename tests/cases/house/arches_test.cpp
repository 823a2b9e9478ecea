// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/census.h"
#include "geometry/prism.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/house/house_mass.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_joint_areas;
using voussoir::testing::check_no_slivers;
using voussoir::testing::check_nothing_unjoined;

// Arches over openings: voussoirs that fill a rectangle of the wall above the soffit.
namespace {

Case with_arch(const std::string& wall, double width, const Arch& arch, bool lintel = false) {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.roof = {};
  h.openings = {testing::opening(wall, 1.0, width, 0.0, 1.2)};
  h.openings[0].arch = arch;
  if (lintel) h.openings[0].lintel = Lintel{width + 0.4, 0.1, 0.2};
  return c;
}

std::vector<std::size_t> voussoirs_of(const Model& m) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < m.blocks.size(); ++i)
    if (m.blocks[i].kind == PartKind::arch_stone) all.push_back(i);
  return all;
}

Arch arch_of(double rise, double thickness, double springer) { return {rise, thickness, springer, {}, {}}; }

}  // namespace

TEST_CASE("an arch fills its frame but for the room under the soffit") {
  struct Shape {
    double width, rise, thickness, springer;
  };
  const std::vector<Shape> shapes{{0.8, 0.0, 0.2, 0.1},     {0.8, 0.1, 0.2, 0.2}, {0.8, 0.4, 0.2, 0.2},
                                  {0.61, 0.23, 0.17, 0.15}, {1.0, 0.5, 0.1, 0.1}, {1.2, 0.05, 0.3, 0.3}};
  for (const char* wall : {"front", "rear", "left", "right"}) {
    for (const Shape& s : shapes) {
      CAPTURE(wall);
      CAPTURE(s.width);
      CAPTURE(s.rise);
      for (const bool lintel : {false, true}) {
        const Case c = with_arch(wall, s.width, arch_of(s.rise, s.thickness, s.springer), lintel);
        const Model m = build_model(c);
        CHECK(std::abs(census(m).mass / testing::expected_mass(*c.house, c) - 1.0) < 1e-9);
        check_joint_areas(m);
        check_nothing_unjoined(m);
        check_no_slivers(m, *c.house);
        for (const std::size_t i : voussoirs_of(m)) {
          CHECK(geometry::is_prism(m.blocks[i].shape));
          CHECK(m.blocks[i].tag == std::string(wall) + " wall");
        }
      }
    }
  }
}

TEST_CASE("each voussoir meets the next over its whole joint, and the soffit lies on its circle") {
  Arch arch = arch_of(0.25, 0.2, 0.2);
  arch.voussoirs = 9;
  const Case c = with_arch("front", 1.0, arch);
  const Model m = build_model(c);
  const std::vector<std::size_t> all = voussoirs_of(m);
  REQUIRE(all.size() == 11);  // nine and two springers, one row through a wall of 0.2 m
  int joints = 0;
  for (const geometry::Joint& j : m.assembly.joints) {
    const bool a = std::ranges::count(all, static_cast<std::size_t>(j.element_a)) > 0;
    const bool b = j.element_b >= 0 && std::ranges::count(all, static_cast<std::size_t>(j.element_b)) > 0;
    if (!a || !b) continue;
    ++joints;
    const auto area = [&](std::int32_t e, std::int32_t f) {
      return m.assembly.faces[static_cast<std::size_t>(m.assembly.elements[static_cast<std::size_t>(e)].first_face + f)].area;
    };
    CHECK(std::abs(j.area / area(j.element_a, j.face_a) - 1.0) < 1e-9);
    CHECK(std::abs(j.area / area(j.element_b, j.face_b) - 1.0) < 1e-9);
  }
  CHECK(joints == 10);
  const double radius = (0.5 * 0.5 + 0.25 * 0.25) / (2 * 0.25);
  int on_soffit = 0;
  for (const std::size_t i : all)
    for (const Vec3& v : m.blocks[i].shape.vertices)
      on_soffit += std::abs(std::hypot(v.x - 1.5, v.z - (1.2 + 0.25 - radius)) - radius) < 1e-9 ? 1 : 0;
  CHECK(on_soffit >= 2 * 2 * 9 + 4);
}

TEST_CASE("arches that cannot be built are refused by name") {
  const Case c = with_arch("front", 0.8, arch_of(0.1, 0.2, 0.2));
  const auto refused = [&](const std::function<void(Arch&)>& change, const std::string& key, const std::string& says) {
    testing::check_refused(
        c, [&](House& h) { change(*h.openings[0].arch); }, "house.opening[0].arch." + key, says);
  };
  refused([](Arch& a) { a.rise = 0.41; }, "rise", "0.41 m; allowed: 0 (a flat arch) to 0.4 m, half the width");
  refused([](Arch& a) { a.rise = -0.1; }, "rise", "-0.1 m; allowed: 0");
  refused([](Arch& a) { a.thickness = 0.04; }, "thickness", "0.04 m is less than half a course; at least 0.05 m");
  refused([](Arch& a) { a.thickness = 1.2; }, "thickness", "1.2 m ends at 2.5 m, over the height of the wall (2.4 m)");
  refused([](Arch& a) { a.springer = 0.05; }, "springer", "0.05 m is less than half a brick; at least 0.1 m");
  refused([](Arch& a) { a.springer = 0.9; }, "springer", "0.9 m makes the arch reach from 0.1 to 2.7 m, into a corner of the front wall");
  refused([](Arch& a) { a.springer = 0.75; }, "springer", "leaves a piece of the front wall 0.05 m long");
  refused([](Arch& a) { a.voussoirs = 2; }, "voussoirs", "2 voussoirs; allowed: 3 to 16");
  refused([](Arch& a) { a.voussoirs = 17; }, "voussoirs", "each at least half a course wide");
  refused([](Arch& a) { a.material = "marble"; }, "material", "unknown material \"marble\"");
  testing::check_refused(
      c, [](House& h) { h.openings.push_back(testing::opening("front", 1.9, 0.5, 1.3, 0.5)); }, "house.opening[1]",
      "overlaps house.opening[0].arch");
}
