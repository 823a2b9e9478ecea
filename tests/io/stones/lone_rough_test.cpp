// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/solids/pieces.h"
#include "tests/io/stones/stones_fixture.h"
#include "tests/io/stones/written_files.h"

// A rough stone that nothing lies near is taken whatever snap is: its faces need not fit any others.
using namespace stones;
using namespace voussoir;

namespace {

/// A scanned stone: a ball of triangles, 0.4 m wide, with rough radii; or of quadrilaterals that are not quite plane.
Mesh ball(double rough, unsigned seed, bool quads) {
  constexpr int kRings = 5, kAround = 8;
  std::mt19937 random(seed);
  const auto radius = [&] { return 0.2 * (1.0 + rough * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0)); };
  Mesh m;
  m.vertices.push_back({0, 0, -radius()});
  for (int ring = 1; ring <= kRings; ++ring) {
    const double up = M_PI * (static_cast<double>(ring) / (kRings + 1) - 0.5);
    for (int k = 0; k < kAround; ++k) {
      const double turn = 2.0 * M_PI * k / kAround, r = radius();
      m.vertices.push_back({r * std::cos(up) * std::cos(turn), 0.8 * r * std::cos(up) * std::sin(turn), 0.6 * r * std::sin(up)});
    }
  }
  m.vertices.push_back({0, 0, radius()});
  const int last = 1 + kRings * kAround;
  for (int k = 0; k < kAround; ++k) {
    const int next = (k + 1) % kAround;
    m.faces.push_back({0, 1 + next, 1 + k});
    for (int ring = 0; ring + 1 < kRings; ++ring) {
      const int low = 1 + ring * kAround, high = low + kAround;
      m.faces.push_back({low + k, low + next, high + next, high + k});
    }
    m.faces.push_back({last - kAround + k, last - kAround + next, last});
  }
  return quads ? m : in_triangles(m);
}

Mesh placed(Mesh m, double turn, Vec3 by, double unit) {
  for (Vec3& v : m.vertices) {
    const Vec3 t{std::cos(turn) * v.x - std::sin(turn) * v.z, v.y, std::sin(turn) * v.x + std::cos(turn) * v.z};
    v = unit * (t + by);
  }
  return m;
}

Mesh permuted(const Mesh& m) {
  Mesh out = m;
  std::reverse(out.vertices.begin(), out.vertices.end());
  std::reverse(out.faces.begin(), out.faces.end());
  for (auto& loop : out.faces) {
    for (auto& v : loop) v = static_cast<std::int32_t>(m.vertices.size()) - 1 - v;
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
  return out;
}

/// m3; negative if it is refused
double held(const Mesh& m, double snap, const std::string& unit = "m") {
  const TempFolder folder;
  const std::string file = folder.write("stone.obj", obj({{"stone", m}}));
  try {
    const auto c = load(file, "snap = " + number(snap) + "\n", "", unit);
    double sum = 0.0;
    for (const auto& piece : c.stones[0].stones[0].pieces) sum += geometry::volume({piece.shape.vertices, piece.shape.faces});
    return sum;
  } catch (const std::exception& e) {
    MESSAGE(std::string(e.what()));
    return -1.0;
  }
}

}  // namespace

TEST_CASE("A lone rough stone is taken at any snap") {
  for (const double rough : {1e-5, 1e-3, 1e-2, 3e-2}) {
    for (const unsigned seed : {1u, 2u}) {
      const Mesh stone = ball(rough, seed, false);
      const double volume = geometry::volume(stone);
      for (const double snap : {0.0, 1e-4, 1e-3, 2e-3, 5e-3, 2e-2}) {
        CAPTURE(rough);
        CAPTURE(seed);
        CAPTURE(snap);
        CHECK(held(stone, snap) == doctest::Approx(volume).epsilon(0.02));
        CHECK(held(permuted(placed(stone, 0.7, {}, 1e3)), snap, "mm") == doctest::Approx(volume).epsilon(0.02));
      }
    }
  }
}

TEST_CASE("A lone rough stone of quadrilaterals that are warped by less than snap is taken") {
  const Mesh stone = ball(1e-2, 3, true);
  for (const double snap : {5e-3, 2e-2}) CHECK(held(stone, snap) == doctest::Approx(geometry::volume(stone)).epsilon(0.02));
}

TEST_CASE("Cutting ends for a box of triangles with rounded corners and far from the origin") {
  Mesh rounded = placed(in_triangles(box({-0.2, -0.15, -0.1}, {0.2, 0.15, 0.1})), 0.3, {}, 1.0);
  for (Vec3& v : rounded.vertices) v = {1e-9 * std::round(1e9 * v.x), 1e-9 * std::round(1e9 * v.y), 1e-9 * std::round(1e9 * v.z)};
  CHECK(held(rounded, 0.0) == doctest::Approx(0.024).epsilon(1e-6));
  const Mesh far = placed(ball(1e-2, 1, false), 0.3, {500123.25, 4e5, 120.0}, 1.0);
  try {
    CHECK(!geometry::convex_pieces(far, 1e-3).empty());
  } catch (const std::exception& e) {
    CHECK(std::string(e.what()) != "");
  }
}

TEST_CASE("A lone rough stone 100 km out is taken with the same volume") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Mesh stone = ball(1e-2, seed, false);
    for (const double snap : {0.0, 1e-3, 5e-3}) {
      CAPTURE(seed);
      CAPTURE(snap);
      CHECK(held(placed(stone, 0.4, {1e5, -1e5, 1e3}, 1.0), snap) == doctest::Approx(geometry::volume(stone)).epsilon(0.02));
    }
  }
}

TEST_CASE("A rough stone so far out that its corners are rounded is taken with its volume or refused") {
  for (unsigned seed = 1; seed < 13; ++seed) {
    const Mesh stone = ball(5e-3, seed, false);
    const double volume = held(placed(stone, 0.0, {500123.25, 4649876.5, 120.0}, 1.0), 2e-3);
    CHECK((volume == -1.0 || volume == doctest::Approx(geometry::volume(stone)).epsilon(0.02)));
  }
}
