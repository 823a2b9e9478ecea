// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/assembly.h"

#include <doctest/doctest.h>

#include "fixtures.h"
#include "invariants.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

constexpr double kBrick = 0.025;  // m, segment size

}  // namespace

TEST_SUITE("assembly") {
  TEST_CASE("two equal bricks: one merged joint, whole faces") {
    const Assembly a = assemble_all({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0, 0, 0.1}, {0.2, 0.1, 0.1})}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    const Joint& j = a.joints[0];
    CHECK(j.element_a == 0);
    CHECK(j.face_a == 5);
    CHECK(j.element_b == 1);
    CHECK(j.face_b == 4);
    CHECK(j.merged);
    CHECK(j.side_a.size() == 32);
    CHECK(j.area == relative(0.02, 1e-10));
    CHECK(near(j.centre, {0.1, 0.05, 0.1}, 1e-12));
    CHECK(j.frame().normal == Vec3{0, 0, 1});
    CHECK(near(point_of(j.frame(), j.side_a[0]), {0.0125, 0.0125, 0.1}, 1e-12));
    CHECK(near(j.side_a[1].s - j.side_a[0].s, 0.025, 2e-12));
    CHECK(a.patches.size() == 10);
    CHECK(free_area(a, 0, 5) == 0.0);
    CHECK(free_area(a, 0, 4) == relative(0.02, 1e-10));
  }

  TEST_CASE("faces, masses and distances of the elements") {
    const Assembly a = assemble_all({box_at({1, 2, 3}, {0.2, 0.1, 0.4})}, kBrick);
    REQUIRE(a.faces.size() == 6);
    CHECK(a.faces[0].distance == relative(0.1, 1e-12));
    CHECK(a.faces[3].distance == relative(0.05, 1e-12));
    CHECK(a.faces[5].distance == relative(0.2, 1e-12));
    CHECK(a.faces[5].offset == relative(3.4, 1e-14));
    CHECK(a.faces[4].offset == relative(-3.0, 1e-14));
    CHECK(a.faces[5].area == relative(0.02, 1e-12));
    CHECK(a.elements[0].mass.volume == relative(0.008, 1e-12));
  }

  TEST_CASE("half-brick offset on the grid: merged, the other half free") {
    const Assembly a = assemble_all({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.1, 0, 0.1}, {0.2, 0.1, 0.1})}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    CHECK(a.joints[0].merged);
    CHECK(a.joints[0].side_a.size() == 16);
    CHECK(near(a.joints[0].centre, {0.15, 0.05, 0.1}, 1e-12));
    CHECK(free_area(a, 0, 5) == relative(0.01, 1e-10));
    CHECK(free_area(a, 1, 4) == relative(0.01, 1e-10));
  }

  TEST_CASE("an offset off the grid: two sides of equal area, not merged") {
    const double off = 0.04;
    const Assembly a = assemble_all({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({off, 0.01, 0.1}, {0.2, 0.1, 0.1})}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    const Joint& j = a.joints[0];
    CHECK_FALSE(j.merged);
    CHECK(j.area == relative((0.2 - off) * 0.09, 1e-10));
    CHECK(j.side_a.size() == 7 * 4);  // A's columns from 1.6 to 8
    CHECK(j.side_b.size() == 7 * 4);  // B's columns from 0 to 6.4
    // Both sides in one frame: the same centroid, and every point inside the overlap.
    for (const auto* side : {&j.side_a, &j.side_b}) {
      for (const Segment& x : *side) {
        const Vec3 p = point_of(j.frame(), x);
        CHECK((p.x > off && p.x < 0.2 && p.y > 0.01 && p.y < 0.1));
        CHECK(near(p.z, 0.1, 1e-12));
      }
    }
  }

  TEST_CASE("grids of different size on one face are two-sided") {
    const Polyhedron below = box_at({0, 0, 0}, {0.2, 0.1, 0.1}), above = box_at({0, 0, 0.1}, {0.2, 0.1, 0.1});
    const std::vector<Part> parts{{&below, 0.025, true}, {&above, 0.05, true}};
    const Assembly a = assemble(parts, std::nullopt);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    CHECK_FALSE(a.joints[0].merged);
    CHECK(a.joints[0].side_a.size() == 32);
    CHECK(a.joints[0].side_b.size() == 8);
  }

  TEST_CASE("a header on a stretcher: grids turned by a quarter still coincide") {
    const Assembly a = assemble_all({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.05, 0, 0.1}, {0.1, 0.2, 0.1})}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    CHECK(a.joints[0].merged);
    CHECK(a.joints[0].side_a.size() == 16);
  }

  TEST_CASE("three neighbours on one face, and a free remainder") {
    const Assembly a = assemble_all({box_at({0, 0, 0}, {0.4, 0.1, 0.1}), box_at({-0.07, 0, 0.1}, {0.2, 0.1, 0.1}),
                                     box_at({0.13, 0, 0.1}, {0.12, 0.05, 0.1}), box_at({0.25, 0.03, 0.1}, {0.2, 0.1, 0.1})},
                                    kBrick);
    check_invariants(a);
    std::vector<double> areas;
    for (const Joint& j : a.joints) {
      if (j.element_a == 0 && j.face_a == 5) areas.push_back(j.area);
    }
    REQUIRE(areas.size() == 3);
    CHECK(areas[0] == relative(0.13 * 0.1, 1e-10));
    CHECK(areas[1] == relative(0.12 * 0.05, 1e-10));
    CHECK(areas[2] == relative(0.15 * 0.07, 1e-10));
    CHECK(a.joints.size() == 5);  // and those beside one another
    CHECK(free_area(a, 0, 5) == relative(0.04 - 0.013 - 0.006 - 0.0105, 1e-9));
    // First moments close too: the face's centroid is the mean of its joints and its patch.
    Vec3 moment;
    for (const Joint& j : a.joints) {
      if (j.element_a == 0 && j.face_a == 5) moment += j.area * j.centre;
    }
    for (const FreePatch& p : a.patches) {
      if (p.element == 0 && p.face == 5) moment += sum_of_areas(p.segments) * p.centre;
    }
    CHECK(near(moment / 0.04, {0.2, 0.05, 0.1}, 1e-10));
  }

  TEST_CASE("a brick askew on another: areas against the closed form") {
    // A square of edge 0.1 turned by 30° within a face of 0.4 × 0.3, and one half over the edge.
    const Polyhedron slab = box_at({0, 0, 0}, {0.4, 0.3, 0.1});
    const Polyhedron inside = rotated(box_at({0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}), {0, 0, 1}, 0.5, {0.15, 0.15, 0});
    const Polyhedron over = rotated(box_at({0.35, 0.1, 0.1}, {0.1, 0.1, 0.1}), {0, 0, 1}, 0.5, {0.4, 0.15, 0});
    const Assembly a = assemble_all({slab, inside, over}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 2);
    CHECK(a.joints[0].area == relative(0.01, 1e-10));
    CHECK(a.joints[1].area == relative(0.005, 1e-10));
    CHECK_FALSE(a.joints[0].merged);
    CHECK(a.joints[0].side_b.size() == 16);
    CHECK(near(a.joints[0].centre, {0.15, 0.15, 0.1}, 1e-11));
  }

  TEST_CASE("a joint at any angle in space is the same joint") {
    const std::vector<Polyhedron> flat{box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.04, 0.01, 0.1}, {0.2, 0.1, 0.1})};
    const Assembly a = assemble_all(flat, kBrick);
    Random random(31);
    for (int k = 0; k < 20; ++k) {
      const Vec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      const double angle = random.uniform(0, 6);
      std::vector<Polyhedron> turned;
      for (const Polyhedron& p : flat) turned.push_back(rotated(p, axis, angle, {3, 2, 1}));
      const Assembly b = assemble_all(turned, kBrick);
      check_invariants(b);
      REQUIRE(b.joints.size() == 1);
      REQUIRE(b.joints[0].side_b.size() == a.joints[0].side_b.size());
      for (std::size_t i = 0; i < a.joints[0].side_b.size(); ++i) {
        CHECK(near(a.joints[0].side_b[i].s, b.joints[0].side_b[i].s, 1e-11));
        CHECK(near(a.joints[0].side_b[i].t, b.joints[0].side_b[i].t, 1e-11));
        CHECK(a.joints[0].side_b[i].area == relative(b.joints[0].side_b[i].area, 1e-8));
      }
    }
  }

  TEST_CASE("voussoirs of an arch touch on their slanting faces") {
    std::vector<Polyhedron> stones;
    const int n = 9;
    for (int i = 0; i < n; ++i) {
      std::vector<std::array<double, 2>> corners;
      for (const auto& [r, k] : {std::pair{1.0, i}, {1.2, i}, {1.2, i + 1}, {1.0, i + 1}}) {
        const double angle = 0.2 + k * (3.14159265358979 - 0.4) / n;
        corners.push_back({r * std::cos(angle), r * std::sin(angle)});
      }
      stones.push_back(make_prism(corners, 0.0, 0.3));
    }
    const Assembly a = assemble_all(stones, 0.05);
    check_invariants(a);
    REQUIRE(a.joints.size() == n - 1);
    for (const Joint& j : a.joints) {
      CHECK(j.area == relative(0.06, 1e-10));
      CHECK(j.merged);
      CHECK(same(j.side_a, a.joints[0].side_a));
    }
  }

  TEST_CASE("cut bricks under a slope: triangular and trapezoidal faces") {
    // A trapezoid and the triangle that completes it to a box, side by side on their slanting faces, under a third block that covers both.
    const std::vector<std::array<double, 2>> trapezoid{{0, 0}, {0.13, 0}, {0.07, 0.1}, {0, 0.1}}, rest{{0.13, 0}, {0.13, 0.1}, {0.07, 0.1}};
    const Assembly a =
        assemble_all({make_prism(trapezoid, 0.0, 0.1), make_prism(rest, 0.0, 0.1), box_at({0.1, 0, 0}, {0.1, 0.13, 0.1})}, kBrick);
    check_invariants(a);
    REQUIRE(a.joints.size() == 3);
    CHECK(a.joints[0].area == relative(0.1 * std::hypot(0.06, 0.1), 1e-10));
    CHECK(a.joints[0].merged);
    CHECK(a.joints[1].area == relative(0.01, 1e-10));   // trapezoid: (0.13 + 0.07)/2 × 0.1
    CHECK(a.joints[2].area == relative(0.003, 1e-10));  // triangle: 0.06 × 0.1 / 2
    CHECK(a.joints[1].element_b == 2);
    CHECK(a.joints[2].element_b == 2);
  }

  TEST_CASE("the base carries the whole of a face that lies on it") {
    const Assembly a = assemble_all({box_at({0, 0, -1.5}, {0.2, 0.1, 0.1}), box_at({0, 0, -1.4}, {0.2, 0.1, 0.1})}, kBrick, -1.5);
    check_invariants(a);
    REQUIRE(a.joints.size() == 2);
    const Joint& j = a.joints[0];
    CHECK(j.element_b == kBase);
    CHECK(j.face_a == 4);
    CHECK(j.face_b == -1);
    CHECK_FALSE(j.merged);
    CHECK(j.side_a.size() == 32);
    CHECK(j.side_b.empty());
    CHECK(j.frame().normal == Vec3{0, 0, -1});
    CHECK(near(j.centre, {0.1, 0.05, -1.5}, 1e-12));
    CHECK(free_area(a, 0, 4) == 0.0);
    // Above the base, or on an edge: no joint.
    CHECK(assemble_all({box_at({0, 0, 2e-6}, {1, 1, 1})}, 0.5, 0.0).joints.empty());
    CHECK(assemble_all({box_at({0, 0, 5e-7}, {1, 1, 1})}, 0.5, 0.0).joints.size() == 1);
    const Polyhedron tilted = rotated(box_at({0, 0, 0}, {1, 1, 1}), {1, 0, 0}, 0.1, {0, 0, 0});
    CHECK(assemble_all({tilted}, 0.5, bounds(tilted).low.z).joints.empty());
  }

  TEST_CASE("tolerances of touching: gap 1e-6 m, area 1e-8 m2, angle 1e-6") {
    const Polyhedron below = box_at({0, 0, 0}, {0.2, 0.1, 0.1});
    const auto joints = [&](const Polyhedron& above) { return assemble_all({below, above}, kBrick).joints.size(); };
    CHECK(joints(box_at({0, 0, 0.1 + 0.9e-6}, {0.2, 0.1, 0.1})) == 1);
    CHECK(joints(box_at({0, 0, 0.1 - 0.9e-6}, {0.2, 0.1, 0.1})) == 1);
    CHECK(joints(box_at({0, 0, 0.1 + 1.1e-6}, {0.2, 0.1, 0.1})) == 0);
    CHECK(joints(box_at({0.2 - 1e-4, 0.1 - 1.1e-4, 0.1}, {0.2, 0.1, 0.1})) == 1);
    CHECK(joints(box_at({0.2 - 1e-4, 0.1 - 0.9e-4, 0.1}, {0.2, 0.1, 0.1})) == 0);
    CHECK(joints(rotated(box_at({0, 0, 0.1}, {0.2, 0.1, 0.1}), {1, 0, 0}, 0.5e-6, {0, 0, 0.1})) == 1);
    CHECK(joints(rotated(box_at({0, 0, 0.1}, {0.2, 0.1, 0.1}), {1, 0, 0}, 3e-6, {0, 0, 0.1})) == 0);
    CHECK(joints(box_at({0.2, 0.1, 0.0}, {0.2, 0.1, 0.1})) == 0);  // an edge
    CHECK(joints(box_at({0.2, 0.1, 0.1}, {0.2, 0.1, 0.1})) == 0);  // a corner
  }

  TEST_CASE("a thin overlap: slivers merge, areas still close") {
    for (const double width : {1e-4, 2e-4, 3.3e-3}) {
      const Assembly a = assemble_all({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.2 - width, 0, 0.1}, {0.2, 0.1, 0.1})}, kBrick);
      check_invariants(a);
      REQUIRE(a.joints.size() == 1);
      CHECK(a.joints[0].area == relative(width * 0.1, 1e-7));
    }
  }

  TEST_CASE("bricks that are alike share their lists of segments, which outlive a copy's original") {
    std::vector<Polyhedron> pile;
    for (const double x : {0.0, 0.5, 7.3}) {
      for (const double z : {0.0, 0.1}) pile.push_back(box_at({x, 0, z}, {0.2, 0.1, 0.1}));
    }
    pile.push_back(box_at({20.0, 0, 0}, {0.3, 0.1, 0.1})), pile.push_back(box_at({20.0, 0, 0.1}, {0.3, 0.1, 0.1}));
    Assembly copy;
    {
      const Assembly a = assemble_all(pile, kBrick);
      REQUIRE(a.joints.size() == 4);
      CHECK(a.joints[0].side_a.data() == a.joints[1].side_a.data());
      CHECK(a.joints[0].side_a.data() == a.joints[2].side_a.data());
      CHECK(a.joints[0].side_a.data() != a.joints[3].side_a.data());
      copy = a;
    }
    check_invariants(copy);
  }
}
