// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "cases/house/house_wall.h"
#include "tests/cases/house/house_checks.h"
#include "tests/cases/house/house_mass.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// Flemish bond; walls of two leaves, with and without stones through both.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;

/// Outer size 3.2 x 2.2 m, walls 0.4 m thick and 0.8 m high, bricks of 0.2 x 0.1 x 0.1 m.
Case thick_house() {
  Case c = testing::paper_flat20();
  c.output.history.clear();
  House& h = *c.house;
  h.inner_size = {2.4, 1.4};
  h.bearing_wall = h.nonbearing_wall = 0.4;
  h.height = 0.8;
  h.openings.clear();
  h.roof = {};
  return c;
}

Case with_leaves() {
  Case c = thick_house();
  c.house->leaves = Leaves{{}, {}, "weak", {}};
  return c;
}

/// Whole millimetres.
long mm(double m) { return std::lround(1000.0 * m); }

using Place = std::tuple<long, long, long, long>;  // along from, to; depth from, to

std::vector<Place> course_of_front(const Case& c, int course) {
  const HousePlan plan = plan_house(*c.house);
  std::vector<Place> places;
  for (const LaidBrick& b : lay_course(*c.house, plan, plan.walls[0], course))
    places.emplace_back(mm(metres(b.along.low)), mm(metres(b.along.high)), mm(metres(b.depth.low)), mm(metres(b.depth.high)));
  return places;
}

bool holds(const std::vector<Place>& places, Place wanted) { return std::ranges::find(places, wanted) != places.end(); }

/// Area of the joints between the two leaves of the front wall, with their laws; bricks through both.
struct Collar {
  double weak = 0.0, other = 0.0;
  int through = 0;
};

Collar collar_of(const Model& m) {
  Collar found;
  const auto box = [&](std::int32_t e) { return geometry::bounds(m.blocks[static_cast<std::size_t>(e)].shape); };
  for (std::size_t i = 0; i < m.assembly.joints.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    if (j.element_b == geometry::kBase || std::abs(j.frame().normal.y) < 0.5) continue;
    const Block &a = m.blocks[static_cast<std::size_t>(j.element_a)], &b = m.blocks[static_cast<std::size_t>(j.element_b)];
    if (a.tag != "front wall" || b.tag != "front wall") continue;
    const double plane = std::max(box(j.element_a).low.y, box(j.element_b).low.y);
    if (std::abs(plane - 0.2) > 1e-9) continue;
    (m.laws[static_cast<std::size_t>(m.joint_law[i])].name == "weak" ? found.weak : found.other) += j.area;
  }
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const geometry::Box3 b = box(static_cast<std::int32_t>(i));
    if (m.blocks[i].tag == "front wall" && mm(b.high.y - b.low.y) == 400) ++found.through;
  }
  return found;
}

}  // namespace

TEST_CASE("Flemish bond: a header beside each stretcher, over the middle of the stretcher below") {
  Case c = thick_house();
  c.house->bond = Bond::flemish;
  c.house->bearing_wall = 0.2;
  const std::vector<Place> even = course_of_front(c, 0), odd = course_of_front(c, 1);
  for (long x = 600; x < 2400; x += 300) {  // header, two stretchers side by side
    CHECK(holds(even, {x, x + 100, 0, 200}));
    CHECK(holds(even, {x + 100, x + 300, 0, 100}));
    CHECK(holds(even, {x + 100, x + 300, 100, 200}));
    CHECK(holds(odd, {x + 150, x + 250, 0, 200}));
    CHECK(holds(odd, {x + 250, x + 450, 0, 100}));
  }
  c.house->bearing_wall = 0.4;  // two headers end to end; between stretchers headers in the core
  const std::vector<Place> thick = course_of_front(c, 0);
  for (long x = 600; x < 2400; x += 300) {
    CHECK(holds(thick, {x, x + 100, 0, 200}));
    CHECK(holds(thick, {x, x + 100, 200, 400}));
    CHECK(holds(thick, {x + 100, x + 300, 0, 100}));
    CHECK(holds(thick, {x + 100, x + 200, 100, 300}));
    CHECK(holds(thick, {x + 200, x + 300, 100, 300}));
    CHECK(holds(thick, {x + 100, x + 300, 300, 400}));
  }
}

