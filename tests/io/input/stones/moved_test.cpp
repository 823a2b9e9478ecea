// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/solids/triangles.h"
#include "tests/io/input/stones/turned_mesh.h"
#include "tests/io/input/stones/written_files.h"

// The same stones at another place and angle have the same joints, beds and pieces.
using namespace stones;
using namespace voussoir;

namespace {

/// A wall of rough stones: faces that were meant to touch are off by up to `rough` [m]; some stones are angles, not convex.
std::vector<Named> rough_wall(std::mt19937& random, double rough, double gap, bool angles) {
  const auto any = [&] { return rough * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0); };
  std::vector<Named> all;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) {
      const double x = 0.4 * k + 0.2 * (row % 2), z = 0.25 * row;
      Mesh m = box({x + 0.5 * gap, 0, z + 0.5 * gap}, {x + 0.4 - 0.5 * gap, 0.3, z + 0.25 - 0.5 * gap});
      for (Vec3& v : m.vertices) v += Vec3{any(), any(), any()};
      all.push_back({"s" + std::to_string(row) + std::to_string(k), in_triangles(m)});
    }
  }
  if (angles) {
    Mesh m;
    for (const double y : {0.0, 0.3}) {
      for (const auto& [x, z] : {std::pair(0.3, 0.75), {1.3, 0.75}, {1.3, 0.95}, {0.6, 0.95}, {0.6, 1.25}, {0.3, 1.25}})
        m.vertices.push_back({x, y, z});
    }
    m.faces = {{0, 1, 2, 3, 4, 5}, {11, 10, 9, 8, 7, 6}};
    for (int i = 0; i < 6; ++i) m.faces.push_back({i, 6 + i, 6 + (i + 1) % 6, (i + 1) % 6});
    all.push_back({"angle", m});
  }
  return all;
}

struct Seen {
  std::size_t joints = 0, pieces = 0, beds = 0, merged = 0;
  double area = 0.0, volume = 0.0;
};

Seen seen(const std::vector<Named>& all, const std::string& keys) {
  const TempFolder folder;
  const std::string mortar =
      "[joint_laws.mortar]\ntension = 1e5\ncohesion = 1e5\nfriction = 30.0\ncompression = 1e7\nthickness = 0.02\nyoung = 3e8\npoisson = "
      "0.2\n";
  const auto c = load(folder.write("wall.obj", obj(all)), keys, mortar);
  const auto model = model_of(c);
  Seen s;
  for (const auto& stone : c.stones[0].stones) {
    s.pieces += stone.pieces.size();
    for (const auto& piece : stone.pieces) {
      s.beds += piece.beds.size();
      s.volume += geometry::volume({piece.shape.vertices, piece.shape.faces});
    }
  }
  s.joints = model.assembly.joints.size();
  for (const auto& joint : model.assembly.joints) s.area += joint.area;
  return s;
}

std::vector<Named> all_turned(const std::vector<Named>& all, std::mt19937& random, Vec3 by) {
  std::vector<Named> out = all;
  const std::mt19937 same = random;
  for (Named& n : out) {
    random = same;
    n.mesh = stones::turned(n.mesh, random, by);
  }
  return out;
}

void check_moved(const std::vector<Named>& all, const std::string& keys, std::mt19937& random, bool turn) {
  const Seen here = seen(all, keys);
  CHECK(here.joints >= 12);
  for (const Vec3 by : {Vec3{1.03, -0.77, 0.51}, Vec3{1000.37, -1234.77, 100.51}, Vec3{1e5 + 0.123, -2e5 - 0.457, 1e3 + 0.789}}) {
    CAPTURE(by.x);
    std::vector<Named> moved = all;
    if (turn)
      moved = all_turned(all, random, by);
    else
      for (Named& n : moved)
        for (Vec3& v : n.mesh.vertices) v += by;
    const Seen there = seen(moved, keys);
    CHECK(there.joints == here.joints);
    CHECK(there.pieces == here.pieces);
    CHECK(there.beds == here.beds);
    CHECK(there.area == doctest::Approx(here.area).epsilon(1e-6));
    CHECK(there.volume == doctest::Approx(here.volume).epsilon(1e-7));
  }
}

}  // namespace

TEST_CASE("Rough stones moved and turned have the same joints, beds and pieces") {
  std::mt19937 random(17);
  for (const double rough : {0.0, 1e-7, 1e-4, 3e-4}) {
    for (const bool turn : {false, true}) {
      for (int k = 0; k < 3; ++k) {
        CAPTURE(rough);
        CAPTURE(turn);
        CAPTURE(k);
        check_moved(rough_wall(random, rough, 0.0, false), "snap = 0.002\n", random, turn);
        check_moved(rough_wall(random, rough, 0.0, true), "snap = 0.002\n", random, turn);
        check_moved(rough_wall(random, rough, 0.01, false), "snap = 0.002\ngap = 0.01\njoint = \"mortar\"\n", random, turn);
      }
    }
  }
}
