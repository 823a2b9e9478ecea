// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/rim_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "fixtures.h"
#include "invariants.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

/// Area, first and second moments about a point.
struct Moments {
  double area = 0.0, s = 0.0, t = 0.0, ss = 0.0, st = 0.0, tt = 0.0;
};

Moments of_points(const std::vector<Segment>& points, Point2 about) {
  Moments m;
  for (const Segment& p : points) {
    const double s = p.s - about.s, t = p.t - about.t;
    m.area += p.area, m.s += p.area * s, m.t += p.area * t;
    m.ss += p.area * s * s, m.st += p.area * s * t, m.tt += p.area * t * t;
  }
  return m;
}

/// By Green's theorem, edge by edge.
Moments of_polygon(const Polygon& p, Point2 about) {
  Moments m;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 a{p[i].s - about.s, p[i].t - about.t}, q = p[(i + 1) % p.size()], b{q.s - about.s, q.t - about.t};
    const double w = a.s * b.t - a.t * b.s;
    m.area += w / 2.0, m.s += w * (a.s + b.s) / 6.0, m.t += w * (a.t + b.t) / 6.0;
    m.ss += w * (a.s * a.s + a.s * b.s + b.s * b.s) / 12.0, m.tt += w * (a.t * a.t + a.t * b.t + b.t * b.t) / 12.0;
    m.st += w * (2.0 * a.s * a.t + a.s * b.t + b.s * a.t + 2.0 * b.s * b.t) / 24.0;
  }
  return m;
}

/// Third moments of points and polygon along direction (s, t) about a point, and their scale.
void check_third_moment(const std::vector<Segment>& points, const Polygon& p, Point2 about, Point2 along) {
  const auto x = [&](double s, double t) { return (s - about.s) * along.s + (t - about.t) * along.t; };
  double got = 0.0, exact = 0.0, scale = 0.0;
  for (const Segment& q : points) got += q.area * std::pow(x(q.s, q.t), 3), scale += q.area * std::pow(std::abs(x(q.s, q.t)), 3);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 a = p[i], b = p[(i + 1) % p.size()];
    const double w = (a.s - about.s) * (b.t - about.t) - (a.t - about.t) * (b.s - about.s), u = x(a.s, a.t), v = x(b.s, b.t);
    exact += w * (u * u * u + u * u * v + u * v * v + v * v * v) / 20.0;
  }
  CHECK(near(got, exact, 1e-12 * scale));
}

bool has(const std::vector<Segment>& points, Point2 p, double tolerance) {
  return std::ranges::any_of(points, [&](const Segment& q) { return std::hypot(q.s - p.s, q.t - p.t) <= tolerance; });
}

/// What holds for every polygon; \return the points.
std::vector<Segment> check_rule(const Polygon& polygon, double size) {
  std::vector<Segment> points;
  append_rim_points(polygon, size, points);
  const Point2 centre = region(polygon).centroid;
  const Moments got = of_points(points, centre), exact = of_polygon(polygon, centre);
  const double moment = exact.ss + exact.tt;  // the scale of all second moments
  CHECK(got.area == relative(exact.area, 1e-13));
  CHECK(near(got.s, 0.0, 1e-13 * std::sqrt(moment * exact.area)));
  CHECK(near(got.t, 0.0, 1e-13 * std::sqrt(moment * exact.area)));
  CHECK(near(got.ss, exact.ss, 1e-12 * moment));
  CHECK(near(got.st, exact.st, 1e-12 * moment));
  CHECK(near(got.tt, exact.tt, 1e-12 * moment));
  CHECK(std::ranges::all_of(points, [](const Segment& p) { return p.area > 0.0; }));
  for (const Point2 corner : polygon) CHECK(has(points, corner, 1e-10));
  for (std::size_t i = 0; i < points.size(); ++i) {  // no point twice, none outside
    const auto twin = std::find_if(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, points.end(),
                                   [&](const Segment& q) { return std::hypot(q.s - points[i].s, q.t - points[i].t) < 1e-9; });
    CHECK(twin == points.end());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      CHECK((b.s - a.s) * (points[i].t - a.t) - (b.t - a.t) * (points[i].s - a.s) >= -1e-13);
    }
  }
  return points;
}

