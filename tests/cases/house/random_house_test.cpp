// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>

#include "cases/census.h"
#include "geometry/grid.h"
#include "geometry/polygon.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

/// Houses drawn from the ranges of the keys; set VOUSSOIR_RANDOM_HOUSES for more of them.
namespace {

int houses_to_try() {
  const char* wanted = std::getenv("VOUSSOIR_RANDOM_HOUSES");
  return wanted == nullptr ? 120 : std::atoi(wanted);
}

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool one_in(int n) { return whole(1, n) == 1; }
  /// A multiple of `step` above `low`.
  double pick(double low, double high, double step) { return low + step * whole(0, static_cast<int>(std::lround((high - low) / step))); }

 private:
  std::mt19937 random_;
};

void add_openings(Dice& dice, House& h) {
  for (int i = dice.whole(0, 2); i > 0; --i) {
    const char* walls[] = {"front", "rear", "left", "right"};
    const double step = dice.one_in(3) ? 0.01 : 0.05;
    const double level = dice.one_in(3) ? 0.01 : 0.1;
    Opening o = opening(walls[dice.whole(0, 3)], dice.pick(0.2, 1.6, step), dice.pick(0.2, 0.8, step), dice.pick(0.0, 0.5, level),
                        dice.pick(0.1, 0.6, level));
    if (dice.one_in(2)) o.lintel = Lintel{o.width + dice.pick(0.1, 0.4, step), dice.pick(0.08, 0.12, 0.02), dice.pick(0.1, 0.3, 0.05)};
    h.openings.push_back(o);
  }
}

void add_roof(Dice& dice, House& h) {
  Roof& r = h.roof;
  r.kind = std::array{RoofKind::none, RoofKind::flat, RoofKind::vault, RoofKind::vault,
                      RoofKind::gables}[static_cast<std::size_t>(dice.whole(0, 4))];
  r.beam = {dice.pick(0.1, 0.3, 0.05), dice.pick(0.1, 0.2, 0.05)};
  r.element = dice.pick(0.15, 0.3, 0.05);
  r.thickness = std::min(h.bearing_wall, dice.pick(0.1, 0.3, 0.05));
  const double play = h.bearing_wall - r.thickness;
  r.radius = 0.5 * h.inner_size[1] + 0.001 * dice.whole(0, static_cast<int>(1000 * play));
  r.voussoirs = std::max(3, static_cast<int>(std::numbers::pi * r.radius / dice.pick(0.15, 0.4, 0.01)));
  r.ring = dice.pick(0.1, 0.3, 0.03);
  if (dice.one_in(3) && r.kind != RoofKind::none && r.kind != RoofKind::gables) r.surcharge = dice.pick(10.0, 200.0, 10.0);
}

void add_reinforcement(Dice& dice, House& h) {
  Reinforcement r;
  r.column = {dice.pick(0.05, 0.15, 0.05), dice.pick(0.05, 0.15, 0.05)};
  r.ring_beam = {dice.pick(0.05, 0.15, 0.05), dice.pick(0.05, 0.2, 0.05)};
  for (int i = dice.whole(0, 3); i > 0; --i) r.bearing.push_back(h.nonbearing_wall + dice.pick(0.1, 1.5, 0.05));
  for (int i = dice.whole(0, 2); i > 0; --i) r.nonbearing.push_back(h.bearing_wall + dice.pick(0.1, 1.2, 0.05));
  r.element = dice.pick(0.15, 0.3, 0.05);
  h.reinforcement = r;
}

Case random_case(Dice& dice) {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.openings.clear();
  h.bond = dice.one_in(2) ? Bond::english : Bond::running;
  const double step = dice.one_in(3) ? 0.013 : 0.1;
  h.inner_size = {dice.pick(0.6, 2.2, step), dice.pick(0.8, 2.4, step)};
  h.height = dice.pick(0.3, 1.2, 0.1);
  h.bearing_wall = dice.pick(0.1, 0.5, 0.1);
  h.nonbearing_wall = dice.pick(0.1, 0.4, 0.1);
  if (dice.one_in(4)) h.height = dice.pick(0.3, 1.2, 0.01);
  if (dice.one_in(6)) h.brick = {0.25, 0.12, 0.065}, h.mortar = 0.01, h.bearing_wall = 0.26, h.nonbearing_wall = 0.13;
  else if (dice.one_in(5)) h.brick = {0.24, 0.12, 0.08}, h.bearing_wall = 0.24, h.nonbearing_wall = 0.12, h.height = 0.64;
  add_roof(dice, h);
  add_openings(dice, h);
  if (dice.one_in(3)) add_reinforcement(dice, h);
  if (dice.one_in(6)) h.walls = {"front", "rear", "left"};
  if (dice.one_in(4)) h.copies = {2, 1};
  h.turn = 90.0 * dice.whole(0, 3);
  h.origin = {dice.pick(-3.0, 3.0, 0.1), dice.pick(-3.0, 3.0, 0.01)};
  c.base->z = dice.one_in(5) ? 1.3 : 0.0;
  return c;
}

