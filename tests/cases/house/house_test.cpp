// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "cases/house/house_wall.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

constexpr double kTight = 1e-9;

House plain_house() {
  House house;
  house.roof.kind = RoofKind::none;
  return house;
}

std::vector<NamedMaterial> materials() { return {{"adobe", {1800.0, 9.8e7, 0.25}}, {"wood", {700.0, 6.3e8, 0.3}}}; }

std::vector<Block> built(const House& house) { return build_house(house, materials()); }

double volume(const std::vector<Block>& blocks) {
  double sum = 0.0;
  for (const Block& b : blocks) sum += geometry::mass_properties(b.shape).volume;
  return sum;
}

double masonry_volume(const House& h) {
  const double outer_x = h.inner_size[0] + 2 * h.nonbearing_wall;
  double v = (2 * outer_x * h.bearing_wall + 2 * h.inner_size[1] * h.nonbearing_wall) * h.height;
  for (const Opening& o : h.openings) {
    const bool bearing = o.wall == "front" || o.wall == "rear";
    v -= o.width * o.height * (bearing ? h.bearing_wall : h.nonbearing_wall);
  }
  return v;
}

/// Blocks of one wall whose lowest point is at z.
std::vector<geometry::Box3> course(const std::vector<Block>& blocks, const std::string& tag, double z) {
  std::vector<geometry::Box3> boxes;
  for (const Block& b : blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (b.tag == tag && std::abs(box.low.z - z) < kTight) boxes.push_back(box);
  }
  return boxes;
}

std::set<long> joints_along_x(const std::vector<geometry::Box3>& boxes) {
  std::set<long> places;  // mm
  for (const geometry::Box3& b : boxes) places.insert({std::lround(b.low.x * 1000), std::lround(b.high.x * 1000)});
  return places;
}

std::vector<double> lengths_mm(const std::vector<Interval>& pieces) {
  std::vector<double> result;
  for (const Interval p : pieces) result.push_back(metres(p.length()) * 1000);
  return result;
}

std::vector<double> divided_mm(double low, double high, double unit, double offset) {
  return lengths_mm(divide({ticks(low), ticks(high)}, {{}, ticks(unit), ticks(offset)}, ticks(0.2)));
}

/// Transverse joints of a layer through the depth of a wall, as (depth cell of half a brick width, place), away from its ends.
std::set<std::pair<Tick, Tick>> upright_joints(const HousePlan& plan, const WallPlan& wall, int number) {
  std::set<std::pair<Tick, Tick>> joints;
  const Tick margin = 2 * plan.brick_length;
  for (const LaidBrick& b : lay_course({}, plan, wall, number)) {
    if (b.along.low < margin || b.along.low > wall.length - margin) continue;
    for (Tick d = b.depth.low; d < b.depth.high; d += plan.brick_width / 2) joints.insert({d, b.along.low});
  }
  return joints;
}

}  // namespace

TEST_CASE("a span is divided at the grid and keeps no piece under half a brick") {
  using List = std::vector<double>;
  CHECK(divided_mm(0.0, 0.8, 0.2, 0.0) == List{200, 200, 200, 200});
  CHECK(divided_mm(0.2, 1.05, 0.2, 0.05) == List{150, 100, 200, 200, 200});  // 0.05 + 0.2: 0.15 at the edge and 0.10
  CHECK(divided_mm(0.45, 1.1, 0.2, 0.05) == List{200, 200, 100, 150});       // the same at the other end
  CHECK(divided_mm(0.2, 0.85, 0.2, 0.05) == List{150, 100, 200, 200});
  CHECK(divided_mm(0.25, 1.0, 0.2, 0.05) == List{200, 200, 200, 150});  // a leftover of 0.15 stays
  CHECK(divided_mm(0.2, 0.5, 0.1, 0.05) == List{150, 150});             // 0.05 + 0.1: one piece of 0.15
  CHECK(divided_mm(0.2, 0.5, 0.2, 0.05) == List{150, 150});             // leftovers at both ends of one stretcher
  CHECK(divided_mm(0.2, 0.3, 0.2, 0.05) == List{100});
  CHECK(divided_mm(0.1, 0.2, 0.1, 0.05) == List{100});            // two leftovers make one piece
  CHECK(divided_mm(-0.3, 0.2, 0.2, 0.0) == List{100, 200, 200});  // the grid goes on below zero
}