TEST_CASE("Flemish bond: whole bricks are those of the format, and cracks in halves fit") {
  Case c = thick_house();
  c.house->bond = Bond::flemish;
  const Model m = build_model(c);
  int whole = 0;
  for (const Block& b : m.blocks) {
    const geometry::Box3 box = geometry::bounds(b.shape);
    std::array<long, 3> size{mm(box.high.x - box.low.x), mm(box.high.y - box.low.y), mm(box.high.z - box.low.z)};
    std::ranges::sort(size);
    CHECK(b.whole == (size == std::array<long, 3>{100, 100, 200}));
    whole += b.whole ? 1 : 0;
  }
  CHECK(whole > 600);
}

TEST_CASE("two leaves: each in bond, the collar joint between them has its own law and is all that joins them") {
  const Model m = build_model(with_leaves());
  const Collar collar = collar_of(m);
  CHECK(collar.through == 0);
  CHECK(collar.other == doctest::Approx(0.0));
  // Between its corners all of the height, in the corners the courses that run through.
  CHECK(collar.weak == doctest::Approx(2.4 * 0.8 + 0.8 * 0.4).epsilon(1e-9));
  testing::check_joint_areas(m);
  testing::check_nothing_unjoined(m);
  // By default the leaves meet as all bricks do.
  Case plain = with_leaves();
  plain.house->leaves->joint.reset();
  const Collar bonded = collar_of(build_model(plain));
  CHECK(bonded.weak == 0.0);
  CHECK(bonded.other == doctest::Approx(collar.weak).epsilon(1e-9));
}

TEST_CASE("two leaves: stones through both, at their spacing, every so many courses, and of their own material") {
  Case c = with_leaves();
  c.materials["lava"] = {2500.0, 1e10, 0.2};
  c.house->leaves->through = ThroughStones{0.8, 4, "lava"};
  const Model m = build_model(c);
  std::vector<std::pair<long, long>> places;  // x and z of those of the front wall
  double volume = 0.0;
  for (const Block& b : m.blocks) {
    if (m.materials[static_cast<std::size_t>(b.material)].name != "lava") continue;
    const geometry::Box3 box = geometry::bounds(b.shape);
    const Vec3 size = box.high - box.low;
    volume += size.x * size.y * size.z;
    if (b.tag == "front wall") places.emplace_back(mm(box.low.x), mm(box.low.z));
  }
  std::ranges::sort(places);
  // Courses 2 and 6 are even: headers on the grid of 0.1 m. The second row lies between those of the first.
  CHECK(places == std::vector<std::pair<long, long>>{{400, 200}, {800, 600}, {1200, 200}, {1600, 600}, {2000, 200}, {2400, 600}});
  CHECK(collar_of(m).through == 6);
  CHECK(std::abs(volume / (0.1 * 0.4 * 0.1) - std::round(volume / (0.1 * 0.4 * 0.1))) < 1e-9);
  // No stone's two joints through the wall run on in the course above or below.
  testing::check_joint_areas(m);
  testing::check_no_slivers(m, *c.house);
}

TEST_CASE("two leaves: what is refused") {
  const auto refuse = [](const std::function<void(House&)>& change, const std::string& key, const std::string& words) {
    check_refused(with_leaves(), change, key, words);
  };
  refuse([](House& h) { h.leaves->outer = 0.05; }, "house.leaves.outer", "less than two thirds of a brick's width; at least 0.067 m");
  refuse([](House& h) { h.leaves->outer = 0.4; }, "house.leaves.outer", "the front wall of 0.4 m has no room for two leaves");
  refuse([](House& h) { h.nonbearing_wall = 0.1; }, "house.leaves",
         "the right wall of 0.1 m has no room for two leaves; name thicker ones");
  refuse([](House& h) { h.leaves->walls = {"middle"}; }, "house.leaves.walls[0]", "\"middle\"");
  refuse([](House& h) { h.leaves->joint = "clay"; }, "house.leaves.joint", "clay");
  refuse([](House& h) { h.leaves->through = ThroughStones{0.3, 4, {}}; }, "house.leaves.through.spacing", "at least 0.4 m");
  refuse([](House& h) { h.leaves->through = ThroughStones{0.8, 1, {}}; }, "house.leaves.through.every", "1");
  refuse([](House& h) { h.leaves->through = ThroughStones{0.8, 4, "lava"}; }, "house.leaves.through.material", "lava");
}

}  // namespace voussoir