double half_polygon(int n, double r) { return 0.5 * n * std::sin(std::numbers::pi / n) * r * r; }

/// Mass of a house of four walls from its plan alone, kg.
double expected_mass(const House& h, const Case& c) {
  const double adobe = c.materials.at("adobe").density, wood = c.materials.at("wood").density;
  const double x = h.inner_size[0], y = h.inner_size[1], length = x + 2 * h.nonbearing_wall, depth = y + 2 * h.bearing_wall;
  double masonry = (2 * length * h.bearing_wall + 2 * y * h.nonbearing_wall) * h.height, timber = 0.0, surcharge = 0.0;
  for (const Opening& o : h.openings) {
    const double thickness = o.wall == "front" || o.wall == "rear" ? h.bearing_wall : h.nonbearing_wall;
    const double lintel = o.lintel ? o.lintel->length * o.lintel->height * thickness : 0.0;
    masonry -= o.width * o.height * thickness + lintel;
    timber += lintel;
  }
  const Roof& r = h.roof;
  if (r.kind == RoofKind::flat) {
    const double across = depth - 2 * (h.bearing_wall - std::min(h.bearing_wall, h.brick[0] + h.mortar));
    timber += length * across * r.beam[1];
    surcharge = r.surcharge * length * across;
  }
  if (r.kind == RoofKind::vault || r.kind == RoofKind::gables) masonry += 2 * h.nonbearing_wall * half_polygon(r.voussoirs, r.radius);
  if (r.kind == RoofKind::vault) {
    const double outer = r.radius + r.thickness;
    masonry += length * (half_polygon(r.voussoirs, outer) - half_polygon(r.voussoirs, r.radius));
    surcharge = r.surcharge * length * r.voussoirs * 2 * outer * std::sin(0.5 * std::numbers::pi / r.voussoirs);
  }
  if (h.reinforcement) {
    const Reinforcement& f = *h.reinforcement;
    timber += 2.0 * static_cast<double>(f.bearing.size() + f.nonbearing.size()) * f.column[0] * f.column[1] * (h.height - f.ring_beam[1]);
    timber += 2.0 * (x + y - 2 * f.ring_beam[0]) * f.ring_beam[0] * f.ring_beam[1];
  }
  return h.copies[0] * h.copies[1] * (adobe * masonry + wood * timber + surcharge);
}

double area_of(const std::vector<geometry::Segment>& side) {
  return std::accumulate(side.begin(), side.end(), 0.0, [](double sum, const geometry::Segment& s) { return sum + s.area; });
}

geometry::Polygon in_frame(const geometry::Polyhedron& shape, int face, const geometry::Frame& f) {
  geometry::Polygon polygon;
  for (const std::int32_t v : shape.faces[static_cast<std::size_t>(face)]) {
    const Vec3 p = shape.vertices[static_cast<std::size_t>(v)] - f.centre;
    polygon.push_back({dot(p, f.axis_s), dot(p, f.axis_t)});
  }
  return polygon;
}