TEST_CASE("pieces of any span fill it and are between half a brick and a brick long") {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Tick low = std::uniform_int_distribution<Tick>(0, ticks(1.0))(random);
    const Tick high = low + ticks(0.1) + std::uniform_int_distribution<Tick>(0, ticks(1.2))(random);
    const Tick unit = i % 2 == 0 ? ticks(0.2) : ticks(0.1);
    const std::vector<Interval> pieces = divide({low, high}, {{}, unit, ticks(0.05)}, ticks(0.2));
    REQUIRE(pieces.front().low == low);
    REQUIRE(pieces.back().high == high);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      REQUIRE(pieces[k].length() >= ticks(0.1));
      REQUIRE(pieces[k].length() <= ticks(0.2));
      if (k > 0) REQUIRE(pieces[k].low == pieces[k - 1].high);
    }
  }
}

TEST_CASE("timber members are cut into elements without slivers") {
  using List = std::vector<double>;
  const auto cut = [](double length) { return lengths_mm(cut_member({0, ticks(length)}, ticks(0.2))); };
  CHECK(cut(1.4) == List(7, 200.0));
  CHECK(cut(0.5) == List{200, 200, 100});
  CHECK(cut(0.46) == List{200, 130, 130});
  CHECK(cut(0.15) == List{150});
}

TEST_CASE("English bond: headers over stretchers, a quarter brick apart, from the outer corner") {
  const std::vector<Block> blocks = built(plain_house());
  const std::vector<geometry::Box3> even = course(blocks, "front wall", 0.2);
  const std::vector<geometry::Box3> odd = course(blocks, "front wall", 0.3);
  REQUIRE(even.size() == 54);  // 5.4 m of headers
  for (std::size_t i = 0; i < even.size(); ++i) {
    CHECK(even[i].low.x == doctest::Approx(0.1 * static_cast<double>(i)));
    CHECK(even[i].high.y == doctest::Approx(0.2));
  }
  std::set<long> expected{200, 350, 450};
  for (long x = 650; x < 5200; x += 200) expected.insert(x);
  expected.insert(5200);
  CHECK(joints_along_x(odd) == expected);
  CHECK(odd.size() == 2 * (expected.size() - 1));
}

TEST_CASE("corners are toothed: bearing walls run through even courses, the others through odd ones") {
  const std::vector<Block> blocks = built(plain_house());
  for (int k = 0; k < 24; ++k) {
    const double z = 0.1 * k;
    const bool even = k % 2 == 0;
    for (const char* wall : {"front wall", "rear wall"}) {
      const std::set<long> places = joints_along_x(course(blocks, wall, z));
      CHECK(*places.begin() == (even ? 0 : 200));
      CHECK(*places.rbegin() == (even ? 5400 : 5200));
    }
    for (const char* wall : {"left wall", "right wall"}) {
      double low = 10.0;
      for (const geometry::Box3& b : course(blocks, wall, z)) low = std::min(low, b.low.y);
      CHECK(low == doctest::Approx(even ? 0.2 : 0.0));
    }
  }
}

TEST_CASE("running bond: stretchers in two wythes, every second course half a brick off") {
  House house = plain_house();
  house.bond = Bond::running;
  const std::vector<Block> blocks = built(house);
  const std::vector<geometry::Box3> even = course(blocks, "front wall", 0.0);
  CHECK(even.size() == 2 * 27);
  CHECK(std::all_of(even.begin(), even.end(), [](const geometry::Box3& b) { return std::abs(b.high.y - b.low.y - 0.1) < kTight; }));
  const std::set<long> odd = joints_along_x(course(blocks, "front wall", 0.1));
  CHECK(odd.count(300) == 1);
  CHECK(odd.count(400) == 0);
  CHECK(odd.count(500) == 1);
}

TEST_CASE("a 0.4 m wall is stretcher, header core, stretcher over two headers") {
  const HousePlan plan = plan_house(testing::paper_flat40().house.value());
  const std::vector<Wythe> odd = wythes(plan, ticks(0.4), 1);
  REQUIRE(odd.size() == 3);
  CHECK(odd[0].depth == Interval{0, ticks(0.1)});
  CHECK(odd[1].depth == Interval{ticks(0.1), ticks(0.3)});
  CHECK(odd[1].unit == ticks(0.1));
  CHECK(odd[1].offset == ticks(0.05));
  CHECK(odd[2].depth == Interval{ticks(0.3), ticks(0.4)});
  const std::vector<Wythe> even = wythes(plan, ticks(0.4), 0);
  REQUIRE(even.size() == 2);
  CHECK(even[1].depth == Interval{ticks(0.2), ticks(0.4)});
}

