// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/walls.h"

#include <numbers>

#include "tests/cases/walls/plan_walls.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

TEST_CASE("a straight wall has its true length, thickness and height, in every bond") {
  for (const WallBond bond : {WallBond::english, WallBond::running, WallBond::header, WallBond::through}) {
    for (const double thickness : {0.2, 0.38, 0.41, 0.6}) {
      CAPTURE(thickness);
      CAPTURE(static_cast<int>(bond));
      const Model m = check_sound(case_of({wall("w", {{0.0, 0.0}, {3.137, 0.0}}, thickness, 2.153, bond)}), 3.137 * thickness * 2.153);
      double low = 1e9, high = -1e9;
      for (const Block& b : m.blocks)
        low = std::min(low, geometry::bounds(b.shape).low.y), high = std::max(high, geometry::bounds(b.shape).high.y);
      CHECK(high - low == doctest::Approx(thickness).epsilon(1e-12));
    }
  }
}

TEST_CASE("openings lie where they are said to lie, and lintels on them") {
  WallSpec w = wall("w", {{0.0, 0.0}, {4.0, 0.0}}, 0.38, 2.4);
  w.openings = {{0.713, 0.9, 0.0, 2.013, WallLintel{0.2, 0.137, "wood"}, {}}, {2.4, 0.812, 0.871, 1.1, {}, {}}};
  const Model m = check_sound(case_of({w}), 0.38 * (4.0 * 2.4 - 0.9 * 2.013 - 0.812 * 1.1));
  double low = 0.0, high = 4.0, lintels = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const geometry::Box3 box = geometry::bounds(m.blocks[i].shape);
    if (m.blocks[i].kind == PartKind::lintel) {
      lintels += m.assembly.elements[i].mass.volume;
      CHECK(box.low.x == doctest::Approx(0.513).epsilon(1e-12));
      CHECK(box.high.z == doctest::Approx(2.15).epsilon(1e-12));
    }
    if (box.low.z > 1.0 || box.high.z < 0.9) continue;
    if (box.high.x < 1.2) low = std::max(low, box.high.x);
    if (box.low.x > 1.2) high = std::min(high, box.low.x);
  }
  CHECK(low == doctest::Approx(0.713).epsilon(1e-12));
  CHECK(high == doctest::Approx(1.613).epsilon(1e-12));
  CHECK(lintels == doctest::Approx(1.3 * 0.38 * 0.137).epsilon(1e-12));
}

TEST_CASE("an arch over an opening, on a lintel or without one, in a wall that runs askew") {
  for (const double degrees : {0.0, 37.0, 200.0}) {
    for (const bool on_lintel : {false, true}) {
      CAPTURE(degrees);
      const double a = degrees * std::numbers::pi / 180.0;
      WallSpec w = wall("w", {{1.0, 2.0}, {1.0 + 4.0 * std::cos(a), 2.0 + 4.0 * std::sin(a)}}, 0.45, 2.8);
      w.openings = {{1.3, 1.0, 0.4, 1.07, {}, Arch{0.5, 0.3, 0.25, 9, "wood"}}};
      if (on_lintel) w.openings[0].lintel = WallLintel{0.2, 0.1, {}};
      const double soffit = 9 / 2.0 * 0.25 * std::sin(std::numbers::pi / 9);  // half a polygon of 18 corners, radius 0.5 m
      const Model m = check_sound(case_of({w}), 0.45 * (4.0 * 2.8 - 1.0 * 1.07 - soffit));
      std::size_t voussoirs = 0;
      for (const Block& b : m.blocks) {
        if (b.kind != PartKind::arch_stone) continue;
        ++voussoirs;
        CHECK(m.materials[static_cast<std::size_t>(b.material)].name == "wood");
      }
      CHECK(voussoirs >= 18);  // in two rows; the springers, too, unless the first voussoir takes their place
    }
  }
}

