// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/parallel/ranges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "fixtures.h"

using namespace voussoir::geometry;
using namespace voussoir::geometry::test;

namespace {

bool same_frame(const Frame& a, const Frame& b) {
  return a.centre == b.centre && a.axis_s == b.axis_s && a.axis_t == b.axis_t && a.normal == b.normal;
}

void check_equal(const Assembly& a, const Assembly& b) {
  REQUIRE(a.elements.size() == b.elements.size());
  REQUIRE(a.faces.size() == b.faces.size());
  REQUIRE(a.joints.size() == b.joints.size());
  REQUIRE(a.patches.size() == b.patches.size());
  int different = 0;
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    const MassProperties &x = a.elements[i].mass, &y = b.elements[i].mass;
    different += a.elements[i].first_face != b.elements[i].first_face || x.centroid != y.centroid || x.volume != y.volume;
    different += x.inertia != y.inertia;
  }
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    const Face &x = a.faces[i], &y = b.faces[i];
    different += x.normal != y.normal || x.offset != y.offset || x.distance != y.distance || x.area != y.area;
  }
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    const Joint &x = a.joints[i], &y = b.joints[i];
    different += x.element_a != y.element_a || x.face_a != y.face_a || x.element_b != y.element_b || x.face_b != y.face_b;
    different += !same_frame(x.frame(), y.frame()) || x.area != y.area || x.merged != y.merged;
    different += !same(x.side_a, y.side_a) || !same(x.side_b, y.side_b);
  }
  for (std::size_t i = 0; i < a.patches.size(); ++i) {
    const FreePatch &x = a.patches[i], &y = b.patches[i];
    different += x.element != y.element || x.face != y.face || !same_frame(x.frame(), y.frame()) || !same(x.segments, y.segments);
  }
  CHECK(different == 0);
}

/// The message, and the block at fault.
std::string refusal(const std::vector<Polyhedron>& shapes, int threads) {
  try {
    assemble(parts_of(shapes, 0.05), 0.0, SegmentRule::centres, threads);
  } catch (const ModelError& e) {
    return std::to_string(e.subject()) + ": " + e.what();
  }
  return "accepted";
}

}  // namespace

TEST_SUITE("ranges") {
  TEST_CASE("every block is in one range, whatever the number of threads") {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kBlocksAtATime, kBlocksAtATime + 1, 7 * kBlocksAtATime - 3}) {
      for (const int threads : {1, 2, 5, 100}) {
        std::vector<std::atomic<int>> done(count);
        std::atomic<int> wrong = 0;
        for_ranges(count, threads, [&](std::size_t range, std::size_t first, std::size_t last) {
          wrong += first != range * kBlocksAtATime || first >= last || range >= range_count(count);
          for (std::size_t i = first; i < last; ++i) ++done[i];
        });
        for (const std::atomic<int>& d : done) wrong += d != 1;
        CHECK(wrong == 0);
      }
    }
  }

  TEST_CASE("of several exceptions that of the lowest range comes out") {
    std::atomic<bool> thrown = false;
    std::string what;
    try {
      for_ranges(20 * kBlocksAtATime, 4, [&](std::size_t range, std::size_t, std::size_t) {
        using namespace std::chrono_literals;
        if (range < 3) return;
        // The lowest throws last, unless there is no other thread.
        for (int i = 0; range == 3 && !thrown && i < 1000; ++i) std::this_thread::sleep_for(1ms);
        if (range == 3) std::this_thread::sleep_for(20ms);
        thrown = true;
        throw std::runtime_error(std::to_string(range));
      });
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    CHECK(what == "3");
  }

  TEST_CASE("an assembly is the same bit by bit for every number of threads") {
    const std::vector<Polyhedron> wall = running_wall(45, 30);  // three ranges; odd joints and patches at the ends of the courses
    REQUIRE(range_count(wall.size()) == 3);
    for (const SegmentRule rule : {SegmentRule::centres, SegmentRule::rim}) {
      const Assembly one = assemble(parts_of(wall, 0.07), 0.0, rule, 1);
      CHECK(std::ranges::is_sorted(one.joints, {}, [](const Joint& j) { return std::pair(j.element_a, j.face_a); }));
      CHECK(std::ranges::is_sorted(one.patches, {}, [](const FreePatch& p) { return std::pair(p.element, p.face); }));
      for (const int threads : {2, 3, 8}) check_equal(one, assemble(parts_of(wall, 0.07), 0.0, rule, threads));
    }
  }

  TEST_CASE("faults are told as on one thread: the first bad shape, the deepest overlap") {
    std::vector<Polyhedron> wall = running_wall(45, 30);
    const auto pushed = [&](std::size_t i, double by) { wall[i] = voussoir::geometry::moved(wall[i], {by, 0, 0}); };
    pushed(100, 0.01), pushed(700, 0.02), pushed(1300, 0.015);
    const std::string told = refusal(wall, 1);
    CHECK(told.find("overlaps block") != std::string::npos);
    CHECK(told.starts_with("700: "));  // the deepest
    CHECK(refusal(wall, 3) == told);
    wall[900].vertices.resize(3), wall[1200].vertices.resize(3);
    CHECK(refusal(wall, 1).starts_with("900: "));
    CHECK(refusal(wall, 3) == refusal(wall, 1));
  }
}
