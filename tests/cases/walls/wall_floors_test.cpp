// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <numbers>
#include <set>

#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_spans.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

namespace {

constexpr double kLean = 0.7;  // m, of the rear wall of the askew room

/// A room of 4.2 m by 3.2 m inside, its rear wall askew by `lean`, with a floor from the front to the rear.
Case room(double lean = 0.0) {
  WallSpec outer = closed(wall("outer", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0 + lean}}, 0.4, 2.4));
  outer.line = WallLine::right;
  Case c = case_of({outer});
  c.floors = {floor_between("floor", {"outer 1", "outer 3"})};
  return c;
}

/// Area of joints with level beds between beams and the bricks of each side under them.
std::map<std::string, double> seats(const Model& m) {
  std::map<std::string, double> area;
  for (const geometry::Joint& j : m.assembly.joints) {
    if (j.element_b == geometry::kBase || std::abs(j.frame().normal.z) < 0.99) continue;
    auto beam = static_cast<std::size_t>(j.element_a), brick = static_cast<std::size_t>(j.element_b);
    if (m.blocks[beam].span < 0) std::swap(beam, brick);
    if (m.blocks[beam].span < 0 || m.blocks[brick].span >= 0) continue;
    if (m.assembly.elements[brick].mass.centroid.z < m.assembly.elements[beam].mass.centroid.z) area[m.blocks[brick].tag] += j.area;
  }
  return area;
}

std::size_t beams_of(const Model& m) {
  std::set<std::int32_t> members;
  for (const Block& b : m.blocks) {
    if (b.span >= 0) members.insert(b.member);
  }
  return members.size();
}

}  // namespace

TEST_CASE("a floor between two walls: its beams fill pockets, bear on the walls that are named, and are as many as fit") {
  for (const double level : {2.4, 1.6}) {
    CAPTURE(level);
    Case c = room();
    c.floors[0].level = level;
    // 4.2 m less a fifth of a brick at both ends; beams of 0.1 m every 0.6 m
    const double beams = std::floor((4.2 - 2 * 0.08 - 0.1) / 0.6 + 1e-9) + 1.0;
    const double walls = 2.4 * (5.0 * 4.0 - 4.2 * 3.2);
    const Model m = check_sound(c, walls + beams * 3.2 * 0.1 * 0.2);
    CHECK(beams_of(m) == static_cast<std::size_t>(beams));
    for (const auto& [side, area] : seats(m)) {
      CAPTURE(side);
      const std::string storey = level == 2.4 ? "" : ", storey 1";
      CHECK((side == "outer 1 wall" + storey || side == "outer 3 wall" + storey));
      CHECK(area == doctest::Approx(beams * 0.1 * 0.2).epsilon(1e-9));
    }
    CHECK(seats(m).size() == 2);
  }
}

TEST_CASE("beams end along walls askew, and beams of a given direction cross a room askew") {
  const double sine = 5.0 / std::hypot(5.0, kLean);
  Case c = room(kLean);
  const Model m = build_model(c);
  CHECK(seats(m)["outer 1 wall"] == doctest::Approx(static_cast<double>(beams_of(m)) * 0.02).epsilon(1e-9));
  CHECK(seats(m)["outer 3 walling"] == doctest::Approx(static_cast<double>(beams_of(m)) * 0.02 / sine).epsilon(1e-9));
  check_joint_areas(m);
  check_stands(m);
  c = room();
  c.floors[0].direction = {std::sin(0.4), std::cos(0.4)};
  const Model askew = build_model(c);
  const double n = static_cast<double>(beams_of(askew));
  CHECK(n > 2.0);
  CHECK(seats(askew)["outer 1 wall"] == doctest::Approx(n * 0.02 / std::cos(0.4)).epsilon(1e-9));
  CHECK(volume_of(askew) == doctest::Approx(2.4 * (20.0 - 4.2 * 3.2) + n * 3.2 / std::cos(0.4) * 0.02).epsilon(1e-9));
  check_joint_areas(askew);
}

