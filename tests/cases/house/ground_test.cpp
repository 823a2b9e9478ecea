// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/census.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_joint_areas;
using voussoir::testing::check_no_slivers;
using voussoir::testing::check_nothing_unjoined;

// Parts of the base: walls of a house on several levels, and ground that moves.
namespace {

/// The right part of the house, 2.6 m of its 5.4 m, stands 0.6 m higher.
Case on_two_levels() {
  Case c = testing::paper_flat20();
  c.house->openings.clear();
  BasePart part;
  part.x = {2.8, 6.0};
  part.y = {-1.0, 5.0};
  part.level = 0.6;
  c.base->parts = {part};
  return c;
}

double lowest(const Model& m, double x) {
  double low = 1e9;
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (b.ground < 0 && box.low.x < x && x < box.high.x) low = std::min(low, box.low.z);
  }
  return low;
}

double mass_without_ground(const Model& m) {
  double mass = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].ground < 0)
      mass += m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density * m.assembly.elements[i].mass.volume;
  }
  return mass;
}

void change(Case& c, const std::function<void(BasePart&)>& what) { what(c.base->parts[0]); }

void refused(const std::function<void(BasePart&)>& what, const std::string& key, const std::string& says) {
  testing::check_refused(
      on_two_levels(), [&](Case& c) { change(c, what); }, key, says);
}

}  // namespace

TEST_CASE("walls begin upon the part of the base that they stand on") {
  for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
    CAPTURE(turn);
    Case c = on_two_levels();
    Case flat = c;
    flat.base->parts.clear();
    const double whole = mass_without_ground(build_model(flat));
    // The same part of the house, wherever it stands.
    c.house->turn = turn, c.house->origin = {1.25, -0.5};
    const std::array<std::array<double, 4>, 4> places{
        {{2.8, 6.0, -1.0, 5.0}, {-5.0, 1.0, 2.8, 6.0}, {-6.0, -2.8, -5.0, 1.0}, {-1.0, 5.0, -6.0, -2.8}}};
    const auto& p = places[static_cast<std::size_t>(turn / 90.0)];
    c.base->parts[0].x = {p[0] + 1.25, p[1] + 1.25}, c.base->parts[0].y = {p[2] - 0.5, p[3] - 0.5};
    c.base->z = 0.3;
    const Model m = build_model(c);
    if (turn == 0.0) {
      CHECK(lowest(m, 1.25 + 2.66) == doctest::Approx(0.3));
      CHECK(lowest(m, 1.25 + 2.97) == doctest::Approx(0.9));
      CHECK(lowest(m, 1.25 + 5.33) == doctest::Approx(0.9));
    }
    // 2.6 m of two bearing walls and one other wall between them, 0.2 m thick, 0.6 m high.
    const double gone = 1800.0 * 0.6 * 0.2 * (2 * 2.6 + 3.0);
    CHECK(std::abs(mass_without_ground(m) / (whole - gone) - 1.0) < 1e-9);
    check_joint_areas(m);
    check_nothing_unjoined(m);
    check_no_slivers(m, *c.house);
    // All that touches ground has the law of the bricks, and the ground has no points of its own.
    const auto ground = static_cast<std::int32_t>(m.blocks.size()) - 1;
    int beneath = 0, beside = 0;
    for (std::size_t k = 0; k < m.assembly.joints.size(); ++k) {
      const geometry::Joint& j = m.assembly.joints[k];
      CHECK(j.element_a != ground);
      if (j.element_b != ground) continue;
      CHECK(j.merged);
      CHECK(j.side_b.empty());
      CHECK(m.laws[static_cast<std::size_t>(m.joint_law[k])].name == "normal");
      ++(std::abs(j.frame().normal.z) > 0.5 ? beneath : beside);
    }
    CHECK(beneath > 50);
    CHECK(beside > 10);
  }
}

TEST_CASE("a part under a wall by its name is the rectangle of that wall") {
  Case by_name = on_two_levels(), by_place = on_two_levels();
  by_name.base->parts[0] = {.x = {}, .y = {}, .wall = "rear", .from = 1.0, .to = 3.0, .level = 0.2, .motion = {}};
  by_place.base->parts[0] = {.x = {{1.0, 3.0}}, .y = {{3.2, 3.4}}, .wall = "", .from = {}, .to = {}, .level = 0.2, .motion = {}};
  const Model a = build_model(by_name), b = build_model(by_place);
  REQUIRE(a.blocks.size() == b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    const geometry::Box3 p = geometry::bounds(a.blocks[i].shape), q = geometry::bounds(b.blocks[i].shape);
    CHECK(norm(p.low - q.low) + norm(p.high - q.high) < 1e-12);
  }
}