TEST_CASE("four walls round a rectangle, by their middle, their outer or their inner face") {
  for (const WallBond bond : {WallBond::english, WallBond::running, WallBond::header}) {
    for (const double t : {0.2, 0.4, 0.38}) {
      for (const WallLine line : {WallLine::middle, WallLine::right, WallLine::left}) {
        CAPTURE(t);
        WallSpec w = closed(wall("house", {{0.0, 0.0}, {4.1, 0.0}, {4.1, 3.3}, {0.0, 3.3}}, t, 2.0, bond));
        w.line = line;
        const double grow = line == WallLine::middle ? 0.5 * t : line == WallLine::left ? t : 0.0;
        const double x = 4.1 + 2 * grow, y = 3.3 + 2 * grow;
        check_bonded(check_sound(case_of({w}), 2.0 * (x * y - (x - 2 * t) * (y - 2 * t))), bond == WallBond::running && t > 0.2);
      }
    }
  }
}

TEST_CASE("corners of any angle from 30 to 150 degrees") {
  for (const double degrees : {30.0, 45.0, 60.0, 77.0, 90.0, 120.0, 150.0}) {
    for (const double turn : {1.0, -1.0}) {
      for (const double t : {0.2, 0.4}) {
        CAPTURE(degrees);
        CAPTURE(t);
        const double a = (180.0 - degrees) * std::numbers::pi / 180.0 * turn;
        const Case c =
            case_of({wall("w", {{0.0, 0.0}, {4.0, 0.0}, {4.0 + 4.0 * std::cos(a), 4.0 * std::sin(a)}}, t, 1.4, WallBond::running)});
        check_bonded(check_sound(c, 8.0 * t * 1.4), t > 0.2);  // by the middle line: what the outer side has more the inner one has less
      }
    }
  }
}

TEST_CASE("a wall that ends in another one, and one that crosses it, at right angles and askew") {
  for (const double lean : {0.0, 0.9, -1.4}) {
    for (const WallMeeting meeting : {WallMeeting::toothed, WallMeeting::butt}) {
      CAPTURE(lean);
      WallSpec main = wall("main", {{0.0, 0.0}, {5.0, 0.0}}, 0.4, 1.6);
      WallSpec tee = wall("tee", {{2.2, 0.0}, {2.2 + lean, 2.5}}, 0.2, 1.6, WallBond::running);
      tee.meeting = meeting;
      const double length = std::hypot(lean, 2.5), buried = 0.2 * length / 2.5;  // from the middle of the main wall to its face
      const double volume = 1.6 * (5.0 * 0.4 + (length - buried) * 0.2);
      const Model m = check_sound(case_of({main, tee}), volume);
      if (meeting == WallMeeting::toothed) check_bonded(m);
      tee.points[1] = {2.2 - lean, -2.5};
      tee.points[0] = {2.2 + lean, 2.5};
      const double cross = 1.6 * (5.0 * 0.4 + (2 * length - 2 * buried) * 0.2);
      const Model x = check_sound(case_of({main, tee}), cross);
      if (meeting == WallMeeting::toothed) check_bonded(x);
    }
  }
}

TEST_CASE("walls of their own: corners, a cross of two that end in one, a wall behind a corner") {
  const WallSpec main = wall("main", {{0.0, 0.0}, {4.0, 0.0}}, 0.4, 1.6);
  const WallSpec up = wall("up", {{4.0, 0.0}, {4.0, 3.0}}, 0.4, 1.6);
  check_bonded(check_sound(case_of({main, up}), 1.6 * 0.4 * 7.0));
  const WallSpec left = wall("left", {{2.0, 3.0}, {2.0, 0.0}}, 0.4, 1.6), right = wall("right", {{2.0, -3.0}, {2.0, 0.0}}, 0.4, 1.6);
  check_bonded(check_sound(case_of({main, left, right}), 1.6 * 0.4 * (4.0 + 2.8 + 2.8)), true);
  const WallSpec on = wall("on", {{4.0, 0.0}, {7.0, 0.0}}, 0.4, 1.6);
  check_bonded(check_sound(case_of({main, up, on}), 1.6 * 0.4 * (7.0 + 2.8)), true);
}

