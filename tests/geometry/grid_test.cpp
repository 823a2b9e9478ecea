// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <thread>

#include "fixtures.h"

using namespace voussoir;
using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

bool meet(const Box3& a, const Box3& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z &&
         b.low.z <= a.high.z;
}

std::vector<std::int32_t> brute_force(const std::vector<Box3>& boxes, const Box3& query) {
  std::vector<std::int32_t> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (meet(boxes[i], query)) out.push_back(static_cast<std::int32_t>(i));
  }
  return out;
}

std::vector<std::int32_t> found(const UniformGrid& grid, const Box3& query) {
  std::vector<std::int32_t> out;
  grid.query(query, out);
  return out;
}

/// `space` is the edge of the cube that holds the lower corners, edges up to `most`.
std::vector<Box3> random_boxes(Random& random, int count, double space, double most) {
  std::vector<Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 low{random.uniform(-space, space), random.uniform(-space, space), random.uniform(-space, space)};
    boxes.push_back({low, low + Vec3{random.uniform(0, most), random.uniform(0, most), random.uniform(0, most)}});
  }
  return boxes;
}

}  // namespace

TEST_SUITE("grid") {
  TEST_CASE("a query finds what trying every box finds, in order") {
    Random random(11);
    UniformGrid grid;
    for (const double most : {0.02, 0.3, 1.5}) {
      const std::vector<Box3> boxes = random_boxes(random, 700, 2.0, most);
      grid.build(boxes);
      for (const Box3& q : boxes) CHECK(found(grid, q) == brute_force(boxes, q));
      for (const Box3& q : random_boxes(random, 200, 3.0, 2.0 * most)) CHECK(found(grid, q) == brute_force(boxes, q));
    }
  }

  TEST_CASE("boxes that move are found where they are") {
    Random random(13);
    std::vector<Box3> boxes = random_boxes(random, 400, 1.0, 0.2);
    UniformGrid grid;
    grid.build(boxes);
    const auto moved = [&](const Box3& b, double far) {
      const Vec3 by{random.uniform(-far, far), random.uniform(-far, far), random.uniform(-far, far)};
      return Box3{b.low + by, b.high + by};
    };
    for (int round = 0; round < 40; ++round) {
      for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = moved(boxes[i], i % 2 == 0 ? 0.01 : 0.3);
      boxes[7] = moved(boxes[7], 500.0);                        // thrown
      for (Vec3* v : {&boxes[8].low, &boxes[8].high}) *v = {};  // all to one place, where there is no room for them
      boxes[static_cast<std::size_t>(10 + round)] = boxes[9];
      if (round % 4 == 1) boxes[11] = {{-50, -50, -1}, {50, 50, 0}};  // a slab, in no cell
      if (round % 4 == 2) boxes[11].low.x = NAN;                      // nowhere
      if (round % 4 == 3) boxes[11] = boxes[12];
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i % 3 == 0 || i < 60) grid.move(static_cast<std::int32_t>(i), boxes[i]);
      }
      for (const Box3& q : random_boxes(random, 100, 1.2, 0.4)) REQUIRE(found(grid, q) == brute_force(boxes, q));
      for (const Box3& q : boxes) REQUIRE(found(grid, q) == brute_force(boxes, q));
    }
  }

  TEST_CASE("boxes of very different size") {
    Random random(12);
    std::vector<Box3> boxes = random_boxes(random, 600, 2.0, 0.2);
    boxes.push_back({{-50, -50, -1}, {50, 50, 0}});       // a slab, hundreds of cells a side
    boxes.push_back({{-3, 0.5, 0.5}, {3, 0.7, 0.7}});     // a beam
    boxes.push_back({{1000, 0, 0}, {1000.2, 0.1, 0.1}});  // thrown far
    boxes.push_back({{0, 0, 0}, {0, 0, 0}});              // a point
    UniformGrid grid;
    grid.build(boxes);
    for (const Box3& q : boxes) CHECK(found(grid, q) == brute_force(boxes, q));
    CHECK(found(grid, {{999, -1, -1}, {1001, 1, 1}}) == std::vector<std::int32_t>{602});
  }

  TEST_CASE("the intersection is closed: a shared face, edge or corner counts") {
    const std::vector<Box3> boxes{{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}, {{1.0000001, 0, 0}, {2, 1, 1}}};
    UniformGrid grid;
    grid.build(boxes);
    CHECK(found(grid, boxes[0]) == std::vector<std::int32_t>{0, 1, 2});
  }

  TEST_CASE("coordinates beyond the cells' numbers, infinities and not-a-number") {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    const std::vector<Box3> boxes{{{1e300, 0, 0}, {2e300, 1, 1}}, {{-1e15, 0, 0}, {-1e15 + 1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}},
                                  {{NAN, 0, 0}, {1, 1, 1}},       {{-kInf, 0, 0}, {kInf, 1, 1}},      {{3, 3, 3}, {4, 4, 4}}};
    UniformGrid grid;
    grid.build(boxes);
    for (const Box3& q : boxes) CHECK(found(grid, q) == brute_force(boxes, q));
    CHECK(found(grid, {{0.1, 0.1, 0.1}, {0.2, 0.2, NAN}}).empty());
  }

  TEST_CASE("nothing in, nothing out; re-filling forgets; results are appended") {
    UniformGrid grid;
    const Box3 all{{-9, -9, -9}, {9, 9, 9}};
    CHECK(found(grid, all).empty());
    grid.build(std::vector<Box3>{{{0, 0, 0}, {1, 1, 1}}, {{2, 2, 2}, {3, 3, 3}}});
    std::vector<std::int32_t> out{42};
    grid.query(all, out);
    CHECK(out == std::vector<std::int32_t>{42, 0, 1});
    grid.build(std::vector<Box3>{});
    CHECK(found(grid, all).empty());
  }

  TEST_CASE("threads may query at once") {
    Random random(13);
    const std::vector<Box3> boxes = random_boxes(random, 1500, 2.0, 0.3);
    UniformGrid grid;
    grid.build(boxes);
    std::vector<std::vector<std::int32_t>> a(boxes.size()), b(boxes.size());
    const auto all = [&](auto& out) {
      for (std::size_t i = 0; i < boxes.size(); ++i) grid.query(boxes[i], out[i]);
    };
    std::thread other([&] { all(b); });
    all(a);
    other.join();
    CHECK(a == b);
    CHECK(a[77] == brute_force(boxes, boxes[77]));
  }
}
