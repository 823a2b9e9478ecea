// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <chrono>
#include <set>

#include "fixtures.h"
#include "geometry/assembly.h"
#include "invariants.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

constexpr double kBrick = 0.025;  // m, segment size

}  // namespace

TEST_SUITE("walls") {
  TEST_CASE("1 km away the joints are the same, bit by bit where the coordinates are") {
    const Vec3 far{1024, -1024, 0};
    const std::vector<Polyhedron> decimal = running_wall(4, 4);
    std::vector<Polyhedron> binary;
    for (const Polyhedron& p : decimal) {
      const Vec3 low = bounds(p).low;
      binary.push_back(box_at({std::round(low.x / 0.1) / 8, 0, std::round(low.z / 0.1) / 8}, {0.25, 0.125, 0.125}));
    }
    for (const bool exact : {false, true}) {
      const std::vector<Polyhedron>& shapes = exact ? binary : decimal;
      std::vector<Polyhedron> away;
      for (const Polyhedron& p : shapes) away.push_back(moved(p, far));
      const Assembly here = assemble_all(shapes, 0.03, 0.0), there = assemble_all(away, 0.03, 0.0);
      check_invariants(there);
      REQUIRE(here.joints.size() == there.joints.size());
      for (std::size_t k = 0; k < here.joints.size(); ++k) {
        const Joint &a = here.joints[k], &b = there.joints[k];
        CHECK(a.merged == b.merged);
        CHECK(near(b.centre - far, a.centre, 1e-12));
        CHECK(b.area == relative(a.area, 1e-10));
        CHECK(a.side_a.size() == b.side_a.size());
        if (exact) CHECK(same(a.side_a, b.side_a));
      }
    }
  }

  TEST_CASE("a mirrored wall has mirrored joints") {
    std::vector<Polyhedron> shapes = running_wall(3, 3), turned;
    for (const Polyhedron& p : shapes) turned.push_back(mirrored(p, {1, 0, 0}, {0, 0, 0}));
    const Assembly a = assemble_all(shapes, 0.03, 0.0), b = assemble_all(turned, 0.03, 0.0);
    check_invariants(b);
    REQUIRE(a.joints.size() == b.joints.size());
    for (std::size_t k = 0; k < a.joints.size(); ++k) {
      const Vec3 c = a.joints[k].centre;
      CHECK(near(b.joints[k].centre, {-c.x, c.y, c.z}, 1e-11));
      CHECK(b.joints[k].area == relative(a.joints[k].area, 1e-10));
      CHECK(b.joints[k].merged == a.joints[k].merged);
    }
  }

  TEST_CASE("alike joints of a wall are bitwise alike") {
    const Assembly a = assemble_all(running_wall(20, 20), kBrick, 0.0);
    std::set<std::vector<double>> kinds;
    for (const Joint& j : a.joints) {
      std::vector<double> flat;
      for (const Segment& s : j.side_a) flat.insert(flat.end(), {s.s, s.t, s.area});
      kinds.insert(flat);
      CHECK((j.merged || j.element_b == kBase));
    }
    CHECK(kinds.size() == 2);  // a whole bed on the base; squares: half a bed, between heads
    std::set<std::vector<double>> patches;
    for (const FreePatch& p : a.patches) {
      std::vector<double> flat;
      for (const Segment& s : p.segments) flat.insert(flat.end(), {s.s, s.t, s.area});
      patches.insert(flat);
    }
    CHECK(patches.size() == 2);  // sides and tops; squares: ends, half a bed
  }

  TEST_CASE("a two-sided joint and a slanting one have the same bits wherever they stand") {
    // 0.013 is no multiple of a cell; the slope cuts cells obliquely.
    const std::vector<std::array<double, 2>> trapezoid{{0, 0}, {0.13, 0}, {0.07, 0.1}, {0, 0.1}};
    const std::vector<Polyhedron> shapes{box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.013, 0.03, 0.1}, {0.2, 0.1, 0.1}),
                                         moved(make_prism(trapezoid, 0.0, 0.1), {0.2, 0, 0})};
    const Assembly first = assemble_all(shapes, kBrick);
    REQUIRE(first.joints.size() == 3);
    CHECK(first.joints[1].side_b.size() > 0);
    Random random(41);
    for (int k = 0; k < 100; ++k) {
      const Vec3 by{0.05 * std::round(random.uniform(-100, 100)), 0.05 * std::round(random.uniform(-100, 100)), 0.1 * k};
      std::vector<Polyhedron> elsewhere;
      for (const Polyhedron& p : shapes) elsewhere.push_back(moved(p, by));
      const Assembly a = assemble_all(elsewhere, kBrick);
      check_invariants(a);
      REQUIRE(a.joints.size() == first.joints.size());
      for (std::size_t j = 0; j < a.joints.size(); ++j) {
        CHECK(same(a.joints[j].side_a, first.joints[j].side_a));
        CHECK(same(a.joints[j].side_b, first.joints[j].side_b));
      }
      REQUIRE(a.patches.size() == first.patches.size());
      for (std::size_t j = 0; j < a.patches.size(); ++j) CHECK(same(a.patches[j].segments, first.patches[j].segments));
    }
  }

  TEST_CASE("free slivers at a slanting edge go to their neighbours") {
    const std::vector<std::array<double, 2>> sharp{{0, 0}, {0.37, 0}, {0, 0.1}};
    const Assembly a = assemble_all({make_prism(sharp, 0.0, 0.1)}, kBrick);
    check_invariants(a);
    REQUIRE(a.patches.size() == 5);
    for (const Segment& x : a.patches[4].segments) CHECK(x.area > 0.009 * kBrick * kBrick);
    CHECK(free_area(a, 0, 4) == relative(0.5 * 0.37 * 0.1, 1e-10));
  }

  TEST_CASE("the result does not depend on how often it is computed") {
    const std::vector<Polyhedron> shapes = running_wall(5, 5);
    const Assembly a = assemble_all(shapes, 0.03, 0.0), b = assemble_all(shapes, 0.03, 0.0);
    REQUIRE(a.joints.size() == b.joints.size());
    for (std::size_t k = 0; k < a.joints.size(); ++k) {
      CHECK(same(a.joints[k].side_a, b.joints[k].side_a));
      CHECK(same(a.joints[k].side_b, b.joints[k].side_b));
    }
  }

  TEST_CASE("a wall of 20 000 bricks takes seconds, not minutes") {
    const std::vector<Polyhedron> shapes = running_wall(100, 200);
    const auto start = std::chrono::steady_clock::now();
    const Assembly a = assemble_all(shapes, kBrick, 0.0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    MESSAGE("20 000 bricks: " << seconds << " s");
    CHECK(seconds < 20.0);  // a quadratic loop would take far longer
    CHECK(a.joints.size() == 200 + 100 * 199 + 99 * 399);
  }
}
