// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/overlaps.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/mass.h"
#include "geometry/separation.h"
#include "tests/io/input/stones/stones_fixture.h"

using namespace stones;
using namespace voussoir;
using geometry::DrawnPiece;
using geometry::Polyhedron;

namespace {

const std::string kBase = "[base]\nz = 0.0\n";

bool says(const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; }

/// A cube of side 1 about the origin of its bottom, standing on its edge along y, its lowest line at `z`.
Mesh on_edge(double z) {
  const Polyhedron p = geometry::rotated(geometry::make_box({-0.5, 0, -0.5}, {0.5, 1, 0.5}), {0, 1, 0}, 0.25 * M_PI, {});
  return {geometry::moved(p, {0, 0, z + std::sqrt(0.5)}).vertices, p.faces};
}

double volume_of(const cases::Model& m, std::size_t i) { return m.assembly.elements[i].mass.volume; }

bool is_within(const Polyhedron& part, const Polyhedron& whole) {
  for (const auto& f : geometry::convex_body(whole).faces) {
    for (const Vec3& v : part.vertices) {
      if (dot(f.normal, v) - f.offset > 1e-9) return false;
    }
  }
  return true;
}

/// Boxes and skew bricks of all sizes, each pushed by less than `snap` into the one before it along a direction of its own.
std::vector<DrawnPiece> pushed_row(std::mt19937& draw, double snap) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), size(0.2, 1.0), depth(0.05, 0.95);
  std::vector<DrawnPiece> row;
  for (std::int32_t i = 0; i < 6; ++i) {
    Polyhedron p = geometry::make_box({0, 0, 0}, {size(draw), size(draw), size(draw)});
    p = geometry::rotated(p, {unit(draw), unit(draw), unit(draw)}, 3.0 * unit(draw), {});
    if (i > 0) {
      const Vec3 way = normalised(Vec3{unit(draw), unit(draw), unit(draw)});
      const auto last = geometry::convex_body(row.back().shape);
      double low = 0.0, high = 4.0;  // m along `way`: overlapping, apart
      p = geometry::moved(p, geometry::mass_properties(row.back().shape).centroid - geometry::mass_properties(p).centroid);
      while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        const double in = geometry::penetration_of(last, geometry::convex_body(geometry::moved(p, middle * way))).depth;
        (in > 0.0 ? low : high) = middle;
      }
      p = geometry::moved(p, high * way);
      const auto apart = geometry::penetration_of(last, geometry::convex_body(p));
      p = geometry::moved(p, (-depth(draw) * snap) * apart.axis);
    }
    row.push_back({p, i, snap});
  }
  return row;
}

}  // namespace

TEST_CASE("an edge that lies a little in the stone below is cut off along that stone's face") {
  const TempFolder folder;
  const std::string file = folder.write("a.obj", obj({{"low", box({-1, 0, 0}, {1, 1, 1})}, {"high", on_edge(0.9995)}}));
  const auto c = load(file, "", kBase);
  const cases::Model m = model_of(c);
  CHECK(m.assembly.joints.size() == 2);  // the base, and a strip of 1 mm
  for (const auto& joint : m.assembly.joints) {
    if (joint.element_b >= 0) CHECK(joint.area == doctest::Approx(1e-3).epsilon(1e-6));
  }
  CHECK(volume_of(m, 0) == doctest::Approx(2.0).epsilon(1e-12));
  CHECK(volume_of(m, 1) == doctest::Approx(1.0 - 0.5e-3 * 0.5e-3).epsilon(1e-9));
  CHECK(c.stones[0].stones[0].change.empty());
  CHECK(says(c.stones[0].stones[1].change, "cut by 0.5 mm where it lay in another stone"));
  SUBCASE("deeper than snap it is refused, with the place") {
    const std::string message = refusal(file, "snap = 0.0002", kBase);
    CHECK(says(message, "stone \"high\" (element 1)"));
    CHECK(says(message, "by 0.0005 m"));
    CHECK(says(message, "about (0, 0.5, 0.99"));
  }
  SUBCASE("with no snap nothing is cut") { CHECK(says(refusal(file, "snap = 0.0", kBase), "overlaps")); }
}