TEST_CASE("walls between rooms, walls across the beams, a quadrilateral of a room") {
  Case c = room();
  c.walls.push_back(wall("inner", {{2.0, 0.2}, {2.0, 3.8}}, 0.2, 2.4));
  Model m = build_model(c);  // rooms of 1.5 and 2.5 m
  CHECK(beams_of(m) == 3 + 4);
  check_joint_areas(m);
  check_stands(m);
  c.floors[0].corners = {{2.0, 0.1}, {5.0, 0.1}, {5.0, 3.9}, {2.0, 3.9}};
  CHECK(beams_of(build_model(c)) == 4);
  c = room();
  c.walls.push_back(wall("across", {{0.2, 2.0}, {4.8, 2.0}}, 0.2, 2.4));
  m = build_model(c);
  const double n = static_cast<double>(beams_of(m));
  CHECK(seats(m)["across wall"] == doctest::Approx(n * 0.1 * 0.2).epsilon(1e-9));
  CHECK(volume_of(m) == doctest::Approx(2.4 * (20.0 - 4.2 * 3.0) + n * 3.0 * 0.02).epsilon(1e-9));
  check_joint_areas(m);
}

TEST_CASE("beams upon walls, and two floors that end opposite each other in one wall") {
  Case c = room();
  c.floors[0].level = 2.6;
  const Model upon = build_model(c);
  const double n = static_cast<double>(beams_of(upon));
  CHECK(volume_of(upon) == doctest::Approx(2.4 * (20.0 - 4.2 * 3.2) + n * 3.6 * 0.02).epsilon(1e-9));
  double upon_walls = 0.0;
  for (const auto& [side, area] : seats(upon)) upon_walls += area;
  CHECK(n == 8.0);  // from end to end of the walls: the outer ones lie by half on the walls beside
  CHECK(upon_walls == doctest::Approx(2.0 * n * 0.02 + 2.0 * 0.05 * 3.2).epsilon(1e-9));
  c = room();
  c.walls.push_back(wall("across", {{0.2, 2.0}, {4.8, 2.0}}, 0.4, 2.4));
  c.floors[0].walls[1] = "across", c.floors[0].beams.bearing = 0.12;
  c.floors.push_back(floor_between("rear", {"across", "outer 3"}));
  c.floors[1].beams.bearing = 0.12;
  const Model both = build_model(c);
  check_joint_areas(both);
  check_stands(both);
  CHECK(seats(both)["across wall"] == doctest::Approx(static_cast<double>(beams_of(both)) * 0.1 * 0.12).epsilon(1e-9));
}

TEST_CASE("beams of two floors end in one wall side by side, or partly opposite each other, or are refused by the names of both") {
  int built = 0, refused = 0;
  for (int k = 0; k < 40; ++k) {
    const double shift = 0.03 * k;
    CAPTURE(shift);
    Case c = room();
    c.walls.push_back(wall("across", {{0.2, 2.0}, {4.8, 2.0}}, 0.4, 2.4));
    c.walls[1].bond = WallBond::through;
    c.floors[0].walls[1] = "across", c.floors[0].beams.bearing = 0.12, c.floors[0].beams.beam = {0.2, 0.2};
    c.floors.push_back(floor_between("rear", {"across", "outer 3"}));
    c.floors[1].beams = c.floors[0].beams;
    c.floors[1].corners = {{0.4 + shift, 2.0}, {4.6, 2.0}, {4.6, 3.6}, {0.4 + shift, 3.6}};
    try {
      const Model m = build_model(c);
      const double walls = 2.4 * (5.0 * 4.0 - 4.2 * 3.2 + 4.2 * 0.4), clear = 1.4;
      CHECK(volume_of(m) == doctest::Approx(walls + static_cast<double>(beams_of(m)) * clear * 0.2 * 0.2).epsilon(1e-9));
      CHECK(seats(m)["across wall"] == doctest::Approx(static_cast<double>(beams_of(m)) * 0.2 * 0.12).epsilon(1e-9));
      check_joint_areas(m);
      check_same(m, build_model(moved(c, 0.3, false)));
      ++built;
    } catch (const InputError& e) {
      CHECK(e.key() == "floor[1].spacing");
      CHECK_MESSAGE(std::string(e.what()).find("across wall, where floor[0] has them, with ") != std::string::npos, e.what());
      ++refused;
    }
  }
  CHECK(built >= 10);
  CHECK(refused >= 5);
  Case c = room();
  c.floors.push_back(c.floors[0]);
  c.floors[1].name = "again";
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "floor[1].corners", "puts beams across those from ");
}

TEST_CASE("a plan that is turned, mirrored or given with its walls in another order has the same floor") {
  Case c = room();
  c.walls[0].points = {
      {0.0, 0.0}, {5.07, 0.0}, {5.07, 4.03}, {0.0, 4.03 + kLean}};  // of which no half brick is left, which may go either way
  c.walls.push_back(wall("inner", {{2.03, 0.2}, {2.03, 3.97}}, 0.3, 2.4));
  c.floors[0].beams.deck = Deck{3.5e5, {}, 1e7, {}};
  const Model m = build_model(c);
  for (const double angle : {0.3, 2.0, 4.4}) {
    for (const bool mirror : {false, true}) {
      CAPTURE(angle);
      CAPTURE(mirror);
      check_same(m, build_model(moved(c, angle, mirror)));
    }
  }
}