TEST_CASE("no upright joint runs through two courses, whatever the thickness and bond") {
  for (const Bond bond : {Bond::english, Bond::running, Bond::flemish}) {
    for (int n = 1; n <= 6; ++n) {
      CAPTURE(n);
      House house = plain_house();
      house.bond = bond;
      house.bearing_wall = 0.1 * n;
      const HousePlan plan = plan_house(house);
      const WallPlan& wall = plan.walls[0];
      Tick depth = 0;
      for (const Wythe& w : wythes(plan, wall.thickness, 0)) depth += w.depth.length();
      CHECK(depth == wall.thickness);
      const auto lower = upright_joints(plan, wall, 0);
      const auto upper = upright_joints(plan, wall, 1);
      for (const auto& joint : lower) CHECK(upper.count(joint) == 0);
    }
  }
}

TEST_CASE("no upright joint runs through two courses beside an opening, wherever it stands") {
  for (const Bond bond : {Bond::english, Bond::running, Bond::flemish}) {
    for (const double from : {1.0, 1.01, 1.03, 1.05, 1.07, 1.09, 1.1, 1.15}) {
      CAPTURE(from);
      House house = *testing::paper_flat20().house;
      house.bond = bond;
      house.openings[0].from = from;
      const HousePlan plan = plan_house(house);
      const WallPlan& wall = plan.walls[0];
      for (int course = 0; course < 6; ++course) {
        const auto lower = upright_joints(plan, wall, course), upper = upright_joints(plan, wall, course + 1);
        const auto is_jamb = [&](Tick at) {
          return std::any_of(wall.holes.begin(), wall.holes.end(), [&](const Hole& h) { return at == h.along.low || at == h.along.high; });
        };
        for (const auto& joint : lower) {
          CAPTURE(joint.second);
          CHECK((is_jamb(joint.second) || upper.count(joint) == 0));
        }
      }
    }
  }
}

TEST_CASE("volumes: walls minus openings, lintels in their place, plus roof") {
  for (const Case& c : {testing::paper_flat20(), testing::paper_flat40()}) {
    for (const Bond bond : {Bond::english, Bond::running, Bond::flemish}) {
      House house = *c.house;
      house.bond = bond;
      const double roof = 5.4 * 3.4 * 0.2;  // 27 beams of 0.2 m; in 0.4 m walls they keep their length
      const double expected = masonry_volume(house) + roof;
      CHECK(std::abs(volume(built(house)) / expected - 1.0) < kTight);
    }
  }
}

TEST_CASE("lintels: elements of 0.2 m, as thick as the wall, a member for each row") {
  for (const auto& [thickness, rows] : std::map<double, int>{{0.1, 1}, {0.2, 1}, {0.3, 2}, {0.4, 2}, {0.5, 3}}) {
    House house = *testing::paper_flat20().house;
    house.bearing_wall = thickness;
    std::map<std::string, std::set<int>> members;
    std::map<std::string, int> elements;
    for (const Block& b : built(house)) {
      if (b.kind != PartKind::lintel) continue;
      members[b.tag].insert(b.member);
      ++elements[b.tag];
      const geometry::Box3 box = geometry::bounds(b.shape);
      CHECK(box.high.x - box.low.x == doctest::Approx(0.2));
      CHECK(box.high.y - box.low.y == doctest::Approx(thickness / rows));
      CHECK(box.low.z == doctest::Approx(2.0));
      CHECK(b.segment_size == doctest::Approx(0.025));
    }
    for (const char* tag : {"lintel 0", "lintel 1"}) {
      CHECK(members[tag].size() == static_cast<std::size_t>(rows));
      CHECK(elements[tag] == 7 * rows);
    }
  }
}

TEST_CASE("flat roof: 27 beams of 17 elements on the inner 0.2 m of the bearing walls") {
  const std::vector<Block> blocks = built(*testing::paper_flat40().house);
  std::map<int, int> elements;
  double low = 10.0, high = 0.0;
  for (const Block& b : blocks) {
    if (b.kind != PartKind::beam) continue;
    ++elements[b.member];
    const geometry::Box3 box = geometry::bounds(b.shape);
    low = std::min(low, box.low.y);
    high = std::max(high, box.high.y);
    CHECK(b.segment_size == doctest::Approx(0.05));
  }
  CHECK(elements.size() == 27);
  CHECK(std::all_of(elements.begin(), elements.end(), [](const auto& e) { return e.second == 17; }));
  CHECK(low == doctest::Approx(0.2));
  CHECK(high == doctest::Approx(3.6));
  CHECK(blocks.back().tag == "roof beam 26");
}

