// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/face_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "fixtures.h"
#include "geometry/polygon.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

double area_of(const std::vector<Piece>& pieces) {
  double sum = 0.0;
  for (const Piece& p : pieces) sum += p.area;
  return sum;
}

Point2 centroid_of(const std::vector<Piece>& pieces) {
  Point2 c;
  for (const Piece& p : pieces) c.s += p.area * p.centroid.s, c.t += p.area * p.centroid.t;
  return {c.s / area_of(pieces), c.t / area_of(pieces)};
}

std::vector<Piece> cut(const FaceGrid& g, const Polygon& polygon) {
  Cutter cutter;
  std::vector<Piece> out;
  cutter.cut(g, polygon, out);
  return out;
}

Polygon regular(int corners, double radius, Point2 centre, double turn) {
  Polygon p;
  for (int i = 0; i < corners; ++i) {
    const double a = turn + 2.0 * 3.14159265358979 * i / corners;
    p.push_back({centre.s + radius * std::cos(a), centre.t + radius * std::sin(a)});
  }
  return p;
}

}  // namespace

TEST_SUITE("polygon") {
  TEST_CASE("area and centroid, also far from the origin") {
    const Polygon triangle{{0, 0}, {3, 0}, {0, 6}};
    CHECK(region(triangle).area == 9.0);
    CHECK(region(triangle).centroid == Point2{1, 2});
    const Polygon far{{1e6, 1e6}, {1e6 + 3, 1e6}, {1e6, 1e6 + 6}};
    CHECK(region(far).area == 9.0);
    CHECK(region(Polygon{{0, 0}, {1, 1}}).area == 0.0);
  }

  TEST_CASE("intersection of rectangles is exact, of others right to round-off") {
    const Polygon a{{0, 0}, {0.3, 0}, {0.3, 0.1}, {0, 0.1}}, b{{0.1, -1}, {0.7, -1}, {0.7, 0.05}, {0.1, 0.05}};
    CHECK(intersection(a, b) == Polygon{{0.1, 0}, {0.3, 0}, {0.3, 0.05}, {0.1, 0.05}});
    const Polygon apart{{0.3, 0}, {0.4, 0}, {0.4, 0.1}, {0.3, 0.1}};
    CHECK(intersection(a, apart).empty());

    // A square and the same turned by 45°: the octagon of area 8 (√2 − 1) r² for half edge r.
    const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double reach = std::sqrt(2.0);
    const Polygon turned{{reach, 0}, {0, reach}, {-reach, 0}, {0, -reach}};
    CHECK(region(intersection(square, turned)).area == relative(8 * (std::sqrt(2.0) - 1), 1e-14));
    CHECK(region(intersection(turned, square)).area == relative(8 * (std::sqrt(2.0) - 1), 1e-14));
    CHECK(intersection(square, regular(5, 1.0, {4, 0}, 0.1)).empty());
  }
}

