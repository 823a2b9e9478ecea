// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <random>
#include <set>

#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_spans.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

namespace {

constexpr double kBrick = 0.4 * 0.2 * 0.2;  // m3, of the walls of these cases

/// No piece of the masonry is less than a fifth of a brick.
void check_no_sliver(const Model& m) {
  double least = 1.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].wall >= 0) least = std::min(least, m.assembly.elements[i].mass.volume);
  }
  CHECK(least > 0.2 * kBrick);
}

Model check_risen(const Case& c, double volume) {
  const Model m = build_model(c);
  CHECK(volume_of(m) == doctest::Approx(volume).epsilon(1e-9));
  check_joint_areas(m);
  check_stands(m);
  check_no_sliver(m);
  return m;
}

/// A house of 6 m by 4 m with a pitched roof from the front to the rear, and gables.
Case roofed(double thickness = 0.4) {
  WallSpec outer = closed(wall("outer", {{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}}, thickness, 2.0));
  outer.line = WallLine::right;
  Case c = case_of({outer});
  c.roofs = {roof_between("roof", {"outer 1", "outer 3"}, {"outer 2", "outer 4"})};
  return c;
}

}  // namespace

TEST_CASE("gables and parapets of a wall: the volume under the top, no sliver") {
  for (const WallBond bond : {WallBond::english, WallBond::running, WallBond::through}) {
    for (const double angle : {0.0, 0.7}) {
      for (const double rise : {0.35, 1.5, 3.0}) {
        CAPTURE(rise);
        CAPTURE(angle);
        WallSpec w = wall("w", {{0.0, 0.0}, {4.1 * std::cos(angle), 4.1 * std::sin(angle)}}, 0.4, 1.2, bond);
        w.gable = 1.2 + rise;
        check_risen(case_of({w}), 0.4 * (4.1 * 1.2 + 0.5 * 4.1 * rise));
      }
    }
  }
  WallSpec w = wall("w", {{0.0, 0.0}, {6.0, 0.0}}, 0.4, 1.2);
  w.tops = {{0.5, 1.8}, {1.5, 1.8}, {1.5, 1.2}, {2.0, 1.2}, {3.0, 2.6}, {4.0, 1.9}, {5.0, 2.4}, {6.0, 1.7}};
  check_risen(case_of({w}), 0.4 * (6.0 * 1.2 + 0.6 + 0.7 + 1.05 + 0.95 + 0.85));
}

TEST_CASE("openings in gables, with lintels or without: the volume, no sliver, or a refusal by the height of the wall there") {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int built = 0, in_gable = 0, refused = 0;
  for (int k = 0; k < 150; ++k) {
    CAPTURE(k);
    const double angle = k % 3 == 0 ? 0.7 : 0.0, length = 6.0, height = 2.0, rise = 2.6;
    WallSpec w = wall("w", {{0.0, 0.0}, {length * std::cos(angle), length * std::sin(angle)}}, 0.4, height,
                      k % 2 == 0 ? WallBond::english : WallBond::through);
    w.gable = height + rise;
    const double width = 0.2 * std::round(2.0 + 3.0 * any(random)), sill = 0.2 * std::round(20.0 * any(random)),
                 tall = 0.2 * std::round(2.0 + 3.0 * any(random));
    const double from = 0.05 * std::round(20.0 * any(random) * (length - width));
    w.openings = {{from, width, sill, tall, {}, {}}};
    if (k % 4 > 1) w.openings[0].lintel = WallLintel{0.2, 0.2, {}};
    const auto top_at = [&](double s) { return height + rise * (1.0 - std::abs(2.0 * s / length - 1.0)); };
    const double head = sill + tall + (w.openings[0].lintel ? 0.2 : 0.0), beyond = w.openings[0].lintel ? 0.2 : 0.0;
    const double room = std::min(top_at(from - beyond), top_at(from + width + beyond)) - 0.5 * w.brick[2];
    try {
      const Model m = check_risen(case_of({w}), 0.4 * (length * height + 0.5 * length * rise - width * tall));
      check_joint_areas(m);
      CHECK((head <= height + 1e-9 || head <= room + 1e-4));
      ++built;
      in_gable += sill + tall > height + 1e-9 ? 1 : 0;
    } catch (const InputError& e) {
      if (from > 0.5 && from + width < length - 0.5) CHECK_MESSAGE((head > height && head > room - 1e-4), e.what());
      ++refused;
    }
  }
  CHECK(built >= 30);
  CHECK(in_gable >= 10);
  CHECK(refused >= 30);
}

