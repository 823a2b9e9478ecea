// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/solids/pieces.h"
#include "geometry/solids/triangles.h"
#include "tests/io/input/stones/stones_fixture.h"
#include "tests/io/input/stones/turned_mesh.h"

// Stones of triangles at any angle, with coordinates as files hold them: what was drawn plane has dents of the last digit.
using namespace stones;
using namespace voussoir;

namespace {

struct Point {
  double x, y;
};

Mesh prism(const std::vector<Point>& outline, double height) {
  Mesh m;
  const int n = static_cast<int>(outline.size());
  for (const double z : {0.0, height}) {
    for (const Point p : outline) m.vertices.push_back({p.x, p.y, z});
  }
  std::vector<std::int32_t> low, high;
  for (int i = 0; i < n; ++i) {
    high.push_back(n + i);
    low.push_back(n - 1 - i);
    m.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  m.faces.push_back(low);
  m.faces.push_back(high);
  return m;
}

Mesh in_ears(const Mesh& m) {
  Mesh out{m.vertices, {}};
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    for (const auto& triangle : geometry::triangles_of(m, f)) {
      std::vector<std::int32_t> loop;
      for (const Vec3 corner : triangle) {
        for (const std::int32_t v : m.faces[f]) {
          if (m.vertices[static_cast<std::size_t>(v)] == corner) loop.push_back(v);
        }
      }
      out.faces.push_back(loop);
    }
  }
  return out;
}

std::vector<Point> voussoir_of_arch() {
  std::vector<Point> out;
  for (int i = 0; i <= 8; ++i) out.push_back({1.3 * std::cos(0.3 + 0.1 * i), 1.3 * std::sin(0.3 + 0.1 * i)});
  for (int i = 8; i >= 0; --i) out.push_back({std::cos(0.3 + 0.1 * i), std::sin(0.3 + 0.1 * i)});
  return out;
}

const std::vector<Point> kAngle{{0, 0}, {.4, 0}, {.4, .2}, {.2, .2}, {.2, .4}, {0, .4}};
const std::vector<Point> kChannel{{0, 0}, {.6, 0}, {.6, .4}, {.4, .4}, {.4, .2}, {.2, .2}, {.2, .4}, {0, .4}};

Mesh in_single_precision(Mesh m, double unit) {
  for (Vec3& v : m.vertices) {
    for (double* x : {&v.x, &v.y, &v.z}) *x = static_cast<double>(static_cast<float>(*x / unit)) * unit;
  }
  return m;
}

/// Volume of its pieces over that of the file, less one; no number if it is refused.
double excess(const Mesh& m, double snap) {
  const TempFolder folder;
  try {
    const auto c = load(folder.write("stone.obj", obj({{"stone", m}})), "snap = " + number(snap) + "\n");
    double sum = 0.0;
    for (const auto& piece : c.stones[0].stones[0].pieces) sum += geometry::volume({piece.shape.vertices, piece.shape.faces});
    return sum / geometry::volume(m) - 1.0;
  } catch (const std::exception& e) {
    MESSAGE(std::string(e.what()));
    return std::nan("");
  }
}

}  // namespace

TEST_CASE("A corner on the diagonal of an ear keeps the ear from being cut off") {
  const Mesh m = prism({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, 1.0);
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const auto plane = geometry::loop_plane(m, f);
    for (const auto& t : geometry::triangles_of(m, f)) CHECK(dot(cross(t[1] - t[0], t[2] - t[0]), plane.normal) > 0.01);
  }
  std::size_t parted = 0;
  const Mesh triangles = geometry::with_parted_faces(m, 0.0, parted);
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) CHECK(geometry::loop_plane(triangles, f).area > 0.01);
}

TEST_CASE("Stones that are not convex, of triangles with rounded coordinates, are taken at any angle") {
  std::mt19937 random(5);
  for (const auto& outline : {kAngle, kChannel, voussoir_of_arch()}) {
    const Mesh stone = in_ears(prism(outline, 0.3));
    for (const double grain : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
      for (int k = 0; k < 5; ++k) {
        CAPTURE(grain);
        CAPTURE(k);
        const double e = excess(rounded(turned(stone, random), grain), 1e-3);
        CHECK(std::abs(e) < 1e-9 + 30.0 * std::min(grain, 1e-5));  // surface over volume: at most 20 / m; dents above 1e-5 m are cut
      }
    }
    for (const double unit : {1.0, 1e-3}) {
      for (int k = 0; k < 5; ++k) CHECK(std::abs(excess(in_single_precision(turned(stone, random), unit), 1e-3)) < 1e-6);
    }
  }
}

TEST_CASE("Cutting ends for boxes of triangles with rounded corners, with all of them") {
  std::mt19937 random(5);
  const Mesh drawn = in_ears(box({-0.2, -0.15, -0.1}, {0.2, 0.15, 0.1}));
  for (const double grain : {1e-5, 1e-6, 1e-7, 1e-8}) {
    for (int k = 0; k < 40; ++k) {
      const Mesh stone = rounded(turned(drawn, random), grain);
      CAPTURE(grain);
      CAPTURE(k);
      // without planes that leave a cell whole: within the bound of cuts, so that none goes on for ever
      try {
        geometry::convex_pieces(stone, 0.0);
      } catch (const geometry::ModelError& e) {
        CHECK(std::string(e.what()).find("more than 500") == std::string::npos);
      }
      CHECK(std::abs(excess(stone, 0.0)) < 1e-4);
    }
  }
}