TEST_CASE("flat roof: beams as long as they are said to bear on the walls") {
  const auto reach = [](std::optional<double> bearing) {
    House house = *testing::paper_flat40().house;
    house.roof.bearing = bearing;
    double low = 10.0, high = 0.0;
    for (const Block& b : built(house)) {
      if (b.kind != PartKind::beam) continue;
      const geometry::Box3 box = geometry::bounds(b.shape);
      low = std::min(low, box.low.y), high = std::max(high, box.high.y);
    }
    return std::array{low, high};
  };
  CHECK(reach(0.4) == std::array{0.0, 3.8});
  CHECK(reach(0.1)[0] == doctest::Approx(0.3));
  CHECK(reach(0.2) == reach({}));
}

TEST_CASE("openings in any wall, several in one, stacked, full height, or none") {
  House house = plain_house();
  house.bond = Bond::running;
  house.openings = {opening("left", 0.8, 0.9, 0.0, 2.0, 1.3), opening("right", 1.05, 0.6, 0.8, 0.6),
                    opening("rear", 2.0, 1.0, 0.3, 0.5, 1.2), opening("rear", 2.0, 1.0, 1.2, 0.6, 1.4),
                    opening("front", 0.2, 5.0, 2.2, 0.2),     opening("front", 0.2, 0.73, 0.0, 1.5),
                    opening("front", 3.333, 1.007, 0.5, 1.0)};
  const std::vector<Block> blocks = built(house);
  CHECK(std::abs(volume(blocks) / masonry_volume(house) - 1.0) < kTight);
  for (const Block& b : blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    const bool in_door = box.high.x < 0.2 + kTight && box.high.y > 0.8 + kTight && box.low.y < 1.7 - kTight && box.low.z < 2.0 - kTight;
    CHECK(!in_door);
  }
}

TEST_CASE("a cut brick keeps the segment size of the whole and is counted as cut") {
  int cut = 0;
  for (const Block& b : built(plain_house())) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    CHECK(b.segment_size == doctest::Approx(0.025));
    const double v = (box.high.x - box.low.x) * (box.high.y - box.low.y) * (box.high.z - box.low.z);
    CHECK(b.whole == (std::abs(v - 0.002) < 1e-12));
    cut += b.whole ? 0 : 1;
  }
  CHECK(cut == 2 * 12 * 4 * (2 + 1));  // 12 stretcher courses, 4 walls, 2 wythes: 0.15 and 0.10 at one end, 0.15 at the other
}

TEST_CASE("block order: course by course, round the house, roof last") {
  const std::vector<Block> blocks = built(*testing::paper_flat20().house);
  double z = 0.0;
  for (const Block& b : blocks) {
    const double low = geometry::bounds(b.shape).low.z;
    CHECK(low >= z - kTight);
    z = low;
  }
  CHECK(blocks.front().tag == "front wall");
  const auto first_other = std::find_if(blocks.begin(), blocks.end(), [](const Block& b) { return b.tag != "front wall"; });
  CHECK(first_other->tag == "right wall");
}

TEST_CASE("a turned house is the house rotated about its origin") {
  House house = *testing::paper_flat20().house;
  const std::vector<Block> straight = built(house);
  house.origin = {3.0, -2.0};
  for (const double turn : {90.0, 180.0, 270.0, -90.0, 450.0}) {
    house.turn = turn;
    const std::vector<Block> turned = built(house);
    REQUIRE(turned.size() == straight.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const geometry::Polyhedron expected =
          geometry::moved(geometry::rotated(straight[i].shape, {0, 0, 1}, turn * std::numbers::pi / 180.0, {}), {3.0, -2.0, 0.0});
      for (std::size_t k = 0; k < 8; ++k) worst = std::max(worst, norm(turned[i].shape.vertices[k] - expected.vertices[k]));
      CHECK(turned[i].tag == straight[i].tag);
    }
    CHECK(worst < 1e-13);
  }
}

TEST_CASE("copies are shifted along the global axes and numbered") {
  House house = plain_house();
  const std::size_t one = built(house).size();
  house.copies = {2, 3};
  house.spacing = {3.4, 6.0};  // turned by 90 degrees: 3.4 m along x; the copies touch
  house.turn = 90.0;
  const std::vector<Block> blocks = built(house);
  REQUIRE(blocks.size() == 6 * one);
  for (std::size_t i = 0; i < blocks.size(); i += one / 7) CHECK(blocks[i].house == static_cast<int>(i / one));
  const Vec3 shift = blocks[5 * one].shape.vertices[0] - blocks[0].shape.vertices[0];
  CHECK(norm(shift - Vec3{3.4, 12.0, 0.0}) < 1e-12);
}