TEST_CASE("an opening keeps a fifth of a brick off the step of a parapet") {
  WallSpec w = wall("w", {{0.0, 0.0}, {6.0, 0.0}}, 0.4, 1.2);
  w.tops = {{2.0, 1.2}, {2.0, 2.6}, {5.0, 2.6}, {5.0, 1.2}};
  const double whole = 0.4 * (6.0 * 1.2 + 3.0 * 1.4);
  for (const double from : {2.0, 2.01, 2.07, 4.15, 4.2}) {
    CAPTURE(from);
    w.openings = {{from, 0.8, 1.2, 1.0, {}, {}}};
    check_refused(case_of({w}), std::function<void(Case&)>([](Case&) {}), "wall[0].opening[0].from", "its top has a step at ");
  }
  for (const double from : {2.1, 3.0, 4.1}) {
    CAPTURE(from);
    w.openings = {{from, 0.8, 1.2, 1.0, {}, {}}};
    check_risen(case_of({w}), whole - 0.4 * 0.8);
  }
  w.openings = {{1.8, 0.8, 0.2, 0.6, {}, {}}};  // below the step
  check_risen(case_of({w}), whole - 0.4 * 0.48);
}

TEST_CASE("gables round a plan, and a parapet round corners") {
  WallSpec w = closed(wall("w", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.4, 1.6));
  w.line = WallLine::right;
  w.tops = {{5.0, 1.6}, {7.0, 3.3}, {9.0, 1.6}};
  const double ring = 5.0 * 4.0 - 4.2 * 3.2;
  check_bonded(check_risen(case_of({w}), ring * 1.6 + 0.4 * 0.5 * 4.0 * 1.7));
  w.tops = {{0.0, 2.2}, {18.0, 2.2}};
  check_bonded(check_risen(case_of({w}), ring * 2.2));
  w.tops = {{2.0, 2.2}, {7.0, 2.2}};  // round one corner
  check_risen(case_of({w}), ring * 1.6 + 0.6 * 0.4 * (3.0 + 2.0 - 0.4));
}

TEST_CASE("the top of a wall askew to that in which it ends is cut along its own line") {
  WallSpec main = wall("main", {{0.0, 0.0}, {5.0, 0.0}}, 0.4, 1.2), tee = wall("tee", {{2.5, 0.0}, {3.7, 3.0}}, 0.4, 1.2);
  const double plain = volume_of(build_model(case_of({main, tee})));
  tee.tops = {{0.6, 1.2}, {1.8, 2.4}, {3.0, 1.2}};
  check_risen(case_of({main, tee}), plain + 0.4 * 0.5 * 2.4 * 1.2);
  tee.tops = {}, main.tops = {{0.0, 1.2}, {2.5, 2.6}, {5.0, 1.2}};
  check_risen(case_of({main, tee}), plain + 0.4 * 0.5 * 5.0 * 1.4);
}

TEST_CASE("a pitched roof between walls: gables reach up to the rafters, and rafters rest on walls and gables") {
  for (const double thickness : {0.4, 0.3}) {
    CAPTURE(thickness);
    const Case c = roofed(thickness);
    const Model m = build_model(c);
    check_joint_areas(m);
    check_stands(m);
    check_no_sliver(m);
    const double inner = 4.0 - 2 * thickness, rise = 0.5 * inner * std::tan(30.0 * std::acos(-1.0) / 180.0);
    double masonry = 0.0, seats = 0.0, slopes = 0.0, feet = 0.0;
    std::set<std::int32_t> rafters;
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
      if (m.blocks[i].wall >= 0) masonry += m.assembly.elements[i].mass.volume;
      if (m.blocks[i].span >= 0) rafters.insert(m.blocks[i].member);
    }
    CHECK(masonry == doctest::Approx(2.0 * (24.0 - (6.0 - 2 * thickness) * inner) + 2.0 * thickness * 0.5 * inner * rise).epsilon(1e-9));
    for (const geometry::Joint& j : m.assembly.joints) {
      if (j.element_b == geometry::kBase) continue;
      const Block *a = &m.blocks[static_cast<std::size_t>(j.element_a)], *b = &m.blocks[static_cast<std::size_t>(j.element_b)];
      if ((a->span < 0) == (b->span < 0)) continue;
      const std::string& on = a->span < 0 ? a->tag : b->tag;
      (std::abs(j.frame().normal.z) > 0.99 ? seats : slopes) += j.area;
      feet += on == "outer 2 gable" || on == "outer 4 gable" ? 0.0 : j.area;
    }
    const double pairs = static_cast<double>(rafters.size()) / 2.0;
    CHECK(pairs == std::ceil(5.9 / 0.8) + 1.0);
    CHECK(slopes == doctest::Approx(2.0 * 0.1 * inner / std::cos(30.0 * std::acos(-1.0) / 180.0)).epsilon(1e-6));
    CHECK(seats > 0.9 * feet);
    CHECK(feet > 0.1 * (2.0 * pairs - 4.0) * 0.1);
  }
}

