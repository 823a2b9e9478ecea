// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_courses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/house/house_plan.h"
#include "cases/input_error.h"
#include "cases/model.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

std::vector<double> heights_of_courses(const House& house) {
  std::vector<double> heights;
  for (const Interval course : plan_house(house).courses) heights.push_back(metres(course.length()));
  return heights;
}

House plain(double height) {
  House house = *testing::paper_flat20().house;
  house.openings.clear();
  house.height = height;
  return house;
}

std::string refusal_of(const Case& c) {
  try {
    build_model(c);
  } catch (const InputError& e) {
    return e.what();
  }
  return "built";
}

}  // namespace

TEST_CASE("courses: whole ones, then a cut one, or two that share what is left") {
  CHECK(heights_of_courses(plain(0.3)) == std::vector{0.1, 0.1, 0.1});
  CHECK(heights_of_courses(plain(0.27)) == std::vector{0.1, 0.1, 0.07});
  CHECK(heights_of_courses(plain(0.24)) == std::vector{0.1, 0.07, 0.07});
  CHECK(heights_of_courses(plain(0.06)) == std::vector{0.06});
}

TEST_CASE("a course ends at every sill, head and lintel, in all walls") {
  House house = plain(1.2);
  house.openings.push_back(opening("rear", 1.0, 0.8, 0.33, 0.5, 1.2));  // lintel 0.83 to 0.93
  const HousePlan plan = plan_house(house);
  for (const double level : {0.0, 0.33, 0.83, 0.93, 1.2}) {
    CAPTURE(level);
    CHECK(std::ranges::any_of(plan.courses, [&](Interval c) { return c.low == ticks(level) || c.high == ticks(level); }));
  }
  for (std::size_t i = 0; i + 1 < plan.courses.size(); ++i) CHECK(plan.courses[i].high == plan.courses[i + 1].low);
  for (const Interval c : plan.courses) CHECK((c.length() >= ticks(0.05) && c.length() <= ticks(0.1)));
}

TEST_CASE("bricks of a cut course count as cut") {
  const Case c = [] {
    Case all = testing::paper_flat20();
    all.house = plain(0.26);
    all.house->roof.kind = RoofKind::none;
    return all;
  }();
  for (const Block& b : build_model(c).blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (box.low.z > 0.19) CHECK(!b.whole);
  }
}

TEST_CASE("levels that are at fault together are advised values that go together") {
  const Tick cm = ticks(0.01);
  const std::vector<Level> levels{{},
                                  {300 * cm, "house.height", 3.0, true},
                                  {240 * cm, "head", 2.4, true},
                                  {255 * cm, "lintel", 0.15, true},
                                  {285 * cm, "beam", 0.15, true, -1}};
  Faults faults;
  CHECK(kept_levels(levels, 25 * cm, faults).size() == 3);
  std::string told;
  try {
    faults.raise();
  } catch (const InputErrors& e) {
    for (const InputError& one : e.all()) told += std::string(one.what()) + "\n";
  }
  CAPTURE(told);
  CHECK(told.find("0.15 m needs a bed joint at 2.55 m, 0.15 m from that of head; a course of cut bricks is at least 0.25 m high; "
                  "nearest: 0.25 m") != std::string::npos);
  // By itself 0.25 m would do for the beam, too: but then it ends 0.1 m above the lintel that has been raised.
  CHECK(told.find("0.15 m needs a bed joint at 2.85 m") != std::string::npos);
  CHECK(told.find("nearest: 0.35 m") != std::string::npos);
}

TEST_CASE("a lintel on a head that is at fault is judged where the advice puts the head, not where it lies") {
  const Tick cm = ticks(0.01);
  const auto told_of = [&](double lintel) {
    const std::vector<Level> levels{{},
                                    {300 * cm, "house.height", 3.0, true},
                                    {210 * cm, "first", 2.1, true},
                                    {215 * cm, "second", 2.15, true},  // too near: advised onto the first
                                    {215 * cm + ticks(lintel), "lintel", lintel, true, 1, 3}};
    Faults faults;
    kept_levels(levels, 10 * cm, faults);
    try {
      faults.raise();
    } catch (const InputErrors& e) {
      return static_cast<int>(e.all().size());
    } catch (const InputError& e) {
      CHECK(e.key() == "second");
      return 1;
    }
    return 0;
  };
  CHECK(told_of(0.2) == 1);
  CHECK(told_of(0.05) == 2);  // too low above the first, too
}

TEST_CASE("a brick of 0.25 x 0.12 x 0.065 m with 0.01 m of mortar: half a brick and its joint are a width") {
  Case c = testing::paper_flat20();
  House& house = *c.house;
  house.brick = {0.25, 0.12, 0.065};
  house.mortar = 0.01;
  house.bearing_wall = 0.26, house.nonbearing_wall = 0.26;
  const Model m = build_model(c);
  // Bricks from end to end with their mortar: the walls' volume, the door 1.2 x 2.0 and the window 1.0 x 1.0 with their lintels out.
  double bricks = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i)
    bricks += m.blocks[i].kind == PartKind::brick ? m.assembly.elements[i].mass.volume : 0.0;
  const double openings = (1.2 * 2.0 + 1.4 * 0.1 + 1.0 * 1.0 + house.openings[1].lintel->length * 0.1) * 0.26;
  CHECK(bricks == doctest::Approx((2 * 5.52 + 2 * 3.0) * 0.26 * 2.4 - openings).epsilon(1e-9));
  const auto whole = std::ranges::count_if(m.blocks, [](const Block& b) { return b.kind == PartKind::brick && b.whole; });
  CHECK(whole > 1000);

  SUBCASE("its mortar is that of the joint law") {
    house.mortar = 0.012, house.brick = {0.252, 0.12, 0.065};
    house.bearing_wall = house.nonbearing_wall = 0.264;
    CHECK(refusal_of(c) == "house.mortar: 0.012 m, but joint_laws.normal.thickness is 0.01 m; give both the same");
  }
}