/// The area of a joint is that of both its sides, and that of what the two faces share.
void check_joint_areas(const Model& m) {
  double worst_side = 0.0, worst_overlap = 0.0;
  for (const geometry::Joint& j : m.assembly.joints) {
    worst_side = std::max(worst_side, std::abs(area_of(j.side_a) / j.area - 1.0));
    if (j.element_b == geometry::kBase) continue;
    if (!j.merged) worst_side = std::max(worst_side, std::abs(area_of(j.side_b) / j.area - 1.0));
    const geometry::Polygon a = in_frame(m.blocks[static_cast<std::size_t>(j.element_a)].shape, j.face_a, j.frame);
    geometry::Polygon b = in_frame(m.blocks[static_cast<std::size_t>(j.element_b)].shape, j.face_b, j.frame);
    std::reverse(b.begin(), b.end());  // seen from the other side
    const double overlap = geometry::region(geometry::intersection(a, b)).area;
    worst_overlap = std::max(worst_overlap, std::abs(overlap - j.area) / (std::abs(overlap) + 1e-4));
  }
  CHECK(worst_side < 1e-9);
  CHECK(worst_overlap < 1e-9);
}

bool is_inside(const Model& m, std::int32_t element, Vec3 p) {
  const geometry::Element& e = m.assembly.elements[static_cast<std::size_t>(element)];
  for (std::int32_t f = e.first_face; f < e.first_face + e.face_count; ++f) {
    const geometry::Face& face = m.assembly.faces[static_cast<std::size_t>(f)];
    if (dot(face.normal, p) > face.offset) return false;
  }
  return true;
}

/// Before no free segment lies another element.
void check_nothing_unjoined(const Model& m) {
  std::vector<geometry::Box3> boxes;
  for (const Block& b : m.blocks) boxes.push_back(geometry::bounds(b.shape));
  geometry::UniformGrid grid;
  grid.build(boxes);
  std::vector<std::int32_t> near;
  int unjoined = 0;
  for (const geometry::FreePatch& patch : m.assembly.patches) {
    double whole = 0.0;
    for (const geometry::Segment& s : patch.segments) whole = std::max(whole, s.area);
    for (const geometry::Segment& s : patch.segments) {
      if (s.area < 0.9 * whole) continue;  // the centre of what a joint left of a cell may lie in the joint
      const Vec3 p = patch.frame.centre + s.s * patch.frame.axis_s + s.t * patch.frame.axis_t + 1e-5 * patch.frame.normal;
      near.clear();
      grid.query({p, p}, near);
      unjoined += static_cast<int>(std::count_if(near.begin(), near.end(), [&](std::int32_t e) { return is_inside(m, e, p); }));
    }
  }
  CHECK(unjoined == 0);
}

/// Bricks are at least half a brick long and half a course high, and no face of them is nearer to the centroid than an eighth of a course.
void check_no_slivers(const Model& m, const House& h) {
  const std::array<double, 3> whole{h.brick[0] + h.mortar, h.brick[1] + h.mortar, h.brick[2] + h.mortar};
  const double brick = whole[0] * whole[1] * whole[2];
  double least = 1.0, nearest = 1.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    if (m.blocks[i].kind != PartKind::brick) continue;
    const geometry::Element& e = m.assembly.elements[i];
    least = std::min(least, e.mass.volume / brick);
    for (std::int32_t f = 0; f < e.face_count; ++f)
      nearest = std::min(nearest, m.assembly.faces[static_cast<std::size_t>(e.first_face + f)].distance / whole[2]);
  }
  CHECK(least > 0.25 - 1e-9);
  CHECK(nearest > 0.125);
}

}  // namespace

TEST_CASE("any house is built whole or refused by name") {
  Dice dice(20261121);
  int built = 0, refused = 0, vaulted = 0, timbered = 0;
  const int houses = houses_to_try();
  for (int i = 0; i < houses; ++i) {
    CAPTURE(i);
    const Case c = random_case(dice);
    try {
      const Model m = build_model(c);
      const Census n = census(m);
      if (c.house->walls.size() == 4) CHECK(std::abs(n.mass / expected_mass(*c.house, c) - 1.0) < 1e-9);
      check_joint_areas(m);
      check_nothing_unjoined(m);
      check_no_slivers(m, *c.house);
      ++built;
      vaulted += c.house->roof.kind == RoofKind::vault ? 1 : 0;
      timbered += c.house->reinforcement ? 1 : 0;
    } catch (const InputError& e) {
      CAPTURE(e.what());
      CHECK(e.key().starts_with("house."));  // never a fault of geometry: every refusal names a key of the house
      ++refused;
    }
  }
  CHECK(built > houses / 3);
  CHECK(vaulted > houses / 10);
  CHECK(timbered > houses / 30);
  CHECK(refused > houses / 10);
}
