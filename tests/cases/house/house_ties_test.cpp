// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_ties.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>

#include "cases/ties/ties.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// Rods and meshes of a house: where they run, what they hold, what they take, and what is refused.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;

/// Outer size 1.2 x 1.0 m, walls 0.2 m thick and 0.4 m high, a door in front from x = 0.4 to 0.8 up to 0.2 m.
Case small_house() {
  Case c = testing::paper_flat20();
  c.output.history.clear();
  c.house->inner_size = {0.8, 0.6};
  c.house->height = 0.4;
  c.house->openings = {testing::opening("front", 0.4, 0.4, 0.0, 0.2, 0.6)};
  return c;
}

HouseTie rods(HouseTieKind kind, double height) {
  HouseTie t;
  t.kind = kind, t.heights = {height};
  t.bar.name = "rods", t.bar.area = 2e-4, t.bar.plate = {{0.1, 0.1}};
  return t;
}

HouseMesh mesh() {
  HouseMesh m;
  m.name = "net", m.stiffness = 2e5, m.spacing = {0.2, 0.1};
  return m;
}

Vec3 end_of(const TieBar& t, std::size_t end) {
  Vec3 at;
  for (const TieHold& h : t.ends[end]) at += h.share * h.point;
  return at;
}

/// Several faults of a case, a line each.
std::string faults_of(const Case& c) {
  std::string told;
  try {
    build_model(c);
  } catch (const InputErrors& e) {
    for (const InputError& one : e.all()) told += std::string(one.what()) + "\n";
  }
  return told;
}

void check_run(const TieBar& t, const std::string& name, Vec3 from, Vec3 to) {
  CAPTURE(name);
  CHECK(t.name == name);
  CHECK(norm(end_of(t, 0) - from) < 1e-12);
  CHECK(norm(end_of(t, 1) - to) < 1e-12);
}

}  // namespace

TEST_CASE("house ties: along all walls, in their middle") {
  Case c = small_house();
  c.house->ties = {rods(HouseTieKind::along, 0.25)};
  const Model m = build_model(c);
  REQUIRE(m.ties.size() == 4);
  check_run(m.ties[0], "rods 1, front wall at 0.25 m", {0.0, 0.1, 0.25}, {1.2, 0.1, 0.25});
  check_run(m.ties[1], "rods 2, right wall at 0.25 m", {1.1, 0.0, 0.25}, {1.1, 1.0, 0.25});
  check_run(m.ties[2], "rods 3, rear wall at 0.25 m", {0.0, 0.9, 0.25}, {1.2, 0.9, 0.25});
  check_run(m.ties[3], "rods 4, left wall at 0.25 m", {0.1, 0.0, 0.25}, {0.1, 1.0, 0.25});
  REQUIRE(m.tie_bill.size() == 1);
  CHECK(m.tie_bill[0].name == "rods");
  CHECK(m.tie_bill[0].ties == 4);
  CHECK(m.tie_bill[0].anchors == 8);
  CHECK(m.tie_bill[0].length == doctest::Approx(4.4).epsilon(1e-12));
}

TEST_CASE("house ties: rods along a wall that run through an opening of it") {
  Case c = small_house();
  c.house->ties = {rods(HouseTieKind::along, 0.25), rods(HouseTieKind::across, 0.15)};
  c.house->ties[1].at = {0.6};
  CHECK(rods_in_openings(*c.house).empty());
  HouseTie& tie = c.house->ties[0];
  tie.heights = {0.2, 0.15};
  const std::vector<InputError> found = rods_in_openings(*c.house);
  REQUIRE(found.size() == 1);
  CHECK(found[0].what() == std::string("house.tie[0].heights: the rod along the front wall at 0.15 m runs through house.opening[0]"));
  tie.heights = {0.3};
  CHECK(rods_in_openings(*c.house).empty());
  c.house->openings[0].arch = Arch{.rise = 0.15, .thickness = 0.05, .springer = 0.1};
  c.house->openings[0].lintel.reset();
  CHECK(rods_in_openings(*c.house).size() == 1);  // in the room under the arch
  tie.heights = {0.36};
  CHECK(rods_in_openings(*c.house).empty());
  c.house->openings[0].arch.reset();
  tie.heights = {0.15}, tie.depth = 0.2;  // on the inner face
  CHECK(rods_in_openings(*c.house).empty());
  tie.depth = 0.0, tie.walls = {"rear", "left"};
  CHECK(rods_in_openings(*c.house).empty());
}

