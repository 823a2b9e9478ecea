// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// Houses of several storeys and rooms: thicknesses, openings, toothed junctions, and what is refused.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;
using testing::opening;

/// Outer size 2.4 x 1.6 m, walls 0.2 m thick, two storeys of 0.6 and 0.4 m, no roof.
Case two_storeys() {
  Case c = testing::paper_flat20();
  c.output.history.clear();
  c.house->inner_size = {2.0, 1.2};
  c.house->height = 0.6;
  c.house->openings.clear();
  c.house->roof.kind = RoofKind::none;
  c.house->storeys = {Storey{0.4, {}, {}}};
  return c;
}

InnerWall inner(std::string name, PlanAxis along, double at) {
  InnerWall wall;
  wall.name = std::move(name), wall.along = along, wall.at = at;
  return wall;
}

/// Box about the bricks with this tag.
geometry::Box3 box_of(const Model& m, const std::string& tag) {
  geometry::Polyhedron all;
  for (const Block& b : m.blocks)
    if (b.tag == tag) all.vertices.insert(all.vertices.end(), b.shape.vertices.begin(), b.shape.vertices.end());
  return geometry::bounds(all);
}

void check_box(const geometry::Box3& box, Vec3 low, Vec3 high) {
  CHECK(norm(box.low - low) < 1e-12);
  CHECK(norm(box.high - high) < 1e-12);
}

double volume(const Model& m) {
  double sum = 0.0;
  for (const geometry::Element& e : m.assembly.elements) sum += e.mass.volume;
  return sum;
}

/// Of the elements with this tag that reach into a box, the heights at which they begin, to the millimetre.
std::set<long> courses_in(const Model& m, const std::string& tag, const geometry::Box3& place) {
  std::set<long> heights;
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    const bool inside = box.low.x < place.high.x - 1e-9 && box.high.x > place.low.x + 1e-9 && box.low.y < place.high.y - 1e-9 &&
                        box.high.y > place.low.y + 1e-9;
    if (b.tag == tag && inside) heights.insert(std::lround(1e3 * box.low.z));
  }
  return heights;
}

}  // namespace

TEST_CASE("storeys: walls of one storey stand upon those of the other, outer faces flush") {
  Case c = two_storeys();
  c.house->bearing_wall = 0.4;
  c.house->storeys[0].bearing_wall = 0.2;
  const Model m = build_model(c);
  check_box(box_of(m, "front wall, storey 1"), {0, 0, 0}, {2.4, 0.4, 0.6});
  check_box(box_of(m, "front wall, storey 2"), {0, 0, 0.6}, {2.4, 0.2, 1.0});
  check_box(box_of(m, "rear wall, storey 2"), {0, 1.8, 0.6}, {2.4, 2.0, 1.0});
  check_box(box_of(m, "left wall, storey 2"), {0, 0, 0.6}, {0.2, 2.0, 1.0});
  CHECK(volume(m) == doctest::Approx((2 * 2.4 * 0.4 + 2 * 1.2 * 0.2) * 0.6 + (2 * 2.4 * 0.2 + 2 * 1.6 * 0.2) * 0.4).epsilon(1e-12));
}

TEST_CASE("storeys: an opening stands on the foot of its storey, and its courses go through all walls") {
  Case c = two_storeys();
  Opening window = opening("rear", 0.8, 0.6, 0.13, 0.12);
  window.storey = 2;
  c.house->openings = {window};
  const Model m = build_model(c);
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    const bool in_window = b.tag == "rear wall, storey 2" && box.low.x < 1.4 - 1e-9 && box.high.x > 0.8 + 1e-9;
    if (in_window) CHECK((box.high.z < 0.73 + 1e-9 || box.low.z > 0.85 - 1e-9));
  }
  CHECK(courses_in(m, "front wall, storey 2", {{0.4, 0, 0}, {0.5, 0.2, 2}}) == std::set<long>{600, 665, 730, 790, 850, 950});
}

TEST_CASE("inner walls: every second course goes through the wall that it meets or crosses") {
  Case c = two_storeys();
  c.house->inner_walls = {inner("middle", PlanAxis::y, 1.0), inner("long", PlanAxis::x, 0.7)};
  c.house->inner_walls[1].storeys = {1};
  const Model m = build_model(c);
  const std::set<long> even{0, 200, 400}, odd{100, 300, 500};
  const geometry::Box3 tee{{1.0, 0.0, 0.0}, {1.2, 0.2, 1.0}}, cross{{1.0, 0.7, 0.0}, {1.2, 0.9, 1.0}},
      side{{0.0, 0.7, 0.0}, {0.2, 0.9, 1.0}};
  CHECK(courses_in(m, "front wall, storey 1", tee) == even);
  CHECK(courses_in(m, "middle wall, storey 1", tee) == odd);
  CHECK(courses_in(m, "long wall, storey 1", cross) == even);
  CHECK(courses_in(m, "middle wall, storey 1", cross) == odd);
  CHECK(courses_in(m, "long wall, storey 1", side) == even);
  CHECK(courses_in(m, "left wall, storey 1", side) == odd);
  CHECK(courses_in(m, "middle wall, storey 2", tee) == std::set<long>{700, 900});
  CHECK(courses_in(m, "long wall, storey 2", {{-9, -9, -9}, {9, 9, 9}}).empty());
  const double outer = 2 * 2.4 * 0.2 + 2 * 1.2 * 0.2, middle = 1.2 * 0.2, along = 1.8 * 0.2;  // what crosses counted once
  CHECK(volume(m) == doctest::Approx((outer + middle + along) * 0.6 + (outer + middle) * 0.4).epsilon(1e-12));
}

