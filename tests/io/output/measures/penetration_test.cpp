// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/penetration.h"

#include <cmath>

#include "io/input/files/hdf5_file.h"
#include "io/output/measures/measures.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;

/// Two cubes of 0.1 m, the first a brick; segments of 25 mm.
cases::Model two_bricks() {
  cases::Model m = two_cubes();
  for (cases::Block& b : m.blocks) b.segment_size = 0.025, b.fixed = false;
  return m;
}

constexpr const char* kOnBase = "title = \"two cubes\"\n[base]\nz = 0.0\n";

/// A run of two cubes: where their centroids are in each frame; the second is turned about the vertical.
struct Frames {
  TempFolder folder;
  ResultsWriter results;
  int count = 0;
  explicit Frames(const char* text, const cases::Model& model = two_bricks())
      : results(folder.path(), model, text, kNames, {}, by_hand()) {}
  void add(Vec3 a, Vec3 b, double degrees = 0.0) {
    const double half = 0.5 * degrees * std::acos(-1.0) / 180.0;
    const std::array<float, 8> turned{1, 0, 0, 0, static_cast<float>(std::cos(half)), 0, 0, static_cast<float>(std::sin(half))};
    std::array<float, 6> moved{};
    std::size_t i = 0;
    for (const Vec3 u : {a - Vec3{0.05, 0.05, 0.05}, b - Vec3{0.15, 0.05, 0.05}})
      for (const double x : {u.x, u.y, u.z}) moved[i++] = static_cast<float>(x);
    const std::array<float, 2> whole{};
    results.frame({0.1 * count++, moved, turned, whole});
  }
  Measures measures() {
    results.finish();
    return measure(Hdf5File::open(folder.file("run.h5")));
  }
};

constexpr double kFloat = 1e-7;  // m, of coordinates below 1 m as float32

}  // namespace

TEST_CASE("interpenetration: the deepest pair and how many are deep, at the end and at the worst") {
  Frames f(kOnBase);
  f.add({0.05, 0.05, 0.05}, {0.15, 0.05, 0.05});               // side by side on the base
  f.add({0.05, 0.05, 0.05}, {0.13, 0.06, 0.05});               // 20 mm in each other: deep
  f.add({0.05, 0.05, 0.05}, {0.05, 0.05, 0.12});               // 30 mm: deep, and deepest
  f.add({0.05, 0.05, 0.046}, {0.05 + 0.1, 0.05, 0.05}, 45.0);  // 4 mm in the base; the other's edge 0.0707 m from its centroid: 20.7 mm
  f.add({0.05, 0.05, 0.05}, {0.145, 0.05, 0.05});              // 5 mm: not deep
  const Measures m = f.measures();
  const auto& depth = m.series.penetration;
  REQUIRE(depth.size() == 5);
  CHECK(std::abs(depth[0]) < kFloat);
  CHECK(std::abs(depth[1] - 0.02) < kFloat);
  CHECK(std::abs(depth[2] - 0.03) < kFloat);
  CHECK(std::abs(depth[3] - (0.05 * std::sqrt(2.0) - 0.05)) < kFloat);
  CHECK(m.series.deep_pairs == std::vector<std::int64_t>{0, 1, 1, 1, 0});
  CHECK(std::abs(m.penetration - 0.005) < kFloat);
  CHECK(m.peak_penetration == depth[2]);
  CHECK(m.peak_penetration_time == 0.2);
  CHECK(m.peak_penetration_pair == "element 0 (front wall) and element 1 (slider)");
  CHECK(m.deep_pairs == 0);
  CHECK(m.most_deep_pairs == 1);
  CHECK(m.most_deep_pairs_time == 0.1);
  CHECK(std::abs(m.base_penetration) < kFloat);
  CHECK(std::abs(m.peak_base_penetration - 0.004) < kFloat);
}

TEST_CASE("interpenetration: the base is a body, where there is one") {
  for (const bool base : {true, false}) {
    Frames f(base ? kOnBase : kCase.c_str());
    f.add({0.05, 0.05, 0.03}, {0.25, 0.05, 0.2});
    const Measures m = f.measures();
    CHECK(std::abs(m.penetration - (base ? 0.02 : 0.0)) < kFloat);
    CHECK(m.peak_base_penetration == m.penetration);
    CHECK(m.deep_pairs == (base ? 1 : 0));
    CHECK(m.peak_penetration_pair == (base ? "element 0 (front wall) and the base" : ""));
    CHECK((m.peak_penetration_time < 0) == !base);
    CHECK(m.touching_pairs == (base ? 1 : 0));
  }
}

TEST_CASE("interpenetration: supports are in each other and in the base without a word, a free body in a support is not") {
  for (const int free : {0, 1, 2}) {  // bodies that are free
    cases::Model model = two_bricks();
    for (int b = 0; b < 2; ++b) model.blocks[static_cast<std::size_t>(b)].fixed = b >= free;
    Frames f(kOnBase, model);
    f.add({0.05, 0.05, 0.05}, {0.15, 0.05, 0.05});
    f.add({0.05, 0.05, 0.05}, {0.12, 0.05, 0.01});  // 30 mm in the other, 40 mm in the base
    const Measures m = f.measures();
    const double expected = free == 0 ? 0.0 : free == 1 ? 0.03 : 0.04;
    CHECK(std::abs(m.penetration - expected) < kFloat);
    CHECK(std::abs(m.base_penetration - (free == 2 ? 0.04 : 0.0)) < kFloat);
    CHECK(m.deep_pairs == (free == 0 ? 0 : free == 1 ? 1 : 2));
    CHECK(m.touching_pairs == (free == 0 ? 0 : free == 1 ? 2 : 3));
  }
}

TEST_CASE("interpenetration: the depths are the same wherever the model stands, and whatever height its base has there") {
  cases::Model far = two_bricks();
  far.origin = {650001, 4820000, 312};
  Frames here(kOnBase), there("title = \"two cubes\"\n[base]\nz = 312.0\n", far);
  for (Frames* f : {&here, &there}) f->add({0.05, 0.05, 0.046}, {0.05 + 0.1, 0.05, 0.05}, 45.0);
  const Measures a = here.measures(), b = there.measures();
  CHECK(a.penetration > 0.004);
  CHECK(b.penetration == a.penetration);
  CHECK(b.base_penetration == a.base_penetration);
  CHECK(b.peak_penetration_pair == a.peak_penetration_pair);
}

TEST_CASE("interpenetration: pairs touch up to a gap of 0.1 mm, between their nearest points") {
  const auto touching = [](Vec3 b) {
    Frames f(kCase.c_str());
    f.add({0.05, 0.05, 0.05}, b);
    return f.measures().touching_pairs;
  };
  CHECK(touching({0.14, 0.05, 0.05}) == 1);
  CHECK(touching({0.15009, 0.05, 0.05}) == 1);
  CHECK(touching({0.15011, 0.05, 0.05}) == 0);
  CHECK(touching({0.15009, 0.15009, 0.05}) == 0);  // 0.127 mm between two edges, though no axis of faces shows more than 0.09 mm
  CHECK(touching({0.15007, 0.15007, 0.05}) == 1);
}

TEST_CASE("interpenetration: of elements with segments of two sizes the larger counts") {
  for (const double size : {0.025, 0.05}) {
    cases::Model model = two_bricks();
    model.blocks[1].segment_size = size;
    Frames f(kCase.c_str(), model);
    f.add({0.05, 0.05, 0.05}, {0.13, 0.05, 0.05});  // 20 mm
    CHECK(f.measures().deep_pairs == (size == 0.025 ? 1 : 0));
  }
}

}  // namespace voussoir::io