/// What holds for the corners of every polygon as points; \return the points.
std::vector<Segment> check_corners(const Polygon& polygon) {
  std::vector<Segment> points;
  append_corner_points(polygon, points);
  const Point2 centre = region(polygon).centroid;
  const Moments got = of_points(points, centre), exact = of_polygon(polygon, centre);
  const double moment = exact.ss + exact.tt;
  REQUIRE(points.size() == polygon.size());
  CHECK(got.area == relative(exact.area, 1e-12));
  CHECK(near(got.s, 0.0, 1e-12 * std::sqrt(moment * exact.area)));
  CHECK(near(got.t, 0.0, 1e-12 * std::sqrt(moment * exact.area)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(points[i].area > 0.0);
    CHECK(near(std::hypot(points[i].s - polygon[i].s, points[i].t - polygon[i].t), 0.0, 1e-12));
  }
  return points;
}

/// Corners at random angles of an ellipse.
Polygon random_polygon(Random& random, int corners) {
  std::vector<double> angles;
  for (int i = 0; i < corners; ++i) angles.push_back((i + random.uniform(0.05, 0.95)) * 2.0 * std::numbers::pi / corners);
  const double width = random.uniform(0.05, 0.4), height = random.uniform(0.05, 0.4);
  Polygon p;
  for (const double a : angles) p.push_back({0.3 + width * std::cos(a), -0.2 + height * std::sin(a)});
  return p;
}

Assembly assemble_rim(const std::vector<Polyhedron>& shapes, double size, std::optional<double> base_z = std::nullopt) {
  return assemble(parts_of(shapes, size), base_z, SegmentRule::rim);
}

}  // namespace

TEST_SUITE("corner points") {
  TEST_CASE("exact area and first moments, positive weights; of a parallelogram equal ones") {
    Random random(17);
    for (int k = 0; k < 400; ++k) check_corners(random_polygon(random, 3 + k % 8));
    for (const Segment& p : check_corners({{0.0, 0.0}, {0.3, 0.1}, {0.35, 0.25}, {0.05, 0.15}}))
      CHECK(p.area == relative(0.04 / 4.0, 1e-12));
  }

  TEST_CASE("a polygon that is turned, mirrored or begins with another corner has the same weights") {
    Random random(18);
    for (int k = 0; k < 100; ++k) {
      const Polygon p = random_polygon(random, 3 + k % 6);
      const double angle = random.uniform(0.0, 6.0);
      Polygon other;
      for (auto q = p.rbegin(); q != p.rend(); ++q)
        other.push_back({std::cos(angle) * q->s + std::sin(angle) * q->t, std::sin(angle) * q->s - std::cos(angle) * q->t});
      std::rotate(other.begin(), other.begin() + 1, other.end());
      const auto points = check_corners(p), others = check_corners(other);
      for (std::size_t i = 0; i < p.size(); ++i) CHECK(points[i].area == relative(others[(2 * p.size() - 2 - i) % p.size()].area, 1e-10));
    }
  }

  TEST_CASE("corners that coincide or lie in line are no points") {
    std::vector<Segment> points;
    append_corner_points({{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.2, 0.1 + 1e-13}, {0.0, 0.1}}, points);
    REQUIRE(points.size() == 4);
    for (const Segment& p : points) CHECK(p.area == relative(0.005, 1e-9));
  }
}

