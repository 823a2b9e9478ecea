// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "cases/census.h"
#include "cases/house/house.h"
#include "cases/house/roofs/house_vault.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::check_refused;
using voussoir::testing::opening;

namespace {

/// Area of the half polygon of n corners on a circle of radius r.
double half_polygon(int n, double r) { return 0.5 * n * std::sin(std::numbers::pi / n) * r * r; }
double chord(int n, double r) { return 2.0 * r * std::sin(0.5 * std::numbers::pi / n); }

double wall_volume(const House& h) {
  double v = (2 * (h.inner_size[0] + 2 * h.nonbearing_wall) * h.bearing_wall + 2 * h.inner_size[1] * h.nonbearing_wall) * h.height;
  for (const Opening& o : h.openings) v -= (o.width * o.height + o.lintel->length * o.lintel->height) * h.bearing_wall;
  return v;
}

double lintel_volume(const House& h) {
  double v = 0.0;
  for (const Opening& o : h.openings) v += o.lintel->length * o.lintel->height * h.bearing_wall;
  return v;
}

/// Surface of a vaulted house that touches nothing, m2, from its plan alone; openings stand in the front wall, below its top.
double open_surface(const House& h) {
  const double x = h.inner_size[0], y = h.inner_size[1], tb = h.bearing_wall, tn = h.nonbearing_wall;
  const Roof& r = h.roof;
  const double length = x + 2 * tn, outer = r.radius + r.thickness;
  double area = 2 * (length + y + 2 * tb + x + y) * h.height;
  for (const Opening& o : h.openings) area += 2 * o.height * tb - 2 * o.width * o.height + (o.sill > 0.0 ? 2 : 1) * o.width * tb;
  area += 2 * length * tb + 2 * y * tn - 2 * r.thickness * length - 2 * 2 * r.radius * tn;  // tops of the walls
  area += r.voussoirs * (chord(r.voussoirs, outer) * length + chord(r.voussoirs, r.radius) * x);
  area += 2 * (half_polygon(r.voussoirs, outer) - half_polygon(r.voussoirs, r.radius));  // end faces of the vault
  return area + 4 * half_polygon(r.voussoirs, r.radius);                                 // both faces of both gables
}

void check_all_neighbours_joined(const Case& c) {
  const geometry::Assembly a = build_model(c).assembly;
  double faces = 0.0, joined = 0.0;
  for (const geometry::Face& f : a.faces) faces += f.area;
  for (const geometry::Joint& j : a.joints) joined += j.area * (j.element_b == geometry::kBase ? 1 : 2);
  CHECK(std::abs((joined + open_surface(*c.house)) / faces - 1.0) < 1e-9);
}

}  // namespace

TEST_CASE("the paper's vaulted houses have the sizes to expect") {
  const Census thin = census(build_model(testing::paper_vault20()));
  CHECK(thin.elements == doctest::Approx(5200).epsilon(0.05));
  CHECK(thin.mass == doctest::Approx(25500).epsilon(0.05));
  const Census thick = census(build_model(testing::paper_vault40()));
  CHECK(thick.elements == doctest::Approx(7500).epsilon(0.05));
  CHECK(thick.mass == doctest::Approx(33600).epsilon(0.05));
  const auto sides = [](Case c) {  // the independent program cut all faces at 0.025 m
    c.segment_size = 0.025;
    return static_cast<double>(census(build_model(c)).joint_sides);
  };
  CHECK(sides(testing::paper_vault20()) == doctest::Approx(740000).epsilon(0.05));
  CHECK(sides(testing::paper_vault40()) == doctest::Approx(1100000).epsilon(0.05));
}

TEST_CASE("a vaulted house weighs what its plan says") {
  for (const Case& c : {testing::paper_vault20(), testing::paper_vault40()}) {
    const House& h = *c.house;
    const double vault = (half_polygon(25, 1.7) - half_polygon(25, 1.5)) * 5.4, gables = 2 * 0.2 * half_polygon(25, 1.5);
    const Census n = census(build_model(c));
    CHECK(n.mass == doctest::Approx(1800.0 * (wall_volume(h) + vault + gables) + 700.0 * lintel_volume(h)).epsilon(1e-9));
  }
}

TEST_CASE("cut bricks touch the voussoirs, and every block all its neighbours") {
  for (const Bond bond : {Bond::english, Bond::running}) {
    for (Case c : {testing::paper_vault20(), testing::paper_vault40()}) {
      c.house->bond = bond;
      check_all_neighbours_joined(c);
      c.house->roof.voussoirs = 8;  // a corner at the crown
      check_all_neighbours_joined(c);
      c.house->roof.radius = 1.5;
      c.house->bearing_wall = 0.3;
      c.house->roof.radius = 1.55;  // on the middle of the wall: gables end on the bearing walls
      check_all_neighbours_joined(c);
    }
  }
}

TEST_CASE("no piece of a gable is a sliver") {
  const Model model = build_model(testing::paper_vault20());
  std::set<std::size_t> corners;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (model.blocks[i].tag.find("gable") == std::string::npos) continue;
    const geometry::Element& e = model.assembly.elements[i];
    CHECK(e.mass.volume > 0.5 * 0.2 * 0.1 * 0.1 * (1.0 - 1e-9));
    for (std::int32_t f = 0; f < e.face_count; ++f)
      CHECK(model.assembly.faces[static_cast<std::size_t>(e.first_face + f)].distance > 0.125 * 0.1);
    corners.insert(model.blocks[i].shape.vertices.size() / 2);
  }
  CHECK(corners == std::set<std::size_t>{4, 5});
}

