// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// Pitched roofs: rafters on their seats, ridge, ties, boards, gables under them; and piers. What is refused.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;
using testing::opening;
using Change = std::function<void(House&)>;

constexpr double kPitch = std::numbers::pi / 6;

/// Outer size 2.4 x 1.6 m, walls 0.2 m thick and 0.6 m high, rafters 0.08 x 0.16 m at 30 degrees.
Case with_rafters() {
  Case c = testing::paper_flat20();
  c.output.history.clear();
  House& h = *c.house;
  h.inner_size = {2.0, 1.2};
  h.height = 0.6;
  h.openings.clear();
  h.roof = {};
  h.roof.kind = RoofKind::pitched;
  h.roof.beam = {0.08, 0.16};
  h.roof.element = 0.4;
  return c;
}

/// Its joints of two elements, both of which the test takes.
template <class Of>
std::vector<std::size_t> joints_of(const Model& m, const Of& of) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    if (j.element_b == geometry::kBase) continue;
    const Block &a = m.blocks[static_cast<std::size_t>(j.element_a)], &b = m.blocks[static_cast<std::size_t>(j.element_b)];
    if (of(a, b) || of(b, a)) found.push_back(i);
  }
  return found;
}

bool is_rafter(const Block& b) { return b.kind == PartKind::beam; }

}  // namespace

TEST_CASE("rafters: pairs from end to end of the house, seated on both walls, meeting in the ridge") {
  const Model m = build_model(with_rafters());
  std::vector<double> places;
  double top = 0.0, low = 9.0;
  for (const Block& b : m.blocks) {
    if (!is_rafter(b)) continue;
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (b.tag == "rafter 0" || b.tag == "rafter 2" || b.tag == "rafter 4" || b.tag == "rafter 6") places.push_back(box.low.x);
    top = std::max(top, box.high.z), low = std::min(low, box.low.z);
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end(), [](double a, double b) { return std::abs(a - b) < 1e-9; }), places.end());
  REQUIRE(places.size() == 4);  // bays of (2.4 - 0.08) / 3 m
  for (std::size_t i = 0; i < 4; ++i) CHECK(places[i] == doctest::Approx(2.32 / 3 * static_cast<double>(i)).epsilon(1e-12));
  CHECK(low == doctest::Approx(0.6).epsilon(1e-12));
  CHECK(top == doctest::Approx(0.6 + 0.6 * std::tan(kPitch) + 0.16 / std::cos(kPitch)).epsilon(1e-12));

  double ridge = 0.0, seats = 0.0;
  for (const std::size_t i :
       joints_of(m, [](const Block&a, const Block&b) { return is_rafter(a) && is_rafter(b) && a.member < b.member; })) {
    CHECK(m.laws[static_cast<std::size_t>(m.joint_law[i])].name == "normal");
    CHECK(std::abs(m.assembly.joints[i].frame().normal.y) == doctest::Approx(1.0).epsilon(1e-9));
    ridge += m.assembly.joints[i].area;
  }
  for (const std::size_t i : joints_of(m, [](const Block&a, const Block&b) { return is_rafter(a) && b.kind == PartKind::brick; }))
    if (std::abs(m.assembly.joints[i].frame().normal.z) > 0.999) seats += m.assembly.joints[i].area;
  CHECK(ridge == doctest::Approx(4 * 0.08 * 0.16 / std::cos(kPitch)).epsilon(1e-9));
  CHECK(seats == doctest::Approx(8 * 0.08 * 0.08 / std::sin(kPitch)).epsilon(1e-9));  // half the depth over the slope
}