TEST_CASE("house ties: inside along one wall, across, and across corners, at several heights") {
  Case c = small_house();
  c.base->z = 0.5;
  c.house->ties = {rods(HouseTieKind::along, 0.35), rods(HouseTieKind::across, 0.25), rods(HouseTieKind::corner, 0.25)};
  std::vector<HouseTie>& ties = c.house->ties;
  ties[0].walls = {"rear"}, ties[0].depth = 0.25;
  ties[1].walls = {"front"}, ties[1].at = {0.3, 0.9}, ties[1].bar.name = "cross";
  ties[2].reach = 0.4, ties[2].walls = {"front", "left", "rear"}, ties[2].bar.name = "corner", ties[2].heights = {0.25, 0.35};
  const Model m = build_model(c);
  REQUIRE(m.ties.size() == 1 + 2 + 2 * 2);
  check_run(m.ties[0], "rods", {0.0, 0.75, 0.85}, {1.2, 0.75, 0.85});
  check_run(m.ties[1], "cross 1, front to rear wall, 0.3 m along, at 0.25 m", {0.3, 0.0, 0.75}, {0.3, 1.0, 0.75});
  check_run(m.ties[2], "cross 2, front to rear wall, 0.9 m along, at 0.25 m", {0.9, 0.0, 0.75}, {0.9, 1.0, 0.75});
  check_run(m.ties[3], "corner 1, front left corner at 0.25 m", {0.4, 0.0, 0.75}, {0.0, 0.4, 0.75});
  check_run(m.ties[4], "corner 2, rear left corner at 0.25 m", {0.4, 1.0, 0.75}, {0.0, 0.6, 0.75});
  check_run(m.ties[6], "corner 4, rear left corner at 0.35 m", {0.4, 1.0, 0.85}, {0.0, 0.6, 0.85});
}

TEST_CASE("house ties: turned and copied as the house is") {
  Case c = small_house();
  c.house->ties = {rods(HouseTieKind::corner, 0.25)};
  c.house->ties[0].reach = 0.3;
  c.house->meshes = {mesh()};
  const Model straight = build_model(c);
  c.house->turn = 90.0, c.house->copies = {2, 1}, c.house->origin = {3.0, -2.0};
  const Model turned = build_model(c);
  REQUIRE(turned.ties.size() == 2 * straight.ties.size());
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec3 at = end_of(straight.ties[i], end);
      CHECK(norm(end_of(turned.ties[i], end) - Vec3{3.0 - at.y, at.x - 2.0, at.z}) < 1e-12);
      CHECK(norm(end_of(turned.ties[4 + i], end) - Vec3{11.0 - at.y, at.x - 2.0, at.z}) < 1e-12);
    }
  }
  CHECK(turned.tie_bill[1].area == doctest::Approx(2.0 * straight.tie_bill[1].area).epsilon(1e-12));
}

