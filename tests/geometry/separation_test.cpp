// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/separation.h"

#include <algorithm>
#include <numbers>

#include "fixtures.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

constexpr double kPi = std::numbers::pi;

Mat3 turn(Vec3 axis, double degrees) {
  const Vec3 n = normalised(axis);
  const double half = 0.5 * degrees * kPi / 180.0, s = std::sin(half);
  return rotation({std::cos(half), s * n.x, s * n.y, s * n.z});
}

Vec3 direction(Random& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (dot(v, v) < 1.0 && dot(v, v) > 1e-2) return normalised(v);
  }
}

Mat3 any_turn(Random& random) { return turn(direction(random), random.uniform(0, 180)); }

/// Centred at the origin.
ConvexBody box(Vec3 edges) { return convex_body(make_box(-0.5 * edges, 0.5 * edges)); }

/// A brick, a flat brick, a wedge, a voussoir of a ring, and a prism over a pentagon.
std::vector<ConvexBody> shapes() {
  using Corners = std::vector<std::array<double, 2>>;
  std::vector<ConvexBody> all{box({0.2, 0.2, 0.1}), box({0.4, 0.1, 0.05})};
  all.push_back(convex_body(make_prism(Corners{{-0.1, -0.05}, {0.1, -0.05}, {-0.1, 0.06}}, -0.1, 0.1)));
  all.push_back(convex_body(make_prism(Corners{{-0.04, -0.1}, {0.04, -0.1}, {0.06, 0.1}, {-0.06, 0.1}}, -0.1, 0.1)));
  all.push_back(convex_body(make_prism(Corners{{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0.03}, {0.0, 0.09}, {-0.1, 0.03}}, -0.05, 0.05)));
  return all;
}

/// Brute force without a face or an edge of either body, by the differences of all their vertices: every triangle over three of them lies
/// in the difference of the bodies, and its surface is made of such triangles.
struct Differences {
  std::vector<Vec3> point;
  Differences(const ConvexBody& a, const ConvexBody& b) {
    for (const Vec3& v : a.vertices) {
      for (const Vec3& w : b.vertices) point.push_back(v - w);
    }
  }
  template <class Look>
  void each_triangle(const Look& look) const {
    for (std::size_t i = 0; i < point.size(); ++i) {
      for (std::size_t j = i + 1; j < point.size(); ++j) {
        for (std::size_t k = j + 1; k < point.size(); ++k) {
          const Vec3 product = cross(point[j] - point[i], point[k] - point[i]);
          if (norm(product) > 1e-9) look(point[i], point[j], point[k], normalised(product));
        }
      }
    }
  }
};

/// Of bodies that overlap: the least distance of the origin to a plane through three differences that has all others on one side.
double depth_by_all_planes(const ConvexBody& a, const ConvexBody& b) {
  const Differences d(a, b);
  double least = 1e300;
  d.each_triangle([&](Vec3 p, Vec3, Vec3, Vec3 normal) {
    const Vec3 n = dot(normal, p) < 0.0 ? -normal : normal;
    const double offset = dot(n, p);
    if (offset < least && std::ranges::all_of(d.point, [&](Vec3 v) { return dot(n, v) <= offset + 1e-12; })) least = offset;
  });
  return least;
}

double to_segment(Vec3 p, Vec3 q) {
  const double t = std::clamp(-dot(p, q - p) / dot(q - p, q - p), 0.0, 1.0);
  return norm(p + t * (q - p));
}

/// Of bodies that are apart: the least distance of the origin to all triangles.
double distance_by_all_triangles(const ConvexBody& a, const ConvexBody& b) {
  double least = 1e300;
  Differences(a, b).each_triangle([&](Vec3 p, Vec3 q, Vec3 r, Vec3 n) {
    const Vec3 foot = dot(n, p) * n;
    const auto inside = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, foot - from), n) >= 0.0; };
    if (inside(p, q) && inside(q, r) && inside(r, p)) least = std::min(least, std::abs(dot(n, p)));
    least = std::min({least, to_segment(p, q), to_segment(q, r), to_segment(r, p)});
  });
  return least;
}

}  // namespace