TEST_CASE("rafters: gables fill the space under the first and the last pair and touch them") {
  const Model m = build_model(with_rafters());
  double gables = 0.0, touching = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) gables += m.blocks[i].tag.ends_with("gable") ? m.assembly.elements[i].mass.volume : 0.0;
  CHECK(gables == doctest::Approx(2 * 0.2 * 0.6 * 0.6 * std::tan(kPitch)).epsilon(1e-9));
  for (const std::size_t i : joints_of(m, [](const Block&a, const Block&b) { return is_rafter(a) && b.tag.ends_with("gable"); }))
    touching += m.assembly.joints[i].area;
  CHECK(touching == doctest::Approx(4 * 0.08 * 0.6 / std::cos(kPitch)).epsilon(1e-9));
}

TEST_CASE("rafters: ties from foot to foot, boards as shear panels in the slopes, tiles as mass") {
  Case c = with_rafters();
  Roof& roof = c.house->roof;
  roof.tie.emplace().area = 1e-4;
  roof.deck = Deck{.shear_stiffness = 5e5, .shear_strength = {}, .stiffness = 1e7, .strength = {}};
  roof.surcharge = 60.0;
  const Model m = build_model(c);
  REQUIRE(m.ties.size() > 4);
  CHECK(m.ties[0].name == "roof tie 1");
  CHECK(m.ties[0].length == doctest::Approx(1.2).epsilon(1e-12));
  CHECK(m.blocks[static_cast<std::size_t>(m.ties[0].ends[0][0].element)].tag == "rafter 0");
  CHECK(m.blocks[static_cast<std::size_t>(m.ties[0].ends[1][0].element)].tag == "rafter 1");
  // A shear angle in the plane of the front slope stores what a panel G t does.
  double energy = 0.0, area = 0.0;
  const Vec3 up{0, std::cos(kPitch), std::sin(kPitch)};
  for (const TieBar& t : m.ties) {
    if (t.mesh < 0 || t.ends[0][0].point.y > 0.8 || t.ends[1][0].point.y > 0.8) continue;
    const Vec3 along = t.ends[1][0].point - t.ends[0][0].point;
    const double elongation = 1e-3 * along.x * dot(normalised(along), up);
    energy += 0.5 * t.stiffness * elongation * elongation;
  }
  for (const TieBill& b : m.tie_bill) area += b.name == "roof deck" ? 0.5 * b.area : 0.0;
  CHECK(energy == doctest::Approx(0.5 * 5e5 * 1e-6 * area).epsilon(1e-9));
  double mass = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (!is_rafter(m.blocks[i])) continue;
    volume += m.assembly.elements[i].mass.volume;
    mass += m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[i].material)].value.density;
  }
  const double slope = (0.6 + 0.08 / std::sin(kPitch)) / std::cos(kPitch);
  CHECK(mass == doctest::Approx(700.0 * volume + 60.0 * 2 * 2.4 * slope).epsilon(1e-9));
}

TEST_CASE("piers: every second course runs through the wall, up to their height") {
  Case c = with_rafters();
  c.house->roof = {};
  Pier pier;
  pier.wall = "rear", pier.from = 1.0, pier.width = 0.4, pier.depth = 0.3, pier.height = 0.4;
  c.house->piers = {pier};
  const Model m = build_model(c);
  double volume = 0.0;
  std::vector<long> through;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].tag != "rear pier 0") continue;
    volume += m.assembly.elements[i].mass.volume;
    const geometry::Box3 box = geometry::bounds(m.blocks[i].shape);
    CHECK(box.high.z < 0.4 + 1e-9);
    if (box.low.y < 1.6 - 1e-9) through.push_back(std::lround(1e3 * box.low.z));
  }
  std::ranges::sort(through);
  CHECK(volume == doctest::Approx(0.4 * 0.3 * 0.4 + 0.4 * 0.2 * 0.2).epsilon(1e-9));  // what stands out, and two courses of the wall
  REQUIRE(!through.empty());
  CHECK(through.front() == 100);
  CHECK(through.back() == 300);
}