TEST_CASE("walls of other heights, upon each other, and on a part of the base") {
  const WallSpec main = wall("main", {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}}, 0.4, 2.4);
  WallSpec low = wall("low", {{2.0, 0.0}, {2.0, 2.0}}, 0.2, 1.3);
  check_sound(case_of({main, low}), 2.4 * 0.4 * 7.0 + 1.3 * 0.2 * 1.8);
  WallSpec upper = wall("upper", {{0.0, 0.1}, {4.0, 0.1}}, 0.2, 1.0);
  upper.base = 2.4;
  check_sound(case_of({main, upper}), 2.4 * 0.4 * 7.0 + 0.2 * 4.0);
  low.base = 0.3, low.height = 1.0;
  Case c = case_of({low});
  c.base->parts = {{std::array{1.0, 3.0}, std::array{-1.0, 3.0}, "", {}, {}, 0.3, {}}};
  const Model m = build_model(c);
  CHECK(m.blocks.back().ground == 0);
  check_nothing_unjoined(m);
}

TEST_CASE("a round tower and a curved wall of straight blocks") {
  WallSpec tower = closed(wall("tower", {}, 0.4, 2.0, WallBond::through));
  tower.brick[0] = 0.3;  // of the radius less than a sixth
  for (int i = 0; i < 72; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 72;
    tower.points.push_back({2.0 * std::cos(a), 2.0 * std::sin(a)});
  }
  const double side = 2.0 * 2.0 * std::sin(std::numbers::pi / 72);
  check_bonded(check_sound(case_of({tower}), 72 * side * 0.4 * 2.0, 4e-3));
  tower.openings = {{1.0, 0.9, 0.0, 1.5, WallLintel{0.2, 0.2, {}}, {}}};
  check_bonded(check_sound(case_of({tower}), (72 * side * 2.0 - 0.9 * 1.5) * 0.4, 4.5e-3));
  WallSpec bent = tower;
  bent.closed = false, bent.points.resize(30), bent.openings.clear();
  check_bonded(check_sound(case_of({bent}), 29 * side * 0.4 * 2.0, 4e-3));
}

TEST_CASE("a wall that crosses a curved one behind its bend, and one that ends in it") {
  const WallSpec bent = wall("bent", {{0.0, 0.0}, {3.0, 0.0}, {6.0, 1.0}}, 0.3, 1.2, WallBond::through);
  const double length = 3.0 + std::sqrt(10.0), face = 0.3 * std::sqrt(10.0) / 3.0;  // face: of the bent wall along y
  for (const bool ends : {false, true}) {
    CAPTURE(ends);
    const WallSpec other = wall("other", {{4.5, ends ? 0.5 : -1.5}, {4.5, 2.5}}, 0.2, 1.2, WallBond::running);
    const double beside = (ends ? 2.0 : 4.0) - (ends ? 0.5 : 1.0) * face;
    check_bonded(check_sound(case_of({bent, other}), 1.2 * (0.3 * length + 0.2 * beside), 2e-3));
  }
}

TEST_CASE("a curved wall ends in a straight one with its first or its last point, whichever way its other sides point") {
  const double y = 1.0, bent_length = 0.9 + std::hypot(1.0, 0.375);
  const Points points{{0.45, y}, {1.35, y}, {2.35, y + 0.375}};
  for (const bool reversed : {false, true}) {
    for (const WallMeeting meeting : {WallMeeting::toothed, WallMeeting::butt}) {
      CAPTURE(reversed);
      CAPTURE(static_cast<int>(meeting));
      WallSpec bent = wall("bent", reversed ? Points(points.rbegin(), points.rend()) : points, 0.9, 1.2, WallBond::through);
      bent.meeting = meeting;
      check_sound(case_of({wall("straight", {{0.0, -0.15}, {0.0, 6.35}}, 0.9, 1.2), bent}), 1.2 * 0.9 * (6.5 + bent_length), 2e-3);
    }
  }
}

TEST_CASE("the load on a wall is carried by its top course") {
  WallSpec w = wall("w", {{0.0, 0.0}, {4.0, 0.0}}, 0.4, 2.0);
  w.load = 350.0;
  const Model m = build_model(case_of({w}));
  double mass = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i)
    mass += m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density;
  CHECK(mass == doctest::Approx(1800.0 * 4.0 * 0.4 * 2.0 + 350.0 * 4.0).epsilon(1e-12));
}
