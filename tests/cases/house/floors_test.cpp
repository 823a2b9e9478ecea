// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// Floors of a house: beams in their pockets, what anchors them, decks as shear panels, and what is refused.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;
using testing::opening;
using Change = std::function<void(House&)>;

/// Outer size 2.4 x 1.6 m, walls 0.2 m thick and 0.6 m high; three beams 0.1 x 0.2 m along y, 0.6 m apart, with pockets of 0.1 m.
Case with_floor() {
  Case c = testing::paper_flat20();
  c.output.history.clear();
  House& h = *c.house;
  h.inner_size = {2.0, 1.2};
  h.height = 0.6;
  h.openings.clear();
  h.roof.kind = RoofKind::none;
  h.floors = {Floor{}};
  return c;
}

BeamAnchor anchor() {
  BeamAnchor a;
  a.bar.area = 1e-4, a.bar.young = 2e11, a.bar.yield = 2.4e8;
  return a;
}

Case with_deck() {
  Case c = with_floor();
  c.house->floors[0].deck = Deck{.shear_stiffness = 8e5, .shear_strength = 5e3, .stiffness = 2e7, .strength = 4e4};
  return c;
}

Vec3 end_of(const TieBar& t, std::size_t end) {
  Vec3 at;
  for (const TieHold& h : t.ends[end]) at += h.share * h.point;
  return at;
}

const Block& held(const Model& m, const TieBar& t, std::size_t end) { return m.blocks[static_cast<std::size_t>(t.ends[end][0].element)]; }

/// Force along y on the beams at or below x from those beyond, if every beam slides along itself by angle * x.
double shear_force(const Model& m, double x, double angle) {
  double sum = 0.0;
  for (const TieBar& t : m.ties) {
    Vec3 a = t.ends[0][0].point, b = t.ends[1][0].point;
    if (a.x > b.x) std::swap(a, b);
    if (a.x > x || b.x <= x) continue;
    const Vec3 along = normalised(b - a);
    const double elongation = angle * (b.x - a.x) * along.y;
    const double force = std::clamp(t.stiffness * elongation, -t.yield, t.yield);
    sum += force * along.y;
  }
  return sum;
}

}  // namespace

TEST_CASE("floors: beams lie in pockets of half the wall, flush with its top") {
  const Model m = build_model(with_floor());
  geometry::Polyhedron beams;
  double timber = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const Block& b = m.blocks[i];
    if (b.kind != PartKind::floor_beam) continue;
    const geometry::Box3 box = geometry::bounds(b.shape);
    beams.vertices.insert(beams.vertices.end(), b.shape.vertices.begin(), b.shape.vertices.end());
    timber += m.assembly.elements[i].mass.volume;
    if (b.tag == "floor 1 beam 1") CHECK(box.low.x == doctest::Approx(1.15).epsilon(1e-12));
  }
  const geometry::Box3 all = geometry::bounds(beams);
  CHECK(norm(all.low - Vec3{0.55, 0.1, 0.4}) < 1e-12);
  CHECK(norm(all.high - Vec3{1.85, 1.5, 0.6}) < 1e-12);
  CHECK(timber == doctest::Approx(3 * 0.1 * 0.2 * 1.4).epsilon(1e-12));
  double bricks = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i)
    bricks += m.blocks[i].kind == PartKind::brick ? m.assembly.elements[i].mass.volume : 0.0;
  CHECK(bricks == doctest::Approx((2 * 2.4 + 2 * 1.2) * 0.2 * 0.6 - 3 * 2 * 0.1 * 0.1 * 0.2).epsilon(1e-12));
}

TEST_CASE("floors: beams touch the walls by the floor's own law, dry if none is given") {
  Case c = with_floor();
  SUBCASE("dry") {}
  SUBCASE("mortar") { c.house->floors[0].joint = "weak"; }
  const Model m = build_model(c);
  int joints = 0;
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    if (j.element_b == geometry::kBase) continue;
    const Block &a = m.blocks[static_cast<std::size_t>(j.element_a)], &b = m.blocks[static_cast<std::size_t>(j.element_b)];
    if ((a.member >= 0) == (b.member >= 0)) continue;
    ++joints;
    CHECK(m.laws[static_cast<std::size_t>(m.joint_law[i])].name == c.house->floors[0].joint);
  }
  CHECK(joints >= 3 * 2 * 4);  // an end has its bed, its back and two sides at least
}

