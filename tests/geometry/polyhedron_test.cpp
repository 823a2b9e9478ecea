// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyhedron.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "fixtures.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

constexpr double kPi = std::numbers::pi;

Polyhedron frustum(double bottom, double top, double height) {
  const double b = bottom / 2, t = top / 2;
  const std::array<Vec3, 8> v{
      {{-b, -b, 0}, {b, -b, 0}, {b, b, 0}, {-b, b, 0}, {-t, -t, height}, {t, -t, height}, {t, t, height}, {-t, t, height}}};
  return make_hexahedron(v);
}

Polyhedron wedge() { return make_prism(std::vector<std::array<double, 2>>{{0, 0}, {3, 0}, {0, 6}}, 0.0, 2.0); }

bool same_shape(const Polyhedron& a, const Polyhedron& b) { return a.vertices == b.vertices && a.faces == b.faces; }

/// axesᵀ diag(principal) axes must be the inertia tensor.
bool principal_system_fits(const MassProperties& m, double tolerance) {
  const Mat3 back = transposed(m.axes) * (Mat3::diagonal(m.principal.x, m.principal.y, m.principal.z) * m.axes);
  const Mat3 off = back - m.inertia;
  return norm(off.r0) + norm(off.r1) + norm(off.r2) < tolerance * m.principal.z;
}

}  // namespace