TEST_CASE("loads, laws, anchors and decks of a floor") {
  Case c = room();
  WallFloor& f = c.floors[0];
  f.beams.load = 150.0, f.beams.anchorage = Anchorage::anchor, f.beams.anchor = BeamAnchor{};
  f.beams.anchor->bar.area = 1e-4;
  f.beams.deck = Deck{3.5e5, {}, 1e7, {}};
  const Model m = build_model(c);
  const double n = static_cast<double>(beams_of(m));
  double mass = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].span >= 0)
      mass += m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density;
  }
  CHECK(mass == doctest::Approx(n * 3.6 * (0.02 * c.materials["wood"].density + 150.0 * 0.6)).epsilon(1e-9));
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    if (j.element_b == geometry::kBase) continue;
    const Block &a = m.blocks[static_cast<std::size_t>(j.element_a)], &b = m.blocks[static_cast<std::size_t>(j.element_b)];
    if (a.span < 0 && b.span < 0) continue;
    CHECK(m.laws[static_cast<std::size_t>(m.joint_law[i])].name == (a.member == b.member ? "wood" : "dry"));
  }
  CHECK(m.tie_bill.size() == 2);
  CHECK(m.tie_bill[0].name == "floor anchors");
  CHECK(m.tie_bill[0].ties == static_cast<std::int64_t>(2 * n));
  CHECK(m.tie_bill[0].length == doctest::Approx(2 * n * (0.4 + 0.3)).epsilon(1e-9));
  CHECK(m.tie_bill[1].name == "floor deck");
  CHECK(m.tie_bill[1].area ==
        doctest::Approx((n - 1) * 0.6 * 2.4).epsilon(1e-9));  // elements of 0.4 m, from middle to middle, the first behind the face
}

TEST_CASE("floors that cannot lie are refused with the key, the value and what is allowed") {
  using F = WallFloor&;
  const auto refuse = [](const std::function<void(F)>& change, const std::string& key, const std::string& says) {
    Case c = room();
    c.walls[0].openings = {{2.0, 1.0, 0.0, 2.0, WallLintel{0.2, 0.2, {}}, {}}};
    check_refused(c, std::function<void(Case&)>([&](Case& x) { change(x.floors[0]); }), key, says);
  };
  refuse([](F f) { f.walls = {"outer 1"}; }, "floor[0].walls", "names 1 sides; it spans between two");
  refuse([](F f) { f.walls[1] = "outer"; }, "floor[0].walls[1]", "has several sides; name one of them: outer 1, outer 2, outer 3, outer 4");
  refuse([](F f) { f.walls[1] = "otter 3"; }, "floor[0].walls[1]", "did you mean \"outer 3\"?");
  refuse([](F f) { f.walls[1] = "outer 2"; }, "floor[0].walls", "less than 30 degrees");
  refuse([](F f) { f.level = 2.5; }, "floor[0].level", "allowed levels: 0.2 m; 0.24 to 2.36 m; 2.4 m; 2.6 m");
  refuse([](F f) { f.beams.bearing = 0.5; }, "floor[0].bearing", "deeper than the outer 1 wall; at most 0.4 m");
  refuse([](F f) { f.beams.bearing = 0.38; }, "floor[0].bearing",
         "leaves bricks of 0.02 m behind the beams in the outer 1 wall; at least 0.08 m");
  refuse([](F f) { f.beams.spacing = 0.15; }, "floor[0].spacing", "at least 0.18 m");
  refuse([](F f) { f.level = 2.2; }, "floor[0].spacing", "wall[0].opening[0].lintel is from 1.8 to 3.2 m");
  refuse([](F f) { f.beams.beam[0] = 4.2, f.beams.spacing = 6.0; }, "floor[0].beam", "m wide fits along the");
  refuse([](F f) { f.material = "glass"; }, "floor[0].material", "glass");
  refuse([](F f) { f.within_member = "glue"; }, "floor[0].within_member", "glue");
  refuse([](F f) { f.corners = {{0.0, 0.0}, {5.0, 0.0}, {0.0, 4.0}, {5.0, 4.0}}; }, "floor[0].corners", "no convex quadrilateral");
}