TEST_CASE("rings stand one behind the other, their ends in one plane") {
  const std::vector<NamedMaterial> materials{{"adobe", {1800.0, 9.8e7, 0.25}}, {"wood", {700.0, 6.3e8, 0.3}}};
  const std::vector<Block> blocks = build_house(*testing::paper_vault20().house, materials);
  std::map<std::string, int> rings;
  for (const Block& b : blocks) {
    if (b.kind != PartKind::voussoir) continue;
    ++rings[b.tag];
    CHECK(b.segment_size == doctest::Approx(0.05));
    for (const Vec3 v : b.shape.vertices) {
      const double r = std::hypot(v.y - 1.7, v.z - 2.4);
      CHECK((std::abs(r - 1.5) < 1e-12 || std::abs(r - 1.7) < 1e-12));
    }
  }
  CHECK(rings.size() == 27);
  CHECK(std::all_of(rings.begin(), rings.end(), [](const auto& r) { return r.second == 25; }));
}

TEST_CASE("vaults off their walls are refused") {
  const Case good = testing::paper_vault20();
  check_refused(
      good, [](House& h) { h.roof.radius = 1.4; }, "house.roof.radius", "allowed: 1.5 to 1.5 m");
  check_refused(
      good, [](House& h) { h.bearing_wall = 0.4, h.roof.radius = 1.8; }, "house.roof.radius", "allowed: 1.5 to 1.7 m");
  check_refused(
      good, [](House& h) { h.roof.thickness = 0.3; }, "house.roof.thickness", "at most 0.2 m");
  check_refused(
      good, [](House& h) { h.roof.voussoirs = 2; }, "house.roof.voussoirs", "allowed: 3 to 1000");
  check_refused(
      good, [](House& h) { h.roof.ring = 0.001; }, "house.roof.ring", "more than 1000 parts");
  check_refused(
      good,
      [](House& h) {
        h.walls = {"front", "left", "right"}, h.openings.clear();
      },
      "house.roof.kind", "leaves one of them out");
  check_refused(
      good, [](House& h) { h.roof.kind = RoofKind::gables, h.roof.radius = 1.8; }, "house.roof.radius", "allowed: 0.2 to 1.7 m");
  check_refused(
      good, [](House& h) { h.roof.kind = RoofKind::gables, h.walls = {"front"}; }, "house.roof.kind", "leaves out both");
}

TEST_CASE("a surcharge adds its mass to the roof alone, and leaves the joint rules as they are") {
  Case flat = testing::paper_flat20();
  const double bare = census(build_model(flat)).mass;
  flat.house->roof.surcharge = 150.0;
  CHECK(census(build_model(flat)).mass == doctest::Approx(bare + 150.0 * 5.4 * 3.4).epsilon(1e-12));
  CHECK(census(build_model(flat)).step_bound == doctest::Approx(5.03e-5).epsilon(0.001).scale(0.0));  // still the lintel's
  Case vault = testing::paper_vault20();
  const double bare_vault = census(build_model(vault)).mass;
  vault.house->roof.surcharge = 80.0;
  CHECK(census(build_model(vault)).mass == doctest::Approx(bare_vault + 80.0 * 25 * chord(25, 1.7) * 5.4).epsilon(1e-12));
  check_refused(
      testing::paper_flat20(), [](House& h) { h.roof.kind = RoofKind::none, h.roof.surcharge = 10.0; }, "house.roof.surcharge",
      "no roof to carry it");

  flat.joints.default_law = "strong";
  flat.joints.between = {{{"wood", "adobe"}, "weak"}};
  BlockSpec prop;
  prop.name = "prop", prop.material = "adobe";
  prop.box = {Vec3{0.0, -0.2, 2.4}, Vec3{0.2, 0.0, 2.6}};
  prop.free = true;
  flat.blocks = {prop};
  const Model model = build_model(flat);
  const auto last = static_cast<std::int32_t>(model.blocks.size()) - 1;
  for (std::size_t i = 0; i < model.joint_law.size(); ++i) {
    const geometry::Joint& j = model.assembly.joints[i];
    if (j.element_b == last) CHECK(model.laws[static_cast<std::size_t>(model.joint_law[i])].name == "weak");
  }
}

TEST_CASE("walls that are left out: the others run to their ends") {
  Case c = testing::paper_vault20();
  c.house->openings.clear();
  c.house->walls = {"left"};
  c.house->roof.kind = RoofKind::gables;
  const Census n = census(build_model(c));
  CHECK(n.volume == doctest::Approx(0.2 * (3.4 * 2.4 + half_polygon(25, 1.5))).epsilon(1e-9));
  c.house->walls = {"front", "rear"};
  c.house->roof.kind = RoofKind::vault;
  CHECK(census(build_model(c)).volume ==
        doctest::Approx(5.4 * (2 * 0.2 * 2.4 + half_polygon(25, 1.7) - half_polygon(25, 1.5))).epsilon(1e-9));
  check_refused(
      c,
      [](House& h) {
        h.walls = {"front", "north"};
      },
      "house.walls[1]", "is no wall");
  check_refused(
      c,
      [](House& h) {
        h.walls = {"rear", "rear"};
      },
      "house.walls[1]", "twice");
  check_refused(
      c, [](House& h) { h.walls.clear(); }, "house.walls", "names no wall");
  check_refused(
      c, [](House& h) { h.openings = {opening("left", 1.0, 1.0, 0.0, 1.0)}; }, "house.opening[0].wall", "not built");
  check_refused(
      c, [](House& h) { h.roof.kind = RoofKind::flat, h.walls = {"front"}; }, "house.roof.kind", "leaves one of them out");
}