TEST_SUITE("polyhedron") {
  TEST_CASE("a box has the closed-form mass properties") {
    const MassProperties m = mass_properties(make_box({1, 2, 3}, {1.2, 2.1, 3.4}));
    const double v = 0.2 * 0.1 * 0.4;
    CHECK(m.volume == relative(v, 1e-13));
    CHECK(near(m.centroid, {1.1, 2.05, 3.2}, 1e-14));
    CHECK(m.inertia.r0.x == relative(v / 12 * (0.01 + 0.16), 1e-12));
    CHECK(m.inertia.r1.y == relative(v / 12 * (0.04 + 0.16), 1e-12));
    CHECK(m.inertia.r2.z == relative(v / 12 * (0.04 + 0.01), 1e-12));
    CHECK(m.inertia.r0.y == 0.0);
    CHECK(m.inertia.r0.z == 0.0);
    CHECK(m.inertia.r1.z == 0.0);
  }

  TEST_CASE("principal axes of a box are global axes, ascending and right-handed") {
    Random random(1);
    for (int k = 0; k < 200; ++k) {
      const Vec3 edges{random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)};
      const Vec3 low{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
      const MassProperties m = mass_properties(box_at(low, edges));
      CHECK(m.principal.x <= m.principal.y);
      CHECK(m.principal.y <= m.principal.z);
      for (const Vec3 row : {m.axes.r0, m.axes.r1, m.axes.r2}) {
        CHECK(std::abs(row.x) + std::abs(row.y) + std::abs(row.z) == 1.0);
        CHECK(dot(row, row) == 1.0);
      }
      CHECK(cross(m.axes.r0, m.axes.r1) == m.axes.r2);
      CHECK(principal_system_fits(m, 1e-14));
    }
  }

  TEST_CASE("the axes of a cube keep the order x, y, z wherever it lies") {
    Random random(2);
    for (int k = 0; k < 50; ++k) {
      const Vec3 low{random.uniform(-99, 99), random.uniform(-99, 99), random.uniform(-99, 99)};
      CHECK(mass_properties(box_at(low, {0.3, 0.3, 0.3})).axes == Mat3{});
    }
  }

  TEST_CASE("a wedge has the closed forms of a triangle extruded") {
    const MassProperties m = mass_properties(wedge());
    // Right triangle b = 3 along y, h = 6 along z: A = bh/2, I_y² = b²/18 A about the centroid, product −bh/36 A.
    const double area = 9.0, v = 18.0, yy = v * 9.0 / 18.0, zz = v * 36.0 / 18.0, yz = -v * 18.0 / 36.0, xx = v * 4.0 / 12.0;
    CHECK(m.volume == relative(area * 2.0, 1e-14));
    CHECK(near(m.centroid, {1, 1, 2}, 1e-14));
    CHECK(m.inertia.r0.x == relative(yy + zz, 1e-13));
    CHECK(m.inertia.r1.y == relative(xx + zz, 1e-13));
    CHECK(m.inertia.r2.z == relative(xx + yy, 1e-13));
    CHECK(m.inertia.r1.z == relative(-yz, 1e-13));
    CHECK(m.inertia.r0.y == 0.0);
    CHECK(principal_system_fits(m, 1e-13));
    CHECK(near(cross(m.axes.r0, m.axes.r1), m.axes.r2, 1e-14));
  }

  TEST_CASE("a tetrahedron has the closed forms") {
    const Polyhedron p{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    CHECK_NOTHROW(validate(p));
    const MassProperties m = mass_properties(p);
    const double v = 8.0 / 6.0, a2 = 4.0;
    CHECK(m.volume == relative(v, 1e-14));
    CHECK(near(m.centroid, {0.5, 0.5, 0.5}, 1e-15));
    CHECK(m.inertia.r0.x == relative(2 * v * a2 * 3.0 / 80.0, 1e-13));
    CHECK(m.inertia.r0.y == relative(v * a2 / 80.0, 1e-13));
  }

  TEST_CASE("a frustum has the closed forms") {
    const double b = 2.0, t = 1.0, h = 3.0;
    const Polyhedron p = frustum(b, t, h);
    CHECK_NOTHROW(validate(p));
    const MassProperties m = mass_properties(p);
    const double v = h / 3 * (b * b + b * t + t * t);
    CHECK(m.volume == relative(v, 1e-14));
    CHECK(m.centroid.z == relative(h / 4 * (b * b + 2 * b * t + 3 * t * t) / (b * b + b * t + t * t), 1e-14));
    // I_z = ∫ a⁴/6 dz with the edge a linear from b to t.
    CHECK(m.inertia.r2.z == relative(h / 30 * (std::pow(b, 5) - std::pow(t, 5)) / (b - t), 1e-13));
    CHECK(m.inertia.r0.x == relative(m.inertia.r1.y, 1e-13));
  }

  TEST_CASE("turning a box turns its axes and keeps its moments") {
    const Vec3 edges{0.4, 0.2, 0.1};
    const double v = 0.008;
    const Vec3 axis = normalised({1, 2, 3});
    const MassProperties m = mass_properties(rotated(box_at({5, 6, 7}, edges), axis, 0.7, {1, 1, 1}));
    CHECK(m.volume == relative(v, 1e-12));
    CHECK(m.principal.x == relative(v / 12 * (0.04 + 0.01), 1e-12));
    CHECK(m.principal.y == relative(v / 12 * (0.16 + 0.01), 1e-12));
    CHECK(m.principal.z == relative(v / 12 * (0.16 + 0.04), 1e-12));
    CHECK(principal_system_fits(m, 1e-13));
    const Quaternion q{std::cos(0.35), std::sin(0.35) * axis.x, std::sin(0.35) * axis.y, std::sin(0.35) * axis.z};
    CHECK(std::abs(dot(m.axes.r0, rotation(q) * Vec3{1, 0, 0})) == relative(1.0, 1e-13));
  }

  TEST_CASE("1 km away no digits are lost but those of the coordinates") {
    const Polyhedron here = rotated(frustum(0.2, 0.15, 0.1), {0, 1, 1}, 0.4, {});
    const Vec3 far{1024, -2048, 512};
    const MassProperties a = mass_properties(here), b = mass_properties(moved(here, far));
    CHECK(b.volume == relative(a.volume, 1e-11));
    CHECK(near(b.centroid - far, a.centroid, 1e-12));
    CHECK(near(b.principal, a.principal, 1e-11 * norm(a.principal)));
    const MassProperties box = mass_properties(box_at({1000, 1000, 1000}, {0.25, 0.125, 0.5}));
    CHECK(box.volume == relative(1.0 / 64, 1e-14));
    CHECK(box.inertia.r0.y == 0.0);
    CHECK(near(box.axes.r0, {0, 0, 1}, 0.0));
  }

  TEST_CASE("faces of a box come in the order -x +x -y +y -z +z") {
    const Polyhedron p = make_box({0, 0, 0}, {1, 2, 3});
    const std::array<Vec3, 6> normals{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
    const std::array<double, 6> areas{6, 6, 3, 3, 2, 2};
    for (std::size_t f = 0; f < 6; ++f) {
      const FacePlane plane = face_plane(p, static_cast<int>(f));
      CHECK(plane.normal == normals[f]);
      CHECK(plane.area == relative(areas[f], 1e-15));
      CHECK(dot(plane.centroid - Vec3{0.5, 1.0, 1.5}, plane.normal) > 0.0);
    }
    CHECK(p.vertices[6] == Vec3{1, 2, 3});
    CHECK(bounds(p).low == Vec3{0, 0, 0});
    CHECK(bounds(p).high == Vec3{1, 2, 3});
  }

  TEST_CASE("the centroid of a trapezoidal face") {
    const Polyhedron p = make_prism(std::vector<std::array<double, 2>>{{0, 0}, {3, 0}, {2, 1}, {0, 1}}, 0.0, 1.0);
    const FacePlane plane = face_plane(p, 5);
    CHECK(plane.normal == Vec3{1, 0, 0});
    CHECK(plane.area == relative(2.5, 1e-15));
    CHECK(near(plane.centroid, {1.0, 19.0 / 15.0, 7.0 / 15.0}, 1e-14));
  }

  TEST_CASE("prisms: either winding, vertex order, hexahedron for four corners") {
    const std::vector<std::array<double, 2>> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, turned{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    CHECK(same_shape(make_prism(square, 0, 2), make_prism(turned, 0, 2)));
    CHECK(make_prism(square, 0, 2).faces == make_box({0, 0, 0}, {1, 1, 1}).faces);

    std::vector<std::array<double, 2>> hexagon;
    for (int i = 0; i < 6; ++i) hexagon.push_back({std::cos(i * kPi / 3), std::sin(i * kPi / 3)});
    const Polyhedron p = make_prism(hexagon, -1.0, 1.0);
    CHECK_NOTHROW(validate(p));
    REQUIRE(p.faces.size() == 8);
    for (std::size_t i = 0; i < 6; ++i) CHECK(near(p.vertices[i + 6] - p.vertices[i], {2, 0, 0}, 1e-15));
    CHECK(face_plane(p, 6).normal == Vec3{-1, 0, 0});
    CHECK(face_plane(p, 7).normal == Vec3{1, 0, 0});
    CHECK(mass_properties(p).volume == relative(3 * std::sqrt(3.0), 1e-14));
  }

  TEST_CASE("quarter turns are exact and full circles come back") {
    const Polyhedron p = make_box({0, 0, 0}, {1, 2, 3});
    const Polyhedron q = rotated(p, {0, 0, 2}, kPi / 2, {0, 0, 0});
    CHECK(q.vertices[1] == Vec3{0, 1, 0});
    CHECK(bounds(q).low == Vec3{-2, 0, 0});
    CHECK(rotated(p, {1, 0, 0}, kPi, {0, 0, 0}).vertices[6] == Vec3{1, -2, -3});
    const Polyhedron round = rotated(rotated(p, {1, 1, 0}, 1.0, {3, 2, 1}), {1, 1, 0}, -1.0, {3, 2, 1});
    for (std::size_t i = 0; i < 8; ++i) CHECK(near(round.vertices[i], p.vertices[i], 1e-14));
  }

  TEST_CASE("a mirrored shape is valid, keeps its volume and stays a valid cell") {
    for (const Polyhedron& p : {wedge(), frustum(2, 1, 3), make_box({1, 2, 3}, {2, 4, 6})}) {
      const Polyhedron m = mirrored(p, {1, 0, 0}, {10, 0, 0});
      CHECK_NOTHROW(validate(m));
      const MassProperties a = mass_properties(p), b = mass_properties(m);
      CHECK(b.volume == relative(a.volume, 1e-13));
      CHECK(near(b.centroid, {20 - a.centroid.x, a.centroid.y, a.centroid.z}, 1e-13));
      CHECK(near(b.principal, a.principal, 1e-12 * a.principal.z));
      for (std::size_t f = 0; f < p.faces.size(); ++f) {
        const Vec3 n = face_plane(p, static_cast<int>(f)).normal;
        CHECK(near(face_plane(m, static_cast<int>(f)).normal, {-n.x, n.y, n.z}, 1e-14));
      }
      CHECK(mirrored(m, {1, 0, 0}, {10, 0, 0}).faces == p.faces);
    }
    const Polyhedron cell = mirrored(make_box({0, 0, 0}, {1, 1, 1}), {0, 1, 0}, {0, 0, 0});
    const Vec3 a = cell.vertices[1] - cell.vertices[0], b = cell.vertices[3] - cell.vertices[0], c = cell.vertices[4] - cell.vertices[0];
    CHECK(dot(cross(a, b), c) > 0.0);
  }

  TEST_CASE("builders refuse nonsense") {
    CHECK(complaint([] { make_box({0, 0, 0}, {1, 0, 1}); }).mentions("every edge must be positive"));
    CHECK(complaint([] { make_box({0, 0, 0}, {1, NAN, 1}); }).mentions("every edge must be positive"));
    const std::vector<std::array<double, 2>> flat{{0, 0}, {1, 1}, {2, 2}}, two{{0, 0}, {1, 1}}, ok{{0, 0}, {1, 0}, {0, 1}},
        doubled{{0, 0}, {1, 0}, {1, 0}, {0, 1}};
    CHECK(complaint([&] { make_prism(flat, 0, 1); }).mentions("degenerate polygon"));
    CHECK(complaint([&] { make_prism(doubled, 0, 1); }).mentions("degenerate polygon"));
    CHECK(complaint([&] { make_prism(two, 0, 1); }).mentions("3 corners"));
    CHECK(complaint([&] { make_prism(ok, 1, 1); }).mentions("x0 must be less than x1"));
    CHECK(complaint([&] { make_prism(ok, 0, 1); }).what.empty());
  }
}