TEST_CASE("floors: the load of a strip as wide as the beams are apart lies on each") {
  Case c = with_floor();
  c.house->floors[0].load = 100.0;
  const Model m = build_model(c);
  double mass = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].kind == PartKind::floor_beam)
      mass += m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density;
  }
  CHECK(mass == doctest::Approx(3 * 1.4 * (0.1 * 0.2 * 700.0 + 0.6 * 100.0)).epsilon(1e-12));
}

TEST_CASE("floors: beams of every room, through the inner walls across them") {
  Case c = with_floor();
  InnerWall across, beside;
  across.name = "across", across.along = PlanAxis::x, across.at = 0.7;
  beside.name = "beside", beside.along = PlanAxis::y, beside.at = 1.3;
  c.house->inner_walls = {across, beside};
  c.house->floors[0].spacing = 0.4;
  const Model m = build_model(c);
  std::vector<double> axes;
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (b.kind == PartKind::floor_beam && box.low.y < 0.1 + 1e-9) axes.push_back(0.5 * (box.low.x + box.high.x));
  }
  std::ranges::sort(axes);
  const std::vector<double> expected{0.35, 0.75, 1.15, 1.65, 2.05};  // rooms of 1.1 and 0.7 m: 0.9 and 0.5 m for beams 0.4 m apart
  REQUIRE(axes.size() == expected.size());
  for (std::size_t i = 0; i < axes.size(); ++i) CHECK(axes[i] == doctest::Approx(expected[i]).epsilon(1e-12));
}

TEST_CASE("floors: anchors run from the beam to the outer face, nails to the brick under its end") {
  Case c = with_floor();
  Floor& f = c.house->floors[0];
  f.anchor = anchor();
  SUBCASE("anchor") {
    f.anchorage = Anchorage::anchor;
    f.anchor->bar.plate = {{0.1, 0.1}};
    const Model m = build_model(c);
    REQUIRE(m.ties.size() == 6);
    CHECK(norm(end_of(m.ties[0], 0) - Vec3{0.6, 0.5, 0.5}) < 1e-12);
    CHECK(norm(end_of(m.ties[0], 1) - Vec3{0.6, 0.0, 0.5}) < 1e-12);
    CHECK(held(m, m.ties[0], 0).kind == PartKind::floor_beam);
    CHECK(held(m, m.ties[0], 1).tag == "front wall");
    CHECK(held(m, m.ties[1], 1).tag == "rear wall");
    REQUIRE(m.tie_bill.size() == 1);
    CHECK(m.tie_bill[0].length == doctest::Approx(6 * 0.5).epsilon(1e-12));
  }
  SUBCASE("nailed, every second beam") {
    f.anchorage = Anchorage::nailed;
    f.anchor->every = 2;
    const Model m = build_model(c);
    REQUIRE(m.ties.size() == 4);
    CHECK(norm(end_of(m.ties[0], 1) - Vec3{0.6, 0.15, 0.375}) < 1e-12);
    CHECK(held(m, m.ties[2], 0).tag == "floor 1 beam 2");
    CHECK(held(m, m.ties[2], 1).tag == "front wall");
  }
}

TEST_CASE("decks: the shear panel's stiffness G t and its strength, on every beam") {
  const Model m = build_model(with_deck());
  double low = 1.0, high = 0.0;
  for (const TieBar& t : m.ties) {
    for (const auto& end : t.ends) low = std::min(low, end[0].point.y), high = std::max(high, end[0].point.y);
    CHECK(t.compression);
  }
  const double length = high - low;
  CHECK(length > 0.7);
  for (const double x : {0.7, 1.3}) {  // between first and second, second and third beam
    CHECK(shear_force(m, x, 1e-4) == doctest::Approx(8e5 * 1e-4 * length).epsilon(1e-9));
    CHECK(shear_force(m, x, 1.0) == doctest::Approx(5e3 * length).epsilon(1e-9));
  }
}

