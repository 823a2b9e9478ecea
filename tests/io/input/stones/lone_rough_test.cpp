// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "tests/io/input/stones/stones_fixture.h"
#include "tests/io/input/stones/turned_mesh.h"
#include "tests/io/input/stones/written_files.h"

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

/// What a stone holds that is alone in its file.
struct Held {
  double volume = 0.0;   // m3; negative if it is refused
  double allowed = 0.0;  // m3 that it may differ from the file's: 1e-9 of it, and what corners moved (by no more than snap allows) may hold
};

double number_behind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? 0.0 : std::strtod(text.c_str() + at + words.size(), nullptr);
}

Held held(const Mesh& m, double snap, const std::string& unit = "m") {
  const TempFolder folder;
  const std::string file = folder.write("stone.obj", obj({{"stone", m}}));
  try {
    const auto c = load(file, "snap = " + number(snap) + "\n", "", unit);
    const auto& stone = c.stones[0].stones[0];
    double sum = 0.0, area = 0.0;
    for (const auto& piece : stone.pieces) sum += geometry::volume({piece.shape.vertices, piece.shape.faces});
    for (std::size_t f = 0; f < m.faces.size(); ++f) area += geometry::loop_plane(m, f).area;
    const double scale = unit == "mm" ? 1e-3 : 1.0;
    const double moved = 1e-3 * number_behind(stone.change, "corners moved by up to "),
                 dents = number_behind(stone.change, "dents shallower than ");
    CHECK(moved <= 2.0 * snap);
    CHECK(dents == 0.0);
    return {sum, 1e-9 * sum + 1.1 * moved * area * scale * scale};
  } catch (const std::exception& e) {
    MESSAGE(std::string(e.what()));
    return {-1.0, 0.0};
  }
}

void check_held(const Mesh& m, double snap, double volume, const std::string& unit = "m") {
  const Held h = held(m, snap, unit);
  CAPTURE(h.volume);
  CAPTURE(volume);
  CHECK(std::abs(h.volume - volume) <= h.allowed);
}

}  // namespace

TEST_CASE("A lone rough stone is taken at any snap, with the volume of its file") {
  std::mt19937 random(11);
  for (const double rough : {1e-5, 1e-3, 1e-2, 3e-2}) {
    for (const unsigned seed : {1u, 2u}) {
      const Mesh stone = ball(rough, seed, false);
      for (const double snap : {0.0, 1e-4, 1e-3, 2e-3, 5e-3, 2e-2}) {
        CAPTURE(rough);
        CAPTURE(seed);
        CAPTURE(snap);
        const double volume = geometry::volume(stone);
        check_held(stone, snap, volume);
        check_held(permuted(placed(stone, 0.7, {}, 1e3)), snap, volume, "mm");
        for (const Vec3 by : {Vec3{}, Vec3{1000.3, -700.7, 31.1}, Vec3{100123.7, 4e5 + 0.3, 1.1}}) {
          const Mesh there = turned(stone, random, by);
          check_held(there, snap, geometry::volume(there));
        }
      }
    }
  }
}

TEST_CASE("A lone rough stone of quadrilaterals that are warped by less than snap is taken") {
  const Mesh stone = ball(1e-2, 3, true);
  for (const double snap : {5e-3, 2e-2}) check_held(stone, snap, geometry::volume(in_triangles(stone)));
}

TEST_CASE("A rough stone so far out that its corners are rounded is taken with its volume or refused") {
  for (unsigned seed = 1; seed < 13; ++seed) {
    const Mesh stone = placed(ball(5e-3, seed, false), 0.0, {500123.25, 4649876.5, 120.0}, 1.0);
    const Held h = held(stone, 2e-3);
    CHECK(std::abs(h.volume - geometry::volume(stone)) <= h.allowed + 1e-8 * h.volume);  // 9e-10 m between numbers there
  }
}