TEST_SUITE("separation") {
  TEST_CASE("a body has the edges and directions of its polyhedron") {
    const std::vector<ConvexBody> all = shapes();
    CHECK(all[0].edges.size() == 12);
    CHECK(all[0].directions.size() == 3);
    CHECK(all[2].edges.size() == 9);
    CHECK(all[2].directions.size() == 4);
    CHECK(all[4].edges.size() == 15);
  }

  TEST_CASE("boxes along the axes: the least of three overlaps, and the distance of faces, edges and corners") {
    const ConvexBody a = box({0.2, 0.1, 0.06});
    const auto at = [&](Vec3 by) { return placed(a, Mat3{}, by); };
    const Penetration in_x = penetration_of(a, at({0.19, 0.02, 0.01}));
    CHECK(in_x.depth == relative(0.01, 1e-13));
    CHECK(near(in_x.axis, {1, 0, 0}, 1e-15));
    CHECK(penetration_of(a, at({-0.15, -0.04, -0.055})).depth == relative(0.005, 1e-12));
    CHECK(near(penetration_of(a, at({-0.15, -0.04, -0.055})).axis, {0, 0, -1}, 1e-15));
    CHECK(penetration_of(a, a).depth == relative(0.06, 1e-14));
    CHECK(distance(a, at({0.19, 0.02, 0.01})) == 0.0);
    CHECK(distance(a, at({0.23, 0.02, 0.01})) == relative(0.03, 1e-12));
    CHECK(distance(a, at({0.23, 0.14, 0.01})) == relative(0.05, 1e-12));
    CHECK(distance(a, at({0.22, 0.12, 0.07})) == relative(0.03, 1e-12));  // corners: 0.02, 0.02, 0.01
  }

  TEST_CASE("a box on its edge, on its corner, and across another's edge") {
    const double s = 0.1;
    const ConvexBody cube = box({s, s, s}), plate = placed(box({1, 1, 0.2}), Mat3{}, {0, 0, -0.1});
    const double to_edge = s / std::sqrt(2.0), to_corner = 0.5 * s * std::sqrt(3.0);
    const Mat3 on_edge = turn({1, 0, 0}, 45.0);
    const Mat3 on_corner = turn({1, -1, 0}, std::acos(1.0 / std::sqrt(3.0)) * 180.0 / kPi);
    for (const double height : {-0.007, -1e-6, 1e-6, 0.02}) {
      CAPTURE(height);
      for (const auto& [rotation, reach] : {std::pair{on_edge, to_edge}, std::pair{on_corner, to_corner}}) {
        const ConvexBody b = placed(cube, rotation, {0.1, 0.05, reach + height});
        CHECK(near(penetration_of(plate, b).depth, -height, 1e-14));
        CHECK(near(depth_under(b, 0.0), -height, 1e-14));
        CHECK(near(distance(plate, b), std::max(0.0, height), 1e-14));
      }
      // Two edges at right angles, one above the other: no face of either parts them best.
      const ConvexBody lower = placed(box({0.4, s, s}), on_edge, {0, 0, -to_edge});
      const ConvexBody upper = placed(box({s, 0.4, s}), turn({0, 1, 0}, 45.0), {0.03, 0.02, to_edge + height});
      const Penetration p = penetration_of(lower, upper);
      CHECK(near(p.depth, -height, 1e-14));
      CHECK(near(p.axis, {0, 0, 1}, 1e-12));
      CHECK(near(distance(lower, upper), std::max(0.0, height), 1e-14));
    }
  }

  TEST_CASE("the edge of a wedge in a plate, and its flank along it") {
    using Corners = std::vector<std::array<double, 2>>;
    const ConvexBody wedge = convex_body(make_prism(Corners{{0.0, 0.0}, {0.03, 0.1}, {-0.03, 0.1}}, -0.1, 0.1));
    const ConvexBody plate = convex_body(make_box({-1, -1, -0.2}, {1, 1, 0}));
    CHECK(penetration_of(placed(wedge, Mat3{}, {0, 0, -0.004}), plate).depth == relative(0.004, 1e-12));
    // Turned until a flank lies on the plate, its long edge down.
    const double flank = std::atan2(0.1, 0.03) * 180.0 / kPi;
    const ConvexBody lying = placed(wedge, turn({1, 0, 0}, -flank), {0, 0, -0.002});
    CHECK(penetration_of(lying, plate).depth == relative(0.002, 1e-10));
  }

  TEST_CASE("either body may be named first, and where both are turned alike nothing changes") {
    Random random(7);
    const std::vector<ConvexBody> all = shapes();
    for (int i = 0; i < 2000; ++i) {
      const ConvexBody& first = all[static_cast<std::size_t>(i) % all.size()];
      const ConvexBody& second = all[static_cast<std::size_t>(i / 5) % all.size()];
      const ConvexBody a = placed(first, any_turn(random), {});
      const ConvexBody b = placed(second, any_turn(random), random.uniform(0.05, 0.3) * direction(random));
      const Penetration p = penetration_of(a, b), back = penetration_of(b, a);
      CHECK(near(p.depth, back.depth, 1e-14));
      const Mat3 all_turn = any_turn(random);
      const Vec3 by = 100.0 * direction(random);
      const ConvexBody ta = placed(a, all_turn, by), tb = placed(b, all_turn, by);
      CHECK(near(penetration_of(ta, tb).depth, p.depth, 1e-12));
      CHECK(near(distance(a, b), distance(b, a), 1e-14));
      CHECK(near(distance(ta, tb), distance(a, b), 1e-12));
      if (p.depth <= 0.0) continue;
      // A little more than the depth along the axis parts them, a little less does not.
      CHECK(near(penetration_of(a, placed(b, Mat3{}, 1.0001 * p.depth * p.axis)).depth, -1e-4 * p.depth, 1e-13));
      CHECK(penetration_of(a, placed(b, Mat3{}, 0.999 * p.depth * p.axis)).depth > 0.0);
    }
  }

  TEST_CASE("depth and distance are those of brute force") {
    Random random(11);
    const std::vector<ConvexBody> all = shapes();
    int apart = 0, in = 0;
    for (int i = 0; i < 60; ++i) {
      const ConvexBody a = placed(all[static_cast<std::size_t>(i) % all.size()], any_turn(random), {});
      const ConvexBody b =
          placed(all[static_cast<std::size_t>(i / 3) % all.size()], any_turn(random), random.uniform(0.05, 0.35) * direction(random));
      const double depth = penetration_of(a, b).depth;
      CAPTURE(i);
      if (depth > 0.0) {
        CHECK(std::abs(depth - depth_by_all_planes(a, b)) < 1e-12);
        ++in;
      } else {
        CHECK(std::abs(distance(a, b) - distance_by_all_triangles(a, b)) < 1e-12);
        CHECK(-depth <= distance(a, b) + 1e-14);  // what an axis shows is never more than the distance
        ++apart;
      }
    }
    CHECK(apart > 15);
    CHECK(in > 15);
  }

  TEST_CASE("a look that asks for a least depth stops at an axis that shows no more") {
    const ConvexBody a = box({0.2, 0.2, 0.2});
    const ConvexBody b = placed(a, Mat3{}, {0.18, 0.19, 0.15});
    CHECK(penetration_of(a, b).depth == relative(0.01, 1e-12));
    CHECK(penetration_of(a, b, 0.005).depth == relative(0.01, 1e-12));
    CHECK(penetration_of(a, b, 0.03).depth <= 0.03);
    CHECK(penetration_of(a, b, 0.03).depth >= 0.01 - 1e-15);
  }
}