TEST_CASE("house ties: a mesh holds every brick that a node stands on, from node to node, round the corners and through the wall") {
  Case c = small_house();
  HouseMesh net = mesh();
  net.strength = 3e3, net.elongation = 0.1;
  net.connectors = MeshConnectors{.every = 1, .area = 2e-5, .young = 2e11, .yield = {}, .elongation = {}};
  c.house->meshes = {net};
  const Model m = build_model(c);
  CHECK(own_ties(m) == 0);
  std::set<std::int32_t> held;
  bool round_corner = false, through = false;
  for (const TieBar& t : m.ties) {
    CHECK(t.mesh == 0);
    const Vec3 by = end_of(t, 1) - end_of(t, 0);
    CHECK(t.length == doctest::Approx(norm(by)).epsilon(1e-12));
    CHECK(t.ends[0][0].element != t.ends[1][0].element);
    for (const auto& end : t.ends) held.insert(end[0].element);
    const Vec3 middle = 0.5 * (end_of(t, 0) + end_of(t, 1));
    CHECK(!(middle.y < 0.21 && middle.x > 0.41 && middle.x < 0.79 && middle.z < 0.19));  // nothing hangs in the door
    if (std::abs(by.x) > 1e-9 && std::abs(by.y) > 1e-9) round_corner = true;
    if (t.compression) {
      through = true;
      CHECK(norm(by) == doctest::Approx(0.2).epsilon(1e-12));
      CHECK(t.stiffness == doctest::Approx(2e11 * 2e-5 / 0.2).epsilon(1e-12));
    } else if (std::abs(by.z) > 1e-9) {  // upright, 0.1 m, for 0.2 m of mesh
      CHECK(t.stiffness == doctest::Approx(2e5 * 0.2 / 0.1).epsilon(1e-12));
      CHECK(t.yield == doctest::Approx(600.0).epsilon(1e-12));
      CHECK(t.breaking == doctest::Approx(0.01).epsilon(1e-12));
    }
  }
  CHECK(round_corner);
  CHECK(through);
  const auto bricks = std::ranges::count_if(m.blocks, [](const Block& b) { return b.kind == PartKind::brick; });
  CHECK(static_cast<double>(held.size()) > 0.7 * static_cast<double>(bricks));
  // Outside 2 x (1.2 + 1.0) x 0.4 m less a door of 0.4 x 0.2; inside as far as nodes stand between the corners.
  REQUIRE(m.tie_bill.size() == 1);
  const double outside = 4.4 * 0.4 - 0.08, inside = 2.0 * (0.8 + 0.6) * 0.4 - 0.08;
  CHECK(m.tie_bill[0].area == doctest::Approx(outside + inside).epsilon(0.15));
  CHECK(m.tie_bill[0].anchors > 40);
  CHECK(m.tie_bill[0].length == doctest::Approx(0.5 * static_cast<double>(m.tie_bill[0].anchors) * 0.2).epsilon(1e-9));
}

TEST_CASE("house ties: a bandage, on one face of some walls") {
  Case c = small_house();
  HouseMesh band = mesh();
  band.from = 0.2, band.to = 0.4, band.faces = MeshFaces::outside, band.walls = {"left", "front"};
  c.house->meshes = {band};
  const Model m = build_model(c);
  CHECK(m.tie_bill[0].area == doctest::Approx(2.2 * 0.2).epsilon(1e-12));
  for (const TieBar& t : m.ties) {
    for (std::size_t end = 0; end < 2; ++end) {
      CHECK(end_of(t, end).z > 0.2);
      CHECK(std::min(end_of(t, end).x, end_of(t, end).y) == 0.0);
    }
  }
}

TEST_CASE("house ties: along an inner wall, from outer face to outer face of the walls it meets, in its storey") {
  Case c = small_house();
  InnerWall spine;
  spine.name = "spine", spine.along = PlanAxis::y, spine.at = 0.6, spine.thickness = 0.2;
  c.house->inner_walls = {spine};
  c.house->openings.clear();
  c.house->ties = {rods(HouseTieKind::along, 0.25)};
  c.house->ties[0].walls = {"spine"};
  const Model alone = build_model(c);
  REQUIRE(alone.ties.size() == 1);
  check_run(alone.ties[0], "rods", {0.7, 0.0, 0.25}, {0.7, 1.0, 0.25});
  c.house->ties[0].walls = {"front", "spine"};
  const Model both = build_model(c);
  REQUIRE(both.ties.size() == 2);
  check_run(both.ties[0], "rods 1, front wall at 0.25 m", {0.0, 0.1, 0.25}, {1.2, 0.1, 0.25});
  check_run(both.ties[1], "rods 2, spine wall at 0.25 m", {0.7, 0.0, 0.25}, {0.7, 1.0, 0.25});
  check_refused(
      c,
      [](Case& with) {
        with.house->ties[0].kind = HouseTieKind::across, with.house->ties[0].at = {0.3}, with.house->ties[0].walls = {"front", "spine"};
      },
      "house.tie[0].walls[1]", "is an inner wall; kind = \"along\" ties one");
  check_refused(
      c,
      [](Case& with) {
        with.house->ties[0].walls = {"front", "spin"};
      },
      "house.tie[0].walls[1]", "did you mean \"spine\"?");
  check_refused(
      c, [](Case& with) { with.house->ties[0].heights = {0.5}, with.house->ties[0].walls = {"spine"}; }, "house.tie[0]",
      "none of its walls stands at these heights");
}

