// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "fixtures.h"
#include "geometry/polyhedron.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

Polyhedron unit_box() { return make_box({0, 0, 0}, {1, 1, 1}); }

Complaint complaint_of(const Polyhedron& p) {
  return complaint([&] { validate(p, 7); });
}

}  // namespace

TEST_SUITE("validate") {
  TEST_CASE("good shapes pass, near and far, large and small") {
    CHECK(complaint_of(unit_box()).what.empty());
    CHECK(complaint_of(moved(unit_box(), {1000, 2000, 3000})).what.empty());
    CHECK(complaint_of(box_at({0, 0, 0}, {5.0, 0.01, 0.1})).what.empty());
    CHECK(complaint_of(box_at({1, 1, 1}, {1e-3, 2e-3, 1e-3})).what.empty());
    const Polyhedron tiny = rotated(box_at({0, 0, 0}, {1e-5, 2e-5, 1e-5}), {1, 2, 3}, 1.0, {});
    for (int k = 0; k < 100; ++k) CHECK(complaint_of(moved(tiny, {700.1 + k, 10.3 * k, 0.7})).what.empty());
    CHECK(complaint_of(rotated(box_at({8, 9, 1}, {0.2, 0.1, 0.1}), {1, 2, 3}, 1.0, {})).what.empty());
  }

  TEST_CASE("the message names the block, and the error carries it") {
    const Polyhedron p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    const Complaint c = complaint_of(p);
    CHECK(c.mentions("block 7: fewer than 4 vertices: 3"));
    CHECK(c.subject == 7);
    CHECK(c.other == -1);
    CHECK(complaint([&] { validate(p); }).what == "fewer than 4 vertices: 3");
  }

  TEST_CASE("non-finite coordinates") {
    for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
      Polyhedron p = unit_box();
      p.vertices[3].y = bad;
      CHECK(complaint_of(p).mentions("vertex 3 is not finite"));
    }
  }

  TEST_CASE("faces that are no polygons") {
    Polyhedron p = unit_box();
    p.faces[2] = {0, 1};
    CHECK(complaint_of(p).mentions("face 2 has fewer than 3 corners: 2"));
    p.faces[2] = {0, 1, 8, 4};
    CHECK(complaint_of(p).mentions("face 2 uses vertex 8, there are 8"));
    p.faces[2] = {0, 1, 0, 4};
    CHECK(complaint_of(p).mentions("face 2 uses vertex 0 twice"));
    p.faces.resize(3);
    CHECK(complaint_of(p).mentions("fewer than 4 faces: 3"));
  }

  TEST_CASE("a section that runs round twice, closed and convex") {
    Polyhedron p;
    const std::array<Vec3, 3> corner{Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    for (const double x : {0.0, 1.0}) {
      for (std::size_t i = 0; i < 6; ++i) p.vertices.push_back(corner[i % 3] + Vec3{x, 0, 0});
    }
    p.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (std::int32_t i = 0; i < 6; ++i) p.faces.push_back({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
    CHECK(complaint_of(p).mentions("vertices 0 and 3 coincide"));
  }

  TEST_CASE("a vertex used by no face") {
    Polyhedron p = unit_box();
    p.vertices.push_back({0.5, 0.5, 0.5});
    CHECK(complaint_of(p).mentions("a vertex is used by no face: vertex 8"));
  }

  TEST_CASE("a surface with a hole, or one face turned") {
    Polyhedron p = unit_box();
    p.faces.pop_back();
    CHECK(complaint_of(p).mentions("not closed"));
    p = unit_box();
    std::reverse(p.faces[4].begin(), p.faces[4].end());
    CHECK(complaint_of(p).mentions("not closed"));
  }

  TEST_CASE("inside out") {
    Polyhedron p = unit_box();
    for (auto& loop : p.faces) std::reverse(loop.begin(), loop.end());
    CHECK(complaint_of(p).mentions("inside out: the volume is -1 m3"));
  }

  TEST_CASE("zero volume") {
    Polyhedron p = unit_box();
    for (Vec3& v : p.vertices) v.z = 2.0;
    CHECK(complaint_of(p).mentions("zero volume"));
  }

  TEST_CASE("a face off its plane, with the tolerance of 1e-9 of the size") {
    Polyhedron p = unit_box();
    p.vertices[6].z += 1e-4;
    CHECK(complaint_of(p).mentions("a face is not plane"));
    p.vertices[6].z = 1.0 + 2e-8;
    CHECK(complaint_of(p).mentions("a face is not plane"));
    p.vertices[6].z = 1.0 + 5e-10;
    CHECK(complaint_of(p).what.empty());
  }

  TEST_CASE("not convex") {
    // An arrowhead in the y-z plane: its faces are all plane.
    const Polyhedron p = make_prism(std::vector<std::array<double, 2>>{{0, 0}, {2, -1}, {0.5, 0}, {2, 1}}, 0.0, 1.0);
    CHECK(complaint_of(p).mentions("not convex"));
    const auto dented = [](double depth) {
      const std::vector<std::array<double, 2>> corners{{0, 0}, {1, 0}, {1, 1}, {0.5, 1 - depth}, {0, 1}};
      return make_prism(corners, 0.0, 1.0);
    };
    CHECK(complaint_of(dented(0.1)).mentions("not convex"));
    CHECK(complaint_of(dented(1e-8)).mentions("not convex"));
    CHECK(complaint_of(dented(1e-10)).what.empty());
  }
}