TEST_CASE("beams lie on the ledge of a wall upon which a thinner one stands, and reach into that") {
  const double n = 5.0;  // in 3 m, less a fifth of a brick at both ends
  for (const double bearing : {0.1, 0.2, 0.3}) {
    for (const bool of_upper : {false, true}) {
      if (of_upper && bearing > 0.15) continue;
      CAPTURE(bearing);
      CAPTURE(of_upper);
      Case c = room();
      c.walls.push_back(c.walls[0]);
      c.walls[1].name = "upper", c.walls[1].thickness = 0.2, c.walls[1].base = 2.4, c.walls[1].height = 2.0;
      if (of_upper) c.floors[0].walls = {"upper 1", "upper 3"};  // the ledge is before its pockets
      c.floors[0].level = 2.6, c.floors[0].beams.bearing = bearing;
      c.floors[0].corners = {{1.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {1.0, 4.0}};
      const double seat = of_upper ? 0.2 + bearing : bearing, walls = 2.4 * (20.0 - 4.2 * 3.2) + 2.0 * (20.0 - 4.6 * 3.6);
      const Model m = build_model(c);
      CHECK(static_cast<double>(beams_of(m)) == n);
      CHECK(volume_of(m) == doctest::Approx(walls + n * 0.1 * 0.2 * (3.2 + 2 * std::min(seat, 0.2))).epsilon(1e-9));
      check_joint_areas(m);
      check_stands(m);
      CHECK(seats(m)["outer 1 wall, storey 1"] == doctest::Approx(n * 0.1 * seat).epsilon(1e-9));
      CHECK(seats(m).size() == 2);
    }
  }
}

TEST_CASE("beams lie at the foot of a wall upon another, and anchors hold what stands behind them") {
  for (const double thickness : {0.4, 0.2}) {
    CAPTURE(thickness);
    Case c = room();
    c.walls.push_back(c.walls[0]);
    c.walls[1].name = "upper", c.walls[1].thickness = thickness, c.walls[1].base = 2.4, c.walls[1].height = 2.0;
    c.floors[0].level = 2.6;
    c.floors[0].beams.anchorage = Anchorage::anchor;
    c.floors[0].beams.anchor.emplace();
    c.floors[0].beams.anchor->bar.area = 1e-4;
    const Model m = build_model(c);
    REQUIRE(!m.ties.empty());
    for (const TieBar& t : m.ties) {
      CHECK(t.length == doctest::Approx(0.4 + 0.3));  // from the outer face, 0.3 m into the room
      for (const TieHold& h : t.ends[1]) CHECK(m.blocks[static_cast<std::size_t>(h.element)].tag.starts_with("upper"));
    }
  }
}

TEST_CASE("the level that is advised for a floor is one at which it lies") {
  std::size_t advised = 0;
  for (double level = 0.02; level < 3.1; level += 0.02) {
    CAPTURE(level);
    Case c = room();
    c.walls[0].openings = {{2.0, 1.0, 0.4, 1.5, {}, {}}};
    c.floors[0].corners = {{3.4, 0.0}, {4.6, 0.0}, {4.6, 4.0}, {3.4, 4.0}};
    c.walls.push_back(wall("across", {{1.0, 2.0}, {4.0, 2.0}}, 0.2, 2.62));  // beams go through it, and would end at 2.6 m upon the others
    c.floors[0].level = level;
    std::vector<InputError> faults;
    const auto attempt = [&] {
      faults.clear();
      try {
        build_model(c);
      } catch (const InputErrors& e) {
        faults = e.all();
      } catch (const InputError& e) {
        faults = {e};
      }
    };
    attempt();
    for (const InputError& fault : std::vector(faults)) {
      const std::string problem = fault.problem();
      const std::size_t at = problem.find("nearest: ");
      if (fault.key() != "floor[0].level" || at == std::string::npos) continue;
      ++advised;
      CAPTURE(problem);
      c.floors[0].level = std::stod(problem.substr(at + 9));
      attempt();
      CHECK(std::ranges::none_of(faults, [](const InputError& f) { return f.key() == "floor[0].level"; }));
    }
  }
  CHECK(advised > 3);
}

TEST_CASE("faults of several floors are told together") {
  Case c = room();
  c.floors.push_back(c.floors[0]);
  c.floors[0].walls[0] = "outer 9", c.floors[1].beams.bearing = 0.5;
  try {
    build_model(c);
    FAIL("not refused");
  } catch (const InputErrors& e) {
    CHECK(e.all().size() == 3);
  }
}