TEST_SUITE("rim points") {
  TEST_CASE("rectangles: exact moments, positive weights, points at the corners") {
    Random random(11);
    for (int k = 0; k < 200; ++k) {
      const double s = random.uniform(-1.0, 1.0), t = random.uniform(-1.0, 1.0), size = random.uniform(0.01, 0.2);
      check_rule(to_polygon({{s, t}, {s + random.uniform(0.02, 0.5), t + random.uniform(0.02, 0.5)}}), size);
    }
  }

  TEST_CASE("a rectangle has as many points a row as cells, to within one, and at least three") {
    const int expected[] = {3, 3, 3, 4, 5, 7, 7, 7, 10, 10, 10, 13};
    for (int n = 1; n <= 12; ++n) {
      const auto points = check_rule(to_polygon({{0.0, 0.0}, {0.1 * n, 0.1}}), 0.1);
      CHECK(points.size() == static_cast<std::size_t>(3 * expected[n - 1]));
    }
    const auto points = check_rule(to_polygon({{0.0, 0.0}, {0.2, 0.2}}), 0.05);
    REQUIRE(points.size() == 16);
    CHECK(points[0].area == relative(0.04 / 144.0, 1e-14));
    CHECK(points[5].area == relative(0.04 * 25.0 / 144.0, 1e-14));
    CHECK(points[1].s == relative(0.1 * (1.0 - 1.0 / std::sqrt(5.0)), 1e-14));
  }

  TEST_CASE("triangles to octagons, coarse and fine") {
    Random random(12);
    for (int k = 0; k < 300; ++k) check_rule(random_polygon(random, 3 + k % 6), random.uniform(0.03, 0.5));
  }

  TEST_CASE("triangles are exact to the third degree, which fixes the weights") {
    // Second moments alone leave one of the seven weights free.
    Random random(15);
    for (int k = 0; k < 120; ++k) {
      const Polygon p = random_polygon(random, k % 4 == 0 ? 3 : 4 + k % 4);
      if (p.size() == 4) continue;
      const auto points = check_rule(p, random.uniform(0.03, 0.5));
      for (const Point2 along : {Point2{1.0, 0.0}, {0.0, 1.0}, {0.6, 0.8}, {0.8, -0.6}})
        check_third_moment(points, p, region(p).centroid, along);
    }
  }

  TEST_CASE("what two rectangles share when one is turned: up to an octagon") {
    Random random(13);
    std::size_t most = 0;
    for (int k = 0; k < 200; ++k) {
      const double angle = random.uniform(0.0, 3.0), c = std::cos(angle), s = std::sin(angle);
      const Polygon a = to_polygon({{-0.1, -0.1}, {0.1, random.uniform(0.05, 0.1)}});
      Polygon b;
      for (const Point2 p : to_polygon({{-0.1, -0.1}, {0.1, 0.1}})) b.push_back({c * p.s - s * p.t + 0.01, s * p.s + c * p.t});
      const Polygon shared = intersection(a, b);
      if (shared.empty()) continue;
      most = std::max(most, shared.size());
      check_rule(shared, 0.05);
    }
    CHECK(most == 8);
  }

  TEST_CASE("a corner that is none gets no point, and takes no weight along") {
    // The middle of the lower edge is a corner in name only.
    const Polygon p{{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.0, 0.1}};
    std::vector<Segment> with, without;
    append_rim_points(p, 0.05, with);
    append_rim_points({{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.0, 0.1}}, 0.05, without);
    REQUIRE(with.size() == without.size());
    CHECK(sum_of_areas(with) == relative(0.02, 1e-14));
    std::vector<Segment> triangle;
    append_rim_points({{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}, {0.0, 0.1}}, 1.0, triangle);
    CHECK(triangle.size() == 7);
  }

  TEST_CASE("a polygon over another: convex parts that sum to the difference") {
    Random random(14);
    for (int k = 0; k < 200; ++k) {
      const Polygon a = random_polygon(random, 3 + k % 6), b = random_polygon(random, 3 + k % 5);
      std::vector<Polygon> parts;
      append_difference(a, b, parts);
      double sum = 0.0;
      for (const Polygon& p : parts) sum += region(p).area;
      CHECK(near(sum, region(a).area - region(intersection(a, b)).area, 1e-12));
      for (const Polygon& p : parts) {
        if (region(p).area > 1e-6) CHECK(region(intersection(p, b)).area < 1e-12);
      }
    }
  }

  TEST_CASE("a polygon with a corner twice takes away what it covers, and no part is there twice") {
    const Polygon a = to_polygon({{0.0, 0.0}, {0.2, 0.1}});
    const Polygon b{{0.1, 0.0}, {0.2, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.1 - 1e-13}};
    std::vector<Polygon> parts;
    append_difference(a, b, parts);
    double sum = 0.0;
    for (const Polygon& p : parts) sum += region(p).area;
    CHECK(sum == relative(0.01, 1e-10));
  }

  TEST_CASE("edges moved in; of a strip too narrow for it, half is left") {
    const Polygon in = moved_in(to_polygon({{0.0, 0.0}, {0.2, 0.1}}), 0.01);
    const Rectangle box = bounds(in);
    CHECK(near(box.low.s, 0.01, 1e-15));
    CHECK(near(box.high.s, 0.19, 1e-15));
    CHECK(near(box.high.t, 0.09, 1e-15));
    CHECK(region(moved_in(to_polygon({{0.0, 0.0}, {0.2, 0.01}}), 0.01)).area == relative(0.25 * 0.002, 1e-12));
  }
}

