// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/cases/refused.h"
#include "tests/cases/walls/plan_spans.h"

using namespace voussoir;
using namespace voussoir::cases;
using namespace voussoir::testing;

namespace {

WallVault vault_between(std::vector<std::string> walls, std::vector<std::string> gables) {
  WallVault v;
  v.name = "nave", v.walls = std::move(walls), v.gables = std::move(gables), v.material = "adobe";
  v.thickness = 0.3, v.ring = 0.5, v.voussoirs = 15;
  return v;
}

/// A nave of 6 m by 4 m inside, under a vault with gables.
Case nave(std::optional<double> rise = {}) {
  WallSpec outer = closed(wall("outer", {{0.0, 0.0}, {7.0, 0.0}, {7.0, 5.0}, {0.0, 5.0}}, 0.5, 2.0));
  outer.line = WallLine::right;
  Case c = case_of({outer});
  c.vaults = {vault_between({"outer 1", "outer 3"}, {"outer 2", "outer 4"})};
  c.vaults[0].rise = rise;
  return c;
}

double mass_of(const Model& m) {
  double sum = 0.0;
  for (std::size_t e = 0; e < m.blocks.size(); ++e)
    sum += m.assembly.elements[e].mass.volume * m.materials[static_cast<std::size_t>(m.blocks[e].material)].value.density;
  return sum;
}

struct Section {
  double ring, under;  // m2: of a ring, and between its soffit and the tops of the walls
};

/// By sectors of triangles about the centre of the arc, from the description of the vault alone.
Section section_of(double span, double rise, double t, int n) {
  const double r = (0.25 * span * span + rise * rise) / (2.0 * rise), half = 2.0 * std::atan(2.0 * rise / span);
  const double one = 0.5 * std::sin(2.0 * half / n), feet = t * std::sin(half) * std::max(0.0, t * std::cos(half));
  return {n * one * ((r + t) * (r + t) - r * r) + feet, n * one * r * r - 0.5 * r * r * std::sin(2.0 * half)};
}

}  // namespace

TEST_CASE("a barrel vault on two walls: volume of rings and gables, joints, the same turned and mirrored") {
  for (const double rise : {0.5, 1.0, 1.7, 2.0}) {
    for (const int n : {7, 12, 25}) {
      CAPTURE(rise);
      CAPTURE(n);
      Case c = nave(rise);
      c.vaults[0].voussoirs = n;
      const Section s = section_of(4.0, rise, 0.3, n);
      const double walls = 2.0 * (7.0 * 5.0 - 6.0 * 4.0) + 2.0 * 0.5 * s.under;
      const Model m = build_model(c);
      CHECK(volume_of(m) == doctest::Approx(walls + 7.0 * s.ring).epsilon(1e-9));
      check_joint_areas(m);
      check_nothing_unjoined(m);
      for (const bool mirror : {false, true})
        CHECK(volume_of(build_model(moved(c, 0.7, mirror))) == doctest::Approx(volume_of(m)).epsilon(1e-9));
      std::size_t voussoirs = 0;
      for (const Block& b : m.blocks) voussoirs += b.vault == 0 ? 1 : 0;
      CHECK(voussoirs == static_cast<std::size_t>(14 * n));
    }
  }
}

TEST_CASE("a half circle is the vault of a house: the same voussoirs where they stand") {
  Case c = nave();
  c.vaults[0].gables.clear();
  const Model m = build_model(c);
  Case h = c;
  h.walls.clear(), h.vaults.clear();
  House house;
  house.inner_size = {6.0, 4.0}, house.height = 2.0, house.brick = {0.5, 0.25, 0.25}, house.material = "adobe", house.joint = "normal";
  house.bearing_wall = house.nonbearing_wall = 0.5;
  house.roof.kind = RoofKind::vault, house.roof.radius = 2.0, house.roof.thickness = 0.3, house.roof.ring = 0.5, house.roof.voussoirs = 15;
  h.house = house;
  const Model of_house = build_model(h);
  std::vector<Vec3> one, other;
  for (const Block& b : m.blocks) {
    if (b.kind == PartKind::voussoir) one.insert(one.end(), b.shape.vertices.begin(), b.shape.vertices.end());
  }
  for (const Block& b : of_house.blocks) {
    if (b.kind == PartKind::voussoir) other.insert(other.end(), b.shape.vertices.begin(), b.shape.vertices.end());
  }
  REQUIRE(one.size() == other.size());
  const auto before = [](const Vec3& a, const Vec3& b) {
    const auto key = [](const Vec3& v) { return std::array{std::round(v.x * 1e6), std::round(v.y * 1e6), std::round(v.z * 1e6)}; };
    return key(a) < key(b);
  };
  std::ranges::sort(one, before), std::ranges::sort(other, before);
  double worst = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) worst = std::max(worst, norm(one[i] - other[i]));
  CHECK(worst < 1e-9);
}

TEST_CASE("the surcharge of a vault lies on its outer face") {
  Case c = nave(1.0);
  const double bare = mass_of(build_model(c));
  c.vaults[0].surcharge = 100.0;
  const double half = 2.0 * std::atan(0.5), radius = 2.5 + 0.3;
  CHECK(mass_of(build_model(c)) - bare == doctest::Approx(100.0 * 7.0 * 2.0 * 15 * radius * std::sin(half / 15)).epsilon(1e-9));
}

TEST_CASE("vaults that cannot stand are refused with the key, the value and what is allowed") {
  using V = WallVault&;
  const auto refuse = [](const std::function<void(V)>& change, const std::string& key, const std::string& says) {
    check_refused(nave(1.0), std::function<void(Case&)>([&](Case& c) { change(c.vaults[0]); }), key, says);
  };
  refuse([](V v) { v.rise = 0.1; }, "vault[0].rise", "0.1 m over a span of 4 m; allowed: 0.2 to 2 m");
  refuse([](V v) { v.rise = 2.3; }, "vault[0].rise", "allowed: 0.2 to 2 m");
  refuse([](V v) { v.rise = {}, v.thickness = 0.6; }, "vault[0].thickness", "makes feet of 0.6 m, wider than the outer 1 wall, 0.5 m");
  refuse([](V v) { v.voussoirs = 2; }, "vault[0].voussoirs", "allowed: 3 to 1000");
  refuse([](V v) { v.ring = 0.0; }, "vault[0].ring", "");
  refuse([](V v) { v.walls[1] = "outer 2"; }, "vault[0].walls", "less than 30 degrees");
  refuse([](V v) { v.gables[0] = "outer 3"; }, "vault[0].gables[0]", "not square to the axis of the vault");
  refuse([](V v) { v.material = "glass"; }, "vault[0].material", "glass");
  Case c = nave(1.0);
  c.vaults.push_back(c.vaults[0]);
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "vault[1].name", "is already the name of vault[0]");
  c = nave(1.0);
  c.walls.clear();
  c.blocks.emplace_back();
  c.blocks[0].name = "b", c.blocks[0].material = "adobe", c.blocks[0].box = std::array{Vec3{0, 0, 0}, Vec3{1, 1, 1}};
  check_refused(c, std::function<void(Case&)>([](Case&) {}), "vault[0].walls", "of which the case has none");
}