TEST_CASE("parts of the base beside each other share no joint, nor have they one with the base") {
  Case c = on_two_levels();
  BasePart second = c.base->parts[0];
  second.x = {-1.0, 2.8}, second.level = 0.3;
  second.motion.emplace().velocity = Vec3{0.0, 0.0, -0.001};
  c.base->parts.push_back(second);
  const Model m = build_model(c);
  const auto n = static_cast<std::int32_t>(m.blocks.size());
  REQUIRE(m.support_motions.size() == 1);
  CHECK(m.blocks.back().support_motion == 0);
  CHECK(m.blocks.back().fixed);
  for (const geometry::Joint& j : m.assembly.joints) {
    CHECK(j.element_a < n - 2);
    CHECK(j.element_b != geometry::kBase);
  }
  c.base->parts[1].motion = SupportMotion{.to = Vec3{0.0, 0.0, -0.02}};
  CHECK(build_model(c).support_motions[0].displacement.back() == Vec3{0.0, 0.0, -0.02});
}

TEST_CASE("parts of the base that make no sense are refused by name") {
  refused([](BasePart& p) { p.level = 0.0; }, "base.part[0].level", "0 m is out of range; allowed: above 0");
  refused([](BasePart& p) { p.level = 2.4; }, "base.part[0].level", "leaves no course of the first storey (2.4 m); at most 2.35 m");
  refused([](BasePart& p) { p.level = 0.03; }, "base.part[0].level", "0.03 m needs a bed joint at 0.03 m");
  refused([](BasePart& p) { p.x = {2.85, 2.8}; }, "base.part[0].x", "[2.85, 2.8] m is no length");
  refused([](BasePart& p) { p.y.reset(); }, "base.part[0].y", "is missing; a rectangle needs both");
  refused([](BasePart& p) { p.wall = "front"; }, "base.part[0]", "lies in a rectangle and under a wall");
  refused([](BasePart& p) { p.x.reset(), p.y.reset(); }, "base.part[0]", "has no place; give x and y, or wall");
  refused([](BasePart& p) { p.from = 1.0; }, "base.part[0].from", "goes with wall");
  refused([](BasePart& p) { p.x.reset(), p.y.reset(), p.wall = "north"; }, "base.part[0].wall",
          "\"north\" is no wall of the house; allowed: front, rear");
  refused([](BasePart& p) { p.x.reset(), p.y.reset(), p.wall = "front", p.to = 5.5; }, "base.part[0].to",
          "5.5 m is beyond the end of the front wall; at most 5.4 m");
  refused([](BasePart& p) { p.x.reset(), p.y.reset(), p.wall = "front", p.from = 3.0, p.to = 2.0; }, "base.part[0].from",
          "3 m; allowed: 0 to below 2 m");
  refused(
      [](BasePart& p) {
        p.x = {5.3, 6.0};
      },
      "base.part[0]", "ends within the thickness of the right wall, which stands from 5.2 to 5.4 m along x");
  refused([](BasePart& p) { p.y = {-1.0, 0.1}; }, "base.part[0]", "ends within the thickness of the front wall");
  refused([](BasePart& p) { p.x = {0.25, 6.0}; }, "base.part[0]", "leaves a piece of the front wall");
  refused([](BasePart& p) { p.y = {1.0, 2.0}, p.x = {1.0, 2.0}; }, "base.part[0]", "no wall stands on it");
  refused([](BasePart& p) { p.motion.emplace(); }, "base.part[0].motion", "give exactly one of: velocity; file; to, turn or both");
  testing::check_refused(
      on_two_levels(), [](Case& c) { c.base->parts.push_back(c.base->parts[0]); }, "base.part[1]", "overlaps base.part[0], x [2.8, 6] m");
  testing::check_refused(
      on_two_levels(),
      [](House& h) {
        h.copies = {2, 1};
      },
      "house.copies", "does not go with base.part");
  testing::check_refused(
      on_two_levels(), [](House& h) { h.openings = {testing::opening("front", 3.4, 1.0, 0.5, 1.0)}; }, "house.opening[0]",
      "overlaps base.part[0]");
  testing::check_refused(
      on_two_levels(),
      [](Case& c) {
        c.house.reset(), c.base->parts[0].x.reset(), c.base->parts[0].y.reset(), c.base->parts[0].wall = "front";
        BlockSpec stone;
        stone.name = "stone", stone.material = "adobe", stone.box = {{{0, 0, 0}, {1, 1, 1}}};
        c.blocks = {stone};
      },
      "base.part[0].wall", "the case has no [house]");
}

TEST_CASE("ground: a corner beside a door settles on parts that leave the doorway out; one that fills it is refused with that advice") {
  Case c = testing::paper_flat20();  // door from 1.0 to 2.2 m
  const auto part = [&](double x0, double x1, double y0, double y1) {
    BasePart p;
    p.x = {x0, x1}, p.y = {y0, y1}, p.level = 0.1;
    c.base->parts.push_back(p);
  };
  part(0.0, 1.0, 0.0, 1.2), part(2.2, 6.0, 0.0, 1.2), part(0.0, 6.0, 1.2, 4.0);
  const Model m = build_model(c);
  CHECK(lowest(m, 0.5) == doctest::Approx(0.1));
  CHECK(lowest(m, 4.0) == doctest::Approx(0.1));
  check_nothing_unjoined(m);
  testing::check_refused(
      c,
      [](Case& k) {
        k.base->parts[1].x = {1.0, 6.0};
      },
      "house.opening[0]", "; end base.part[1] beside the opening (leave the doorway out), or give the opening a sill of at least 0.1 m");
}