TEST_CASE("house ties: names and heights are told with what else of the house is at fault") {
  Case c = small_house();
  c.house->joint = "nrmal";
  c.house->ties = {rods(HouseTieKind::along, 0.25), rods(HouseTieKind::along, 7.0)};
  c.house->ties[0].walls = {"frnt"};
  c.output.history = {testing::history("far", 99.0, 0.0)};
  std::string told = faults_of(c);
  CAPTURE(told);
  CHECK(told.find("house.joint") != std::string::npos);
  CHECK(told.find("\"frnt\" is no wall; did you mean \"front\"?") != std::string::npos);
  CHECK(told.find("house.tie[1].heights[0]: 7 m is above the house") != std::string::npos);
  // What needs the elements comes next: plates and followed points, together.
  c.house->joint = "normal";
  c.house->ties = {rods(HouseTieKind::across, 0.1)};
  c.house->ties[0].walls = {"front"}, c.house->ties[0].at = {0.6};  // in the door
  told = faults_of(c);
  CAPTURE(told);
  CHECK(told.find("house.tie[0]: [0.6, 0, 0.1] m lies on no face") != std::string::npos);
  CHECK(told.find("output.history[0].point: \"far\" lies outside the model") != std::string::npos);
}

TEST_CASE("house ties: what is refused") {
  const auto with = [](HouseTie t, const std::function<void(HouseTie&)>& change) {
    change(t);
    return [t](Case& c) { c.house->ties = {t}; };
  };
  const HouseTie along = rods(HouseTieKind::along, 0.25), across = rods(HouseTieKind::across, 0.25),
                 corner = rods(HouseTieKind::corner, 0.25);
  check_refused(small_house(),
                with(along,
                     [](HouseTie& t) {
                       t.walls = {"front", "north"};
                     }),
                "house.tie[0].walls[1]", "\"north\" is no wall; allowed: \"front\", \"right\", \"rear\", \"left\"");
  check_refused(small_house(), with(along, [](HouseTie& t) { t.heights = {0.9}; }), "house.tie[0].heights[0]",
                "0.9 m is above the house; at most 0.6 m");
  check_refused(small_house(),
                with(across,
                     [](HouseTie& t) {
                       t.at = {0.3, 1.5}, t.walls = {"front"};
                     }),
                "house.tie[0].at[1]", "1.5 m is beyond the end of the front wall (1.2 m)");
  check_refused(small_house(), with(across, [](HouseTie& t) { t.at = {0.6}, t.heights = {0.1}, t.walls = {"front"}; }), "house.tie[0]",
                "[0.6, 0, 0.1] m lies on no face");
  check_refused(small_house(), with(corner, [](HouseTie& t) { t.reach = 1.1; }), "house.tie[0].reach",
                "1.1 m is beyond the end of the left wall (1 m)");
  check_refused(small_house(),
                with(corner,
                     [](HouseTie& t) {
                       t.reach = 0.3, t.walls = {"front", "rear"};
                     }),
                "house.tie[0]", "makes no tie");
  check_refused(
      small_house(),
      [&](Case& c) {
        c.house->roof.kind = RoofKind::none, c.house->walls = {"front", "left"};
        c.house->ties = {across};
        c.house->ties[0].at = {0.3};
      },
      "house.tie[0]", "runs across from the front wall, but the rear wall is not built");
  check_refused(
      small_house(),
      [&](Case& c) {
        c.house->ties = {along, along};
      },
      "house", "\"rods 1, front wall at 0.25 m\" is the name of another tie, too");
  const auto net = [](const std::function<void(HouseMesh&)>& change) {
    HouseMesh m = mesh();
    change(m);
    return [m](Case& c) { c.house->meshes = {m}; };
  };
  check_refused(small_house(), net([](HouseMesh& m) { m.walls = {"up"}; }), "house.mesh[0].walls[0]", "\"up\" is no wall");
  check_refused(small_house(), net([](HouseMesh& m) { m.to = 0.5; }), "house.mesh[0].to", "0.5 m is above the top of the walls (0.4 m)");
  check_refused(small_house(), net([](HouseMesh& m) { m.from = 0.4; }), "house.mesh[0].from",
                "0.4 m is not below the upper edge of the mesh (0.4 m)");
  check_refused(small_house(), net([](HouseMesh& m) { m.spacing = {1e-5, 1e-5}; }), "house.mesh[0].spacing", "nodes (allowed: 1000000)");
  check_refused(small_house(), net([](HouseMesh& m) {
                  m.spacing = {5.0, 5.0}, m.walls = {"front"}, m.faces = MeshFaces::outside;
                }),
                "house.mesh[0]", "holds no two elements");
}

}  // namespace voussoir