TEST_SUITE("assembly to the rim") {
  TEST_CASE("bricks off any grid: one set of points for both, at the corners of the overlap") {
    const Assembly a = assemble_rim({box_at({0, 0, 0}, {0.2, 0.1, 0.1}), box_at({0.04, 0.01, 0.1}, {0.2, 0.1, 0.1})}, 0.025);
    check_invariants(a);
    REQUIRE(a.joints.size() == 1);
    const Joint& j = a.joints[0];
    CHECK(j.merged);
    CHECK(j.side_b.empty());
    for (const double x : {0.04, 0.2}) {
      for (const double y : {0.01, 0.1}) {
        CHECK(std::ranges::any_of(j.side_a, [&](const Segment& p) { return near(point_of(j.frame(), p), {x, y, 0.1}, 1e-11); }));
      }
    }
    double ss = 0.0;
    for (const Segment& p : j.side_a) ss += p.area * p.s * p.s;
    CHECK(ss == relative(0.09 * std::pow(0.16, 3) / 12.0, 1e-9));
  }

  TEST_CASE("the smaller segments of two elements are those of their joint") {
    const Polyhedron below = box_at({0, 0, 0}, {0.2, 0.1, 0.1}), above = box_at({0, 0, 0.1}, {0.2, 0.1, 0.1});
    for (const bool first_is_finer : {true, false}) {
      const std::vector<Part> parts{{&below, first_is_finer ? 0.025 : 0.05, true}, {&above, first_is_finer ? 0.05 : 0.025, true}};
      const Assembly a = assemble(parts, std::nullopt, SegmentRule::rim);
      REQUIRE(a.joints.size() == 1);
      CHECK(a.joints[0].side_a.size() == 7 * 4);
    }
  }

  TEST_CASE("a free remainder of three neighbours: its area, points inside of it, none on a joint") {
    const Assembly a = assemble_rim({box_at({0, 0, 0}, {0.4, 0.1, 0.1}), box_at({-0.07, 0, 0.1}, {0.2, 0.1, 0.1}),
                                     box_at({0.13, 0, 0.1}, {0.12, 0.05, 0.1}), box_at({0.25, 0.03, 0.1}, {0.2, 0.1, 0.1})},
                                    0.025);
    check_invariants(a);
    CHECK(free_area(a, 0, 5) == relative(0.04 - 0.013 - 0.006 - 0.0105, 1e-9));
    const auto patch = std::ranges::find_if(a.patches, [](const FreePatch& p) { return p.element == 0 && p.face == 5; });
    REQUIRE(patch != a.patches.end());
    for (const Segment& p : patch->segments) {
      CHECK(p.area > 0.0);
      const Vec3 at = point_of(patch->frame(), p);
      CHECK((at.x > 2e-4 && at.x < 0.4 - 2e-4 && at.y > 2e-4 && at.y < 0.1 - 2e-4));
      CHECK_FALSE((at.x < 0.13 + 2e-4));
      CHECK_FALSE((at.x < 0.25 + 2e-4 && at.y < 0.05 + 2e-4));
      CHECK_FALSE((at.x > 0.25 - 2e-4 && at.y > 0.03 - 2e-4));
    }
  }

  TEST_CASE("a wall: all joints merged, equal joints with equal bits") {
    const Assembly a = assemble_rim(running_wall(6, 5), 0.025, 0.0);
    check_invariants(a);
    const Joint* bed = nullptr;
    for (const Joint& j : a.joints) {
      CHECK(j.merged == (j.element_b != kBase));
      if (std::abs(j.frame().normal.z) < 0.5 || j.element_b == kBase) continue;
      if (bed != nullptr) CHECK(same(j.side_a, bed->side_a));
      bed = &j;
    }
    CHECK(bed != nullptr);
  }

  TEST_CASE("a brick turned on another shares an octagon with it") {
    Polyhedron turned = box_at({-0.1, -0.1, 0.1}, {0.2, 0.2, 0.1});
    for (Vec3& v : turned.vertices) v = {0.1 + (v.x - v.y) * std::sqrt(0.5), 0.1 + (v.x + v.y) * std::sqrt(0.5), v.z};
    const Assembly a = assemble_rim({box_at({0, 0, 0}, {0.2, 0.2, 0.1}), turned}, 0.05, 0.0);
    check_invariants(a);
    REQUIRE(a.joints.size() == 2);
    CHECK(free_area(a, 0, 5) == relative(0.04 - a.joints[1].area, 1e-9));
  }
}