TEST_CASE("a roof is as dense as that of the house with the same dimensions, and has its ties and deck") {
  Case c = roofed();
  c.roofs[0].rafters.surcharge = 60.0, c.roofs[0].rafters.tie = Tie{}, c.roofs[0].rafters.tie->area = 1e-4;
  c.roofs[0].rafters.deck = Deck{3.5e5, {}, 1e7, {}};
  const Model m = build_model(c);
  Case h = paper_materials();
  h.base = Base{}, h.house = House{};
  h.house->inner_size = {5.2, 3.2}, h.house->height = 2.0, h.house->brick = {0.4, 0.2, 0.2};
  h.house->bearing_wall = h.house->nonbearing_wall = 0.4, h.house->joint = "normal";
  h.house->roof = c.roofs[0].rafters, h.house->roof.kind = RoofKind::pitched;
  const Model o = build_model(h);
  const auto rafters = [](const Model& x) {
    std::vector<std::array<double, 2>> all;
    for (std::size_t i = 0; i < x.blocks.size(); ++i) {
      if (x.blocks[i].kind != PartKind::beam) continue;
      const double v = x.assembly.elements[i].mass.volume;
      all.push_back({v, v * x.materials[static_cast<std::size_t>(x.blocks[i].material)].value.density});
    }
    std::ranges::sort(all);
    return all;
  };
  const auto ours = rafters(m), house = rafters(o);
  REQUIRE(ours.size() == house.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) CHECK(ours[i][k] == doctest::Approx(house[i][k]).epsilon(1e-9));
  }
  REQUIRE(m.tie_bill.size() == 2);
  CHECK(m.tie_bill[0].ties == o.tie_bill[0].ties);
  CHECK(m.tie_bill[0].length == doctest::Approx(o.tie_bill[0].length));
  CHECK(m.tie_bill[1].area == doctest::Approx(o.tie_bill[1].area));
  c.walls[0].points = {{0.0, 0.0}, {6.07, 0.0}, {6.07, 4.03}, {0.0, 4.03}};  // of which no half brick is left, which may go either way
  const Model plain = build_model(c);
  for (const double angle : {0.0, 0.5, 3.0}) {
    for (const bool mirror : {false, true}) check_same(plain, build_model(moved(c, angle, mirror)));
  }
}

TEST_CASE("gables and roofs that cannot be built are refused with the key, the value and what is allowed") {
  const auto refuse = [](const std::function<void(Case&)>& change, const std::string& key, const std::string& says) {
    check_refused(roofed(), change, key, says);
  };
  refuse([](Case& c) { c.walls[0].gable = 3.0; }, "wall[0].gable", "needs a wall of one side, and \"outer\" has 4; give `tops`");
  refuse([](Case& c) { c.walls[0].tops = {{1.0, 1.5}}; }, "wall[0].tops[0]", "1.5 m is below the height of the wall; allowed: 2 m or more");
  refuse([](Case& c) { c.walls[0].tops = {{21.0, 2.5}}; }, "wall[0].tops[0]", "beyond the line of the wall, which is 20 m long");
  refuse([](Case& c) { c.walls[0].tops = {{3.0, 2.5}, {2.0, 2.5}}; }, "wall[0].tops[1]", "comes before 3 m; places ascend");
  refuse([](Case& c) { c.walls[0].tops = {{2.0, 2.0}, {2.4, 2.04}, {2.8, 2.0}}; }, "wall[0].tops", "rises by 0.04 m over 0.8 m");
  refuse(
      [](Case& c) {
        c.walls[0].tops = {{7.0, 2.6}, {8.0, 2.6}};
      },
      "roof[0].gables[0]", "raises the outer 2 wall where wall[0].tops does");
  refuse([](Case& c) { c.roofs[0].walls[1] = "outer 2"; }, "roof[0].walls", "less than 30 degrees");
  refuse([](Case& c) { c.roofs[0].gables[0] = "outer 3"; }, "roof[0].gables[0]", "not square to the ridge");
  refuse([](Case& c) { c.roofs[0].rafters.pitch = 70.0; }, "roof[0].pitch", "allowed: 5 to 60");
  refuse([](Case& c) { c.roofs[0].rafters.bearing = 0.5; }, "roof[0].bearing", "at most 0.4 m");
  refuse([](Case& c) { c.roofs[0].material = "glass"; }, "roof[0].material", "glass");
  Case c = roofed();
  c.walls[0].closed = false;
  c.walls.push_back(wall("other", {{-3.0, 5.0}, {8.0, 5.5}}, 0.3, 2.2));
  c.roofs[0].gables = {}, c.roofs[0].walls[1] = "other";
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "roof[0].walls", "are not parallel");
}