TEST_CASE("two edges that cross a little are both cut halfway") {
  const TempFolder folder;
  Mesh across = on_edge(0.0);  // its lowest line along x
  for (Vec3& v : across.vertices) v = {0.5 - v.y, v.x + 0.5, v.z};
  Mesh below = on_edge(0.0);
  double top = 0.0;
  for (const Vec3& v : below.vertices) top = std::max(top, v.z);
  for (Vec3& v : across.vertices) v.z += top - 4e-4;
  const auto c = load(folder.write("a.obj", obj({{"low", below}, {"high", across}})), "supports = [\"low\", \"high\"]");
  const cases::Model m = model_of(c);
  CHECK(m.assembly.joints.size() == 1);
  const double strip = 2.0 * 2e-4;  // m, of a right angle cut 0.2 mm deep
  CHECK(m.assembly.joints[0].area == doctest::Approx(strip * strip).epsilon(1e-6));
  for (const std::size_t i : {0U, 1U}) CHECK(volume_of(m, i) == doctest::Approx(1.0 - 2e-4 * 2e-4).epsilon(1e-9));
}

TEST_CASE("a cut spares the faces that other stones lie against") {
  // "mid" stands on "low" and lies under "top"; the slanted "side" reaches 0.3 mm into it, over the edge of its upper face.
  const TempFolder folder;
  Mesh side = box({0, 0, 0}, {1, 1, 1});
  for (Vec3& v : side.vertices) v = {v.x + 0.9997, v.y, v.z + (v.x > 0.5 ? 0.7 : 0.2)};
  const auto c = load(folder.write("a.obj", obj({{"low", box({0, 0, -1}, {1, 1, 0})},
                                                 {"mid", box({0, 0, 0}, {1, 1, 1})},
                                                 {"top", box({0, 0, 1}, {0.9, 1, 2})},
                                                 {"side", side}})),
                      "supports = [\"low\", \"side\"]");
  const cases::Model m = model_of(c);
  CHECK(m.assembly.joints.size() == 3);  // two beds, and the face of "side"
}

TEST_CASE("a tip under the base is cut off") {
  const TempFolder folder;
  const std::string file = folder.write("a.obj", obj({{"tip", on_edge(-3e-4)}}));
  const cases::Model m = model_of(load(file, "", kBase));
  REQUIRE(m.assembly.joints.size() == 1);
  CHECK(m.assembly.joints[0].area == doctest::Approx(6e-4).epsilon(1e-6));
  CHECK(says(refusal(file, "snap = 1e-4", kBase), "below the base"));
}

TEST_CASE("of several overlaps the deepest is named, and the others are counted") {
  const TempFolder folder;
  const std::string message = refusal(folder.write("a.obj", obj({{"a", box({0, 0, 0}, {1, 1, 1})},
                                                                 {"b", box({0.2, 0.2, 0.995}, {0.8, 0.8, 2})},
                                                                 {"c", box({0.98, 0.1, 0.1}, {2, 0.9, 0.8})}})),
                                      "", kBase);
  CHECK(says(message, "stone \"a\" (element 0): overlaps stone \"c\" (element 2) by 0.02 m"));
  CHECK(says(message, "about (0.99, 0.5, 0.45) m (1 more pair overlaps less)"));
}

TEST_CASE("random rows of stones pushed into each other: none overlap after, and nothing grows") {
  std::mt19937 draw(11);
  const double snap = 1e-3;
  int cut = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<DrawnPiece> row = pushed_row(draw, snap);
    const std::vector<DrawnPiece> before = row;
    const auto depth = geometry::part_overlaps(row, std::nullopt);
    for (std::size_t i = 0; i < row.size(); ++i) {
      CAPTURE(round);
      CAPTURE(i);
      CHECK(depth[i] <= snap);
      CHECK(is_within(row[i].shape, before[i].shape));
      cut += depth[i] > 0.0 ? 1 : 0;
      if (depth[i] == 0.0) CHECK(row[i].shape.vertices == before[i].shape.vertices);
      CHECK_NOTHROW(geometry::validate(row[i].shape));
      if (i == 0) continue;
      const auto in = [&](const std::vector<DrawnPiece>& r) {
        return geometry::penetration_of(geometry::convex_body(r[i - 1].shape), geometry::convex_body(r[i].shape)).depth;
      };
      CHECK(in(before) > 4e-5);
      CHECK(in(row) < 1e-6);
    }
  }
  CHECK(cut >= 1000);  // one of each of five pairs at least
}