TEST_SUITE("face_grid") {
  TEST_CASE("the grid of a nearly regular face lies along its longest edge, in whatever order its corners stand") {
    for (const int number : {3, 5, 6, 7}) {
      // One edge is longer by some 1e-5 of its length.
      Polygon corners = regular(number, 1.0, {0.0, 0.0}, 0.1);
      const double ds = corners[2].s - corners[1].s, dt = corners[2].t - corners[1].t;
      corners[2].s += 1e-5 * ds, corners[2].t += 1e-5 * dt;
      for (std::size_t first = 0; first < corners.size(); ++first) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        std::vector<std::array<double, 2>> plan;
        for (const Point2& c : corners) plan.push_back({c.s, c.t});
        const Polyhedron p = make_prism(plan, 0.0, 1.0);
        for (int face = 0; face < static_cast<int>(p.faces.size()); ++face) {
          if (p.faces[static_cast<std::size_t>(face)].size() != corners.size() || std::abs(face_plane(p, face).normal.x) < 0.5) continue;
          const FaceGrid g = make_face_grid(p, face, 0.3);
          CHECK(std::abs(g.axis_s.y * dt - g.axis_s.z * ds) < 1e-4);  // or the opposite edge
        }
      }
    }
  }

  TEST_CASE("n = max(1, round(edge / size)) cells a direction, along the longest edge") {
    const Polyhedron p = make_box({0, 0, 0}, {0.2, 0.1, 0.06});
    const FaceGrid top = make_face_grid(p, 5, 0.025);
    CHECK(top.columns == 8);
    CHECK(top.rows == 4);
    CHECK(top.axis_s == Vec3{1, 0, 0});
    CHECK(top.normal == Vec3{0, 0, 1});
    CHECK(cross(top.axis_s, top.axis_t) == top.normal);
    CHECK(top.cell_width == relative(0.025, 1e-11));
    const FaceGrid side = make_face_grid(p, 0, 0.025);
    CHECK(side.columns == 4);
    CHECK(side.rows == 2);  // 0.06 / 0.025 = 2.4
    CHECK(std::abs(side.axis_s.y) == 1.0);
    const FaceGrid coarse = make_face_grid(p, 5, 0.7);
    CHECK(coarse.cell_count() == 1);
  }

  TEST_CASE("the grid does not depend on where the block lies") {
    Random random(21);
    const FaceGrid here = make_face_grid(box_at({0, 0, 0}, {0.2, 0.2, 0.1}), 5, 0.025);
    for (int k = 0; k < 100; ++k) {
      const Vec3 low{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)};
      const FaceGrid there = make_face_grid(box_at(low, {0.2, 0.2, 0.1}), 5, 0.025);
      CHECK(there.axis_s == here.axis_s);
      CHECK(there.polygon == here.polygon);
      CHECK(there.cell_width == here.cell_width);
    }
  }

  TEST_CASE("an edge of some cells and a half has the same number of them wherever the block lies: halves up") {
    const FaceGrid here = make_face_grid(make_box({0.1, 0, 0}, {0.2, 0.1, 0.3}), 5, 0.04);
    const FaceGrid there = make_face_grid(make_box({0.2, 0, 0}, {0.3, 0.1, 0.3}), 5, 0.04);  // 0.3 - 0.2 is less than 0.1
    CHECK(here.columns == 3);
    CHECK(there.columns == 3);
    CHECK(here.rows == there.rows);
  }

  TEST_CASE("the raster of a micrometre gives no face another number of cells, and turns no grid") {
    const FaceGrid drawn = make_face_grid(make_box({0, 0, 0}, {0.1, 0.1, 0.3}), 5, 0.04);
    for (const double x : {0.099999, 0.1, 0.100001}) {
      for (const double y : {0.099999, 0.1, 0.100001}) {
        const FaceGrid laid = make_face_grid(make_box({0, 0, 0}, {x, y, 0.3}), 5, 0.04);
        CHECK(laid.columns == 3);
        CHECK(laid.rows == 3);
        CHECK(norm(laid.axis_s - drawn.axis_s) < 1e-12);
      }
    }
    CHECK(make_face_grid(make_box({0, 0, 0}, {0.09, 0.09, 0.3}), 5, 0.04).columns == 2);
  }

  TEST_CASE("the whole face is cut into whole, equal cells, row by row") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.2, 0.1, 0.06}), 5, 0.025);
    const std::vector<Piece> pieces = cut(g, g.polygon);
    REQUIRE(pieces.size() == 32);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      CHECK(pieces[i].cell == static_cast<std::int32_t>(i));
      CHECK(pieces[i].area == g.cell_area());
    }
    CHECK(near(pieces[9].centroid.s, 0.0375, 1e-12));
    CHECK(near(pieces[9].centroid.t, 0.0375, 1e-12));
  }

  TEST_CASE("an edge meant to lie on a cell line lies on it: whole cells, no slivers") {
    const FaceGrid g = make_face_grid(make_box({0.1, 0.2, 0.3}, {0.8, 0.5, 0.4}), 5, 0.1);
    REQUIRE(g.columns == 7);
    for (int k = 1; k <= 6; ++k) {
      const double edge = snapped(0.1 * k, g.quantum);
      const std::vector<Piece> left = cut(g, {{0, 0}, {edge, 0}, {edge, g.height}, {0, g.height}});
      const std::vector<Piece> right = cut(g, {{edge, 0}, {g.width, 0}, {g.width, g.height}, {edge, g.height}});
      CHECK(left.size() == static_cast<std::size_t>(3 * k));
      CHECK(right.size() == static_cast<std::size_t>(3 * (7 - k)));
      for (const auto* pieces : {&left, &right}) {
        for (const Piece& p : *pieces) CHECK(p.area == g.cell_area());
      }
    }
  }

  TEST_CASE("what sticks out of the face by round-off is not lost") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.2, 0.1, 0.1}), 5, 0.025);
    const double thin = 1e-6, out = 1e-12;
    for (const Rectangle r : {Rectangle{{g.width - thin, 0}, {g.width + out, 0.1}}, Rectangle{{-out, 0}, {thin, 0.1}},
                              Rectangle{{0, g.height - thin}, {0.2, g.height + out}}, Rectangle{{0, -out}, {0.2, thin}}}) {
      Polygon five = to_polygon(r);
      five.insert(five.begin() + 1, {0.5 * (r.low.s + r.high.s), r.low.t});
      CHECK(area_of(cut(g, to_polygon(r))) == relative(region(to_polygon(r)).area, 1e-10));
      CHECK(area_of(cut(g, five)) == relative(region(five).area, 1e-10));
    }
  }

  TEST_CASE("pieces sum to the polygon, in area and in first moment") {
    Random random(22);
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.4, 0.3, 0.1}), 5, 0.03);
    for (int k = 0; k < 300; ++k) {
      const int corners = 3 + k % 6;
      const Polygon blob = regular(corners, random.uniform(0.002, 0.14), {random.uniform(0.15, 0.25), 0.15}, random.uniform(0, 6));
      const Region r = region(blob);
      const std::vector<Piece> pieces = cut(g, blob);
      CHECK(area_of(pieces) == relative(r.area, 1e-10));
      CHECK(near(centroid_of(pieces).s, r.centroid.s, 1e-12));
      CHECK(near(centroid_of(pieces).t, r.centroid.t, 1e-12));

      std::vector<Piece> merged = pieces;
      merge_small(g, merged);
      CHECK(area_of(merged) == relative(r.area, 1e-10));
      CHECK(near(centroid_of(merged).s, r.centroid.s, 1e-12));
      const auto has_neighbour = [&](const Piece& p) {  // that is no sliver
        return std::ranges::any_of(merged, [&](const Piece& q) {
          const bool beside =
              std::abs(q.cell % g.columns - p.cell % g.columns) < 2 && std::abs(q.cell / g.columns - p.cell / g.columns) < 2;
          return beside && q.area >= kSmallPiece * g.cell_area();
        });
      };
      for (const Piece& p : merged) CHECK((p.area >= kSmallPiece * g.cell_area() || !has_neighbour(p)));
    }
  }

  TEST_CASE("the rectangle's short cut and general clipping agree") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.4, 0.3, 0.1}), 5, 0.03);
    const Polygon rectangle{{0.013, 0.0}, {0.31, 0.0}, {0.31, 0.211}, {0.013, 0.211}};
    Polygon with_corner_more = rectangle;
    with_corner_more.insert(with_corner_more.begin() + 1, {0.1, 0.0});
    const std::vector<Piece> a = cut(g, rectangle), b = cut(g, with_corner_more);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].cell == b[i].cell);
      CHECK(a[i].area == relative(b[i].area, 1e-10));
      CHECK(near(a[i].centroid.s, b[i].centroid.s, 1e-12));
      CHECK(near(a[i].centroid.t, b[i].centroid.t, 1e-12));
    }
  }

  TEST_CASE("a triangular face is clipped by its own edges") {
    const Polyhedron p = make_prism(std::vector<std::array<double, 2>>{{0, 0}, {3, 0}, {0, 4}}, 0.0, 1.0);
    const FaceGrid g = make_face_grid(p, 4, 0.5);
    CHECK(g.columns == 10);  // along the longest edge of 5
    CHECK(g.rows == 5);      // the height on it is 2.4
    CHECK(area_of(cut(g, g.polygon)) == relative(6.0, 1e-10));
  }

  TEST_CASE("a small piece goes to its largest neighbour; alone it stays") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.4, 0.3, 0.1}), 5, 0.1);
    std::vector<Piece> pieces = cut(g, {{0, 0}, {0.1005, 0}, {0.1005, 0.15}, {0, 0.15}});
    REQUIRE(pieces.size() == 4);
    merge_small(g, pieces);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].cell == 0);
    CHECK(pieces[0].area == relative(0.01 + 0.00005 + 0.000025, 1e-10));
    CHECK(pieces[1].area == relative(0.005, 1e-10));

    // The first neighbour found is not the largest here.
    pieces = cut(g, {{0.0995, 0.05}, {0.19, 0.05}, {0.19, 0.19}, {0.0995, 0.19}});
    REQUIRE(pieces.size() == 4);
    merge_small(g, pieces);
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].area == relative(0.0045, 1e-10));
    CHECK(pieces[1].area == relative(0.0081 + 0.000025 + 0.000045, 1e-10));

    std::vector<Piece> alone = cut(g, {{0.01, 0.01}, {0.011, 0.01}, {0.011, 0.011}, {0.01, 0.011}});
    merge_small(g, alone);
    CHECK(alone.size() == 1);
  }

  TEST_CASE("slivers beside a row of equal cells go to the cell beside each, whichever end the row begins at") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.4, 0.3, 0.1}), 5, 0.1);
    std::vector<Piece> pieces = cut(g, {{0.0995, 0}, {0.4, 0}, {0.4, 0.3}, {0.0995, 0.3}});
    REQUIRE(pieces.size() == 12);
    merge_small(g, pieces);
    REQUIRE(pieces.size() == 9);
    for (const Piece& p : pieces) {
      const std::int32_t column = p.cell % 4, row = p.cell / 4;
      CHECK(p.area == relative(column == 1 ? 0.1005 * 0.1 : 0.01, 1e-10));
      CHECK(near(p.centroid.t, (row + 0.5) * 0.1, 1e-12));
    }
  }

  TEST_CASE("a strip that is a sliver all along keeps its pieces") {
    const FaceGrid g = make_face_grid(make_box({0, 0, 0}, {0.4, 0.3, 0.1}), 5, 0.1);
    std::vector<Piece> pieces = cut(g, {{0.13, 0}, {0.1304, 0}, {0.1304, 0.3}, {0.13, 0.3}});
    merge_small(g, pieces);
    REQUIRE(pieces.size() == 3);
    for (const Piece& p : pieces) CHECK(p.area == relative(0.0004 * 0.1, 1e-10));
  }

  TEST_CASE("too many cells are refused") {
    const Polyhedron p = make_box({0, 0, 0}, {10, 10, 1});
    const Complaint c = complaint([&] { make_face_grid(p, 5, 1e-4, 3); });
    CHECK(c.mentions("too small"));
    CHECK(c.subject == 3);
  }
}