TEST_CASE("inner walls: the bricks of a junction are bonded over half a brick") {
  Case c = two_storeys();
  c.house->inner_walls = {inner("middle", PlanAxis::y, 1.0)};
  const Model m = build_model(c);
  int beds = 0;
  for (const geometry::Joint& j : m.assembly.joints) {
    if (j.element_b == geometry::kBase || std::abs(j.frame().normal.z) < 0.5) continue;
    const std::string &a = m.blocks[static_cast<std::size_t>(j.element_a)].tag, &b = m.blocks[static_cast<std::size_t>(j.element_b)].tag;
    const bool of_both = (a.starts_with("front") && b.starts_with("middle")) || (a.starts_with("middle") && b.starts_with("front"));
    if (!of_both) continue;
    ++beds;
    CHECK(m.blocks[static_cast<std::size_t>(j.element_a)].house == 0);
  }
  CHECK(beds > 8);  // nine beds between ten courses, with one brick or two in each
}

TEST_CASE("storeys and inner walls: what is refused") {
  const Case c = two_storeys();
  const auto middle = [](House& h) -> InnerWall& { return h.inner_walls.emplace_back(inner("middle", PlanAxis::y, 1.0)); };
  using Change = std::function<void(House&)>;
  check_refused(c, Change([](House& h) { h.storeys[0].height = -1.0; }), "house.storey[0].height", "allowed: above 0");
  check_refused(c, Change([](House& h) { h.storeys[0].height = 0.03; }), "house.storey[0].height", "nearest");
  check_refused(c, Change([](House& h) { h.storeys[0].bearing_wall = 0.4; }), "house.storey[0].bearing_wall",
                "0.4 m is thicker than the wall below; at most 0.2 m");
  check_refused(c, Change([](House& h) { h.storeys[0].nonbearing_wall = 0.05; }), "house.storey[0].nonbearing_wall",
                "two thirds of a brick");
  check_refused(c, Change([](House& h) { h.openings = {opening("front", 0.6, 0.6, 0.0, 0.2)}, h.openings[0].storey = 3; }),
                "house.opening[0].storey", "there is no storey 3; allowed: 1 to 2");
  check_refused(c, Change([](House& h) { h.openings = {opening("front", 0.6, 0.6, 0.0, 0.5)}, h.openings[0].storey = 2; }),
                "house.opening[0].height", "at most 0.4 m");
  check_refused(c, Change([&](House& h) { middle(h).at = 0.25; }), "house.inner_wall[0].at", "allowed: 0.3 to 1.9 m");
  check_refused(c, Change([&](House& h) { middle(h), middle(h).name = "other", h.inner_walls[1].at = 1.25; }), "house.inner_wall[1].at",
                "is too near to house.inner_wall[0]; allowed: at most 0.7 m, or 1.3 m and more");
  check_refused(c, Change([&](House& h) { middle(h).name = "front"; }), "house.inner_wall[0].name", "the name of an outer wall");
  check_refused(c, Change([&](House& h) { middle(h), middle(h).at = 0.5; }), "house.inner_wall[1].name", "already the name of");
  check_refused(c, Change([&](House& h) { middle(h).thickness = 0.05; }), "house.inner_wall[0].thickness", "two thirds of a brick");
  check_refused(c, Change([&](House& h) { middle(h).storeys = {3}; }), "house.inner_wall[0].storeys[0]", "allowed: 1 to 2");
  check_refused(c, Change([&](House& h) { middle(h), h.openings = {opening("front", 0.6, 0.6, 0.0, 0.2)}; }), "house.opening[0].from",
                "where the middle wall meets the front wall, from 1 to 1.2 m");
  check_refused(c, Change([&](House& h) { middle(h), h.openings = {opening("north", 0.6, 0.6, 0.0, 0.2)}; }), "house.opening[0].wall",
                "\"north\" is no wall of storey 1; allowed: front, rear, left, right, middle");
  check_refused(c, Change([](House& h) { h.reinforcement = Reinforcement{}; }), "house.reinforcement", "of one storey and one room");
}

}  // namespace voussoir