TEST_CASE("header bond: a wall of one brick's length is all headers, half a header off in every second course") {
  Case c = with_rafters();
  c.house->roof = {};
  c.house->bond = Bond::header;
  const Model m = build_model(c);
  int headers = 0;
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    if (b.tag != "front wall") continue;
    CHECK(box.high.y - box.low.y == doctest::Approx(0.2).epsilon(1e-12));
    if (!b.whole) continue;
    ++headers;
    const double course = std::round(box.low.z / 0.1), place = box.low.x / 0.1 - (std::fmod(course, 2.0) == 0.0 ? 0.0 : 0.5);
    CHECK(std::abs(place - std::round(place)) < 1e-9);
  }
  CHECK(headers > 100);
}

TEST_CASE("pitched roofs and piers: what is refused") {
  const Case c = with_rafters();
  const auto pier = [](House& h) -> Pier& {
    Pier p;
    p.wall = "front", p.from = 1.0, p.width = 0.2;
    return h.piers.emplace_back(p);
  };
  check_refused(c, Change([](House& h) { h.roof.pitch = 70.0; }), "house.roof.pitch", "allowed: 5 to 60");
  check_refused(c, Change([](House& h) { h.roof.beam = {1.3, 0.1}; }), "house.roof.beam", "at most 1.2 m");
  check_refused(c, Change([](House& h) { h.roof.spacing = 0.05; }), "house.roof.spacing", "less than the width of a rafter");
  check_refused(c, Change([](House& h) { h.roof.element = 1e-5; }), "house.roof.element", "more than 1000 parts");
  check_refused(c, Change([](House& h) {
                  h.walls = {"front", "left", "right"};
                }),
                "house.roof.kind", "rest on the front and the rear wall");
  check_refused(c, Change([](House& h) {
                  h.roof.element = 2.0, h.roof.deck = Deck{.shear_stiffness = 1e6, .shear_strength = {}, .stiffness = 1e6, .strength = {}};
                }),
                "house.roof.deck", "less than two elements");
  check_refused(c, Change([](House& h) { h.reinforcement.emplace().ring_beam_place = RingPlace::middle; }),
                "house.reinforcement.ring_beam_place", "does not go with this roof");
  check_refused(c, Change([&](House& h) { pier(h).wall = "middle"; }), "house.pier[0].wall", "is no outer wall; allowed: front");
  check_refused(c, Change([&](House& h) {
                  pier(h), h.roof.kind = RoofKind::none, h.walls = {"left", "right", "rear"};
                }),
                "house.pier[0].wall", "is not built");
  check_refused(c, Change([&](House& h) { pier(h).from = 0.2; }), "house.pier[0].from",
                "at a corner of the front wall; allowed: 0.3 to 1.9 m");
  check_refused(c, Change([&](House& h) { pier(h).width = 0.06; }), "house.pier[0].width", "at least 0.067 m");
  check_refused(c, Change([&](House& h) { pier(h).depth = 0.05; }), "house.pier[0].depth", "at least 0.1 m");
  check_refused(c, Change([&](House& h) { pier(h).height = 0.7; }), "house.pier[0].height", "at most 0.6 m");
  check_refused(c, Change([&](House& h) { pier(h).height = 0.57; }), "house.pier[0].height", "nearest");
  check_refused(c, Change([&](House& h) { pier(h), pier(h).from = 1.25; }), "house.pier[1].from", "where another wall or pier meets");
  check_refused(c, Change([&](House& h) { pier(h), h.openings = {opening("front", 0.9, 0.4, 0.0, 0.2)}; }), "house.opening[0].from",
                "where the front pier meets the front wall");
  check_refused(c, Change([&](House& h) {
                  pier(h), pier(h).wall = "left", h.piers[1].from = 0.7, h.copies = {2, 1}, h.spacing = {2.5, 9};
                }),
                "house.spacing", "at least 2.7 m");
  check_refused(c, Change([&](House& h) { pier(h), h.roof.kind = RoofKind::none, h.floors = {Floor{}}, h.floors[0].spacing = 0.2; }),
                "house.pier[0].from", "where a beam of house.floor[0] ends");
}

}  // namespace voussoir