TEST_CASE("decks: across the beams the strips' stiffness and the diagonals' share") {
  Case c = with_deck();
  c.house->floors[0].deck->shear_stiffness = 1.0;
  const Model m = build_model(c);
  double stretch = 0.0, low = 1.0, high = 0.0;
  for (const TieBar& t : m.ties) {
    for (const auto& end : t.ends) low = std::min(low, end[0].point.y), high = std::max(high, end[0].point.y);
    const Vec3 a = t.ends[0][0].point, b = t.ends[1][0].point;
    if (std::min(a.x, b.x) < 0.7 && std::max(a.x, b.x) < 1.3) stretch += t.stiffness * (std::abs(b.x - a.x) / norm(b - a));
  }
  CHECK(stretch == doctest::Approx(2e7 * (high - low) / 0.6).epsilon(1e-6));  // force over the gap's opening
}

TEST_CASE("floors: what is refused") {
  const Case c = with_floor();
  const auto floor = [](House& h) -> Floor& { return h.floors[0]; };
  check_refused(c, Change([&](House& h) { floor(h).storey = 2; }), "house.floor[0].storey", "there is no storey 2; allowed: 1 to 1");
  check_refused(c, Change([&](House& h) { h.floors.push_back(floor(h)); }), "house.floor[1].storey", "has house.floor[0] already");
  check_refused(c, Change([&](House& h) { floor(h).beam = {0.1, 0.6}; }), "house.floor[0].beam", "less than the height of the storey");
  check_refused(c, Change([&](House& h) { floor(h).beam = {1.9, 0.2}, floor(h).spacing = 3.0; }), "house.floor[0].beam", "too wide");
  check_refused(c, Change([&](House& h) { floor(h).spacing = 0.15; }), "house.floor[0].spacing", "at least 0.2 m");
  check_refused(
      c, Change([&](House& h) { floor(h).bearing = 0.16; }), "house.floor[0].bearing",
      "makes pockets that cut bricks of the front wall to 0.04 m behind the beams; a cut brick has at least 0.05 m, half its width; "
      "nearest that fit: 0.2 or 0.15 m");
  check_refused(c, Change([&](House& h) { floor(h).bearing = 0.3; }), "house.floor[0].bearing", "at most 0.2 m");
  check_refused(c, Change([&](House& h) { floor(h).element = 1e-6; }), "house.floor[0].element", "more than 1000 parts");
  check_refused(c, Change([&](House& h) { floor(h).load = -1.0; }), "house.floor[0].load", "allowed: 0 to");
  check_refused(c, Change([&](House& h) { floor(h).joint = "glue"; }), "house.floor[0].joint", "unknown");
  check_refused(c, Change([&](House& h) { h.walls = {"front", "left", "right"}; }), "house.floor[0]", "rest on the rear wall");
  check_refused(c, Change([&](House& h) { h.openings = {opening("front", 0.4, 0.6, 0.3, 0.3)}; }), "house.floor[0].beam",
                "lies in house.opening[0]");
  check_refused(c,
                Change([&](House& h) { floor(h).anchorage = Anchorage::anchor, floor(h).anchor = anchor(), floor(h).anchor->reach = 0.6; }),
                "house.floor[0].anchor.reach", "half the span of the beams, 0.6 m");
  check_refused(c, Change([&](House& h) { floor(h).anchorage = Anchorage::anchor, floor(h).anchor = anchor(), floor(h).bearing = 0.2; }),
                "house.floor[0].bearing", "leaves nothing of the front wall");
  check_refused(c, Change([&](House& h) {
                  floor(h).deck = Deck{.shear_stiffness = 1e6, .shear_strength = {}, .stiffness = 1e6, .strength = {}},
                  floor(h).spacing = 1.9;
                }),
                "house.floor[0].deck", "spans nothing");
}

}  // namespace voussoir
