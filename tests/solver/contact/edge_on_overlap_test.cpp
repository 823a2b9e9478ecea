// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

// Blocks that rest on an edge, and heaps: contacts of whole bodies whose point goes from corner to corner.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Two courses of nine bricks, and a block on edge upon their middle, as heavy as is asked, at the step that the program chooses.
cases::Case on_edge(double length, double density, geometry::SegmentRule rule) {
  cases::Case c = small_wall(1, 1);
  c.blocks.clear();
  c.joints.default_law = "dry";
  c.damping.alpha = 0.0;
  c.segment_rule = rule;
  c.materials["heavy"] = {density, 9.8e7, 0.25};
  for (int course = 0; course < 2; ++course) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        cases::BlockSpec b = brick(course, 3 * i + j + 4, 0.0, 0.0);
        b.box = {{Vec3{0.2 * i - 0.1, 0.1 * j - 0.05, 0.1 * course}, Vec3{0.2 * i + 0.1, 0.1 * j + 0.05, 0.1 * (course + 1)}}};
        c.blocks.push_back(b);
      }
    }
  }
  cases::BlockSpec block;
  block.name = "block", block.material = "heavy", block.free = true;
  const double middle = 0.2 + 0.5 * std::sqrt(2.0);
  block.box = {{Vec3{-0.5 * length, -0.5, middle - 0.5}, Vec3{0.5 * length, 0.5, middle + 0.5}}};
  block.rotate = cases::Rotation{.axis = {1.0, 0.0, 0.0}, .angle = 45.0, .about = Vec3{0.0, 0.0, middle}};
  c.blocks.push_back(block);
  return c;
}

/// Twelve cubes turned anyhow between four walls, and a block that falls on them, at the step that the program chooses.
cases::Case heap(unsigned seed) {
  cases::Case c = small_wall(1, 1);
  c.blocks.clear();
  c.joints.default_law = "dry";
  c.damping.alpha = 0.0;
  c.segment_rule = geometry::SegmentRule::rim;
  const auto add = [&](const std::string& name, Vec3 low, Vec3 high) -> cases::BlockSpec& {
    cases::BlockSpec& b = c.blocks.emplace_back();
    b.name = name, b.material = "adobe";
    b.box = {{low, high}};
    return b;
  };
  add("left", {-0.4, -0.4, 0.0}, {-0.2, 0.4, 2.0}).fixed = true;
  add("right", {0.2, -0.4, 0.0}, {0.4, 0.4, 2.0}).fixed = true;
  add("front", {-0.2, -0.4, 0.0}, {0.2, -0.2, 2.0}).fixed = true;
  add("rear", {-0.2, 0.2, 0.0}, {0.2, 0.4, 2.0}).fixed = true;
  const auto number = [&] { return static_cast<double>((seed = seed * 1664525U + 1013904223U) >> 8U) / 0x1p24; };  // 0 to 1
  for (int i = 0; i < 12; ++i) {
    const Vec3 at{0.19 * (i % 2 - 0.5), 0.19 * (i / 2 % 2 - 0.5), 0.1 + 0.19 * (i / 4)}, half{0.05, 0.05, 0.05};
    cases::BlockSpec& cube = add("cube " + std::to_string(i), at - half, at + half);
    cube.free = true;
    cube.rotate = cases::Rotation{.axis = {number() - 0.5, number() - 0.5, number() - 0.5}, .angle = 180.0 * number(), .about = at};
  }
  cases::BlockSpec& top = add("top", {-0.14, -0.14, 0.77}, {0.14, 0.14, 1.17});
  top.free = true;
  top.rotate = cases::Rotation{.axis = {1.0, 0.3, 0.0}, .angle = 10.0, .about = {0.0, 0.0, 0.97}};
  return c;
}

/// A brick that falls on a fixed one, its lower edge nearly along the top: tilted by a thousandth or two, it rocks from corner to corner.
cases::Case falls_on_edge(double speed, double turn) {
  cases::Case c = small_wall(1, 1);
  c.joints.default_law = "dry";
  c.damping.alpha = 0.0;
  c.segment_rule = geometry::SegmentRule::rim;
  c.blocks.front().fixed = true;
  c.blocks.front().box = {{Vec3{-0.1, -0.05, 0.0}, Vec3{0.1, 0.05, 0.1}}};
  const Vec3 at{0.0, 0.0, 0.11 + 0.05 * std::sqrt(2.0)};
  cases::BlockSpec& b = c.blocks.emplace_back();
  b.name = "brick", b.material = "adobe", b.free = true;
  b.box = {{at - Vec3{0.1, 0.05, 0.05}, at + Vec3{0.1, 0.05, 0.05}}};
  b.rotate = cases::Rotation{.axis = {1.0, 0.002, turn}, .angle = 45.0, .about = at};
  b.velocity = {0.0, 0.0, -speed};
  return c;
}

/// The worst residual of the ledger while the block comes to rest and falls over.
double residual_of(const cases::Case& c, double until) {
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  while (sim.time() < until) sim.step({false, sim.steps() % 5 == 0});
  return sim.worst_residual();
}

}  // namespace

TEST_CASE("a block that rests on its edge gives out no energy, at the step that the program chooses") {
  using enum geometry::SegmentRule;
  CHECK(residual_of(on_edge(0.15, 1800.0, rim), 0.3) < 1e-4);  // shorter than the brick under it
  CHECK(residual_of(on_edge(0.15, 20000.0, rim), 0.3) < 1e-3);
  CHECK(residual_of(on_edge(1.0, 1800.0, rim), 0.3) < 1e-4);  // across three bricks
  CHECK(residual_of(on_edge(1.0, 20000.0, centres), 0.3) < 1e-3);
}

TEST_CASE("a brick that falls on an edge and rocks from corner to corner gives out no energy, at the step that the program chooses") {
  for (const double speed : {1.5, 1.75}) {
    for (const double turn : {0.0, 0.002, 0.01}) {
      CAPTURE(speed);
      CAPTURE(turn);
      CHECK(residual_of(falls_on_edge(speed, turn), 0.15) < 1e-4);
    }
  }
}

TEST_CASE("a heap of cubes under a block that falls on it stays in balance, at the step that the program chooses") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    CHECK(residual_of(heap(seed), 0.5) < 1e-3);
  }
}
