// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/contact/impact.h"

#include <random>
#include <vector>

// Nothing passes through anything: bodies thrown at a fixed block, judged by the exact test of geometry at every step.
namespace voussoir::testing {
namespace {

enum class Side { above_along_y, above_along_x, beside };

/// One throw without gravity: a body that flies straight until it meets the block about the origin.
struct Throw {
  std::string what;
  Shape shape = Shape::brick;
  cases::Rotation turn, block_turn;
  Vec3 by, velocity;
};

geometry::Box3 extents(Shape s, const cases::Rotation& turn) {
  const auto profile = profile_of(s);
  return geometry::bounds(geometry::rotated(geometry::make_prism(profile, -0.1, 0.1), turn.axis, radians(turn.angle), {}));
}

/// The corner that lies highest (`up` 1) or lowest (−1).
Vec3 highest_corner(Shape s, const cases::Rotation& turn, double up) {
  const auto p = geometry::rotated(geometry::make_prism(profile_of(s), -0.1, 0.1), turn.axis, radians(turn.angle), {});
  return *std::ranges::max_element(p.vertices, {}, [&](Vec3 v) { return up * v.z; });
}

constexpr double kStart = 2e-3;  // m, between the two when a throw begins

/// Edges overlap by `overlap` as seen along the flight: the body grazes an edge of the block, rolled about this edge.
Throw grazing(Shape s, Side side, double overlap, double roll, double speed) {
  Throw t;
  t.what = std::string(name_of(s)) +
           (side == Side::beside          ? " from the side"
            : side == Side::above_along_x ? " on a short edge"
                                          : " on a long edge") +
           ", overlap " + std::to_string(1e3 * overlap) + " mm, rolled " + std::to_string(roll) + " degrees, " + std::to_string(speed) +
           " m/s";
  t.shape = s;
  t.turn = {side == Side::above_along_x ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, roll, {}};
  const geometry::Box3 box = extents(s, t.turn);
  switch (side) {
    case Side::above_along_y:
      t.by = {0.1 - overlap - box.low.x, 0.0, 0.05 + kStart - box.low.z}, t.velocity = {0, 0, -speed};
      break;
    case Side::above_along_x:
      t.by = {0.0, 0.1 - overlap - box.low.y, 0.05 + kStart - box.low.z}, t.velocity = {0, 0, -speed};
      break;
    case Side::beside:
      t.by = {0.1 + kStart - box.low.x, 0.0, 0.05 - overlap - box.low.z}, t.velocity = {-speed, 0, 0};
  }
  return t;
}

/// An edge down on an edge of the block that lies across it.
Throw crossed_edges(Shape s, double roll, Vec3 beside, double speed) {
  Throw t;
  t.what = std::string(name_of(s)) + " across an edge, rolled " + std::to_string(roll) + " degrees, off by " + std::to_string(beside.x) +
           ", " + std::to_string(beside.y) + ", " + std::to_string(speed) + " m/s";
  t.shape = s;
  t.turn = {{1, 0, 0}, roll, {}}, t.block_turn = {{0, 1, 0}, 45.0, {}};
  t.by = beside + Vec3{0, 0, extents(Shape::brick, t.block_turn).high.z + kStart - extents(s, t.turn).low.z};
  t.velocity = {0, 0, -speed};
  return t;
}

Throw corner_on_face(Shape s, Vec3 axis, double angle, Vec3 beside, double speed) {
  Throw t;
  t.what = std::string(name_of(s)) + " with a corner, turned " + std::to_string(angle) + " degrees, off by " + std::to_string(beside.x) +
           ", " + std::to_string(speed) + " m/s";
  t.shape = s;
  t.turn = {axis, angle, {}};
  t.by = beside + Vec3{0, 0, 0.05 + kStart - extents(s, t.turn).low.z};
  t.velocity = {0, 0, -speed};
  return t;
}

std::vector<Throw> all_throws() {
  std::vector<Throw> all;
  for (const Shape s : kShapes) {
    for (const double speed : {0.5, 4.0, 10.0}) {
      for (const double roll : {0.0, 5.0, -5.0, 10.0, -10.0, 30.0, -30.0, 60.0, -60.0}) {
        for (const Side side : {Side::above_along_y, Side::above_along_x, Side::beside}) {
          for (const double overlap : {1.5e-3, 4e-3, 6.5e-3, 9e-3, 11.5e-3, 14e-3, 30e-3})
            all.push_back(grazing(s, side, overlap, roll, speed));
        }
        for (const Vec3 beside : {Vec3{}, Vec3{0.03, 0.0, 0.0}, Vec3{0.0, 0.03, 0.0}})
          all.push_back(crossed_edges(s, 45.0 + 0.5 * roll, beside, speed));
      }
      for (const Vec3 axis : {Vec3{1, 1, 0}, Vec3{1, -1, 0}, Vec3{1, 0.4, 0.3}, Vec3{-0.3, 1, 0.7}}) {
        for (const double angle : {20.0, 35.0, 54.7, 70.0}) {
          for (const Vec3 beside : {Vec3{}, Vec3{0.08, 0.0, 0.0}}) all.push_back(corner_on_face(s, axis, angle, beside, speed));
        }
      }
    }
  }
  return all;
}

struct Outcome {
  double deepest = 0.0, limit = 0.0;  // m
  // Of the kinetic energy at first: what is left at the end, all that stores held above it at most, and what a contact may give back that
  // opens inside a step, k v2 dt2 / 8.
  double left = 0.0, gain = 0.0, may_gain = 0.0;
  double residual = 0.0;  // of the ledger
};

Outcome outcome_of(const Throw& t, bool reference) {
  cases::Case c = empty_case("collision");
  c.blocks.push_back(block_of(Shape::brick, "block", t.block_turn, {}, {}));
  c.blocks.back().free = false, c.blocks.back().fixed = true;
  c.blocks.push_back(block_of(t.shape, "body", t.turn, t.by, t.velocity));
  ExactRun run(std::move(c), reference);
  const double speed = norm(t.velocity), mass = run.elements().mass[1];
  const double stiffness = overlap_stiffness(mass / Adobe::density, 0.004);
  Outcome o;
  o.limit = kHalfSegment + 1.2 * speed * std::sqrt(mass / stiffness);
  const geometry::ConvexBody block = run.body(0);
  run.sim().step({false, true});
  const double start = mechanical(run.sim().energy());
  o.may_gain = 0.25 * stiffness * run.sim().dt() * run.sim().dt() / mass;
  for (const double end = 0.05 / speed + 0.005; run.sim().time() < end;) {
    run.sim().step({false, true});
    o.deepest = std::max(o.deepest, geometry::penetration_of(block, run.body(1), o.deepest).depth);
    o.gain = std::max(o.gain, mechanical(run.sim().energy()) / start - 1.0);
    o.residual = std::max(o.residual, run.sim().energy().residual);
  }
  o.left = run.sim().energy().kinetic / start;
  return o;
}

/// Every `stride`-th throw. \param row  writes rows of the manual
void sweep(int stride, int first, bool reference, const std::string& name) {
  const std::vector<Throw> all = all_throws();
  double depth = 0.0, left = 0.0, gain = -1.0, residual = 0.0;
  double brushed = 0.0;  // m
  int count = 0, too_deep = 0, brushing = 0;
  for (std::size_t i = static_cast<std::size_t>(first); i < all.size(); i += static_cast<std::size_t>(stride)) {
    const Outcome o = outcome_of(all[i], reference);
    ++count;
    depth = std::max(depth, o.deepest - o.limit), left = std::max(left, o.left);
    gain = std::max(gain, o.gain - o.may_gain), residual = std::max(residual, o.residual);
    too_deep += o.deepest > o.limit;
    if (o.left > 1.0 - 1e-9) ++brushing, brushed = std::max(brushed, o.deepest);
    INFO(i << ": " << all[i].what);
    CHECK(o.deepest <= o.limit);
    CHECK(o.left <= 1.0 + 1e-12);
    CHECK(o.gain <= o.may_gain);
    CHECK(o.residual <= 1e-3);
  }
  expect_below(name + ": throws that go deeper than half a segment and 1.2 times the elastic closure, of " + std::to_string(count),
               too_deep, 0);
  MESSAGE(brushing << " of " << count << " brush past without a force");
  expect_below(name + ": deepest overlap of bodies that brush past without a force [m]", brushed, kFree + 1e-12);
  expect_below(name + ": kinetic energy at the end, over that at the start", left, 1.0 + 1e-12);
  expect_below(name + ": energy above the start, over it, beyond what a contact gives back that opens inside a step", gain, 0.0);
  expect_below(name + ": residual of the ledger", residual, 1e-3);
}

}  // namespace

TEST_CASE("impact: the force of two edges that cross begins at zero and is stiffness times what is beyond the free depth") {
  // Half way between points of both, which lie 12.5 mm from the middle and then every 25 mm: no point of either sees the other.
  const double ridge = highest_corner(Shape::brick, {{0, 1, 0}, 45.0, {}}, 1.0).x,
               edge = highest_corner(Shape::brick, {{1, 0, 0}, 45.0, {}}, -1.0).y;
  const Throw t = crossed_edges(Shape::brick, 45.0, {ridge - 0.025, 0.025 - edge, 0.0}, 0.02);
  cases::Case c = empty_case("collision");
  c.contact.damping = 0.0, c.contact.friction = 0.0;
  c.blocks.push_back(block_of(Shape::brick, "block", t.block_turn, {}, {}));
  c.blocks.back().free = false, c.blocks.back().fixed = true;
  c.blocks.push_back(block_of(t.shape, "body", t.turn, t.by, t.velocity));
  ExactRun run(std::move(c), reference_kernels());
  const double stiffness = overlap_stiffness(0.004, 0.004);
  double before = 0.0, off = 0.0, most = 0.0, jump = 0.0, last = 0.0, fastest = 0.0;
  run.sim().step({false, true});
  const double start = mechanical(run.sim().energy());
  while (run.sim().time() < 0.75) {
    const double depth = geometry::penetration_of(run.body(0), run.body(1)).depth;
    run.sim().step({true, true});
    const double force = norm(run.sim().forces().base_shear);
    if (depth <= kFree) before = std::max(before, force);
    off = std::max(off, std::abs(force - stiffness * std::max(0.0, depth - kFree)));
    most = std::max(most, force), jump = std::max(jump, std::abs(force - last)), last = force;
    fastest = std::max(fastest, mechanical(run.sim().energy()) / start);
  }
  CHECK(before == 0.0);
  CHECK(last == 0.0);  // they have parted again
  CHECK(most > 50.0);
  expect_below("impact, edge across edge: force off stiffness times depth beyond the free one, over the largest", off / most, 1e-6);
  expect_below("impact, edge across edge: largest change of the force in a step, over that of the spring at full speed",
               jump / (stiffness * 0.02 * run.sim().dt()), 1.05);
  expect_below("impact, edge across edge, no damping: energy over that at the start", fastest, 1.005);
}

namespace {

/// Bodies of mixed shapes, turned anyhow, fall in a heap on the base and on a fixed block, from rest and one above the other.
struct Heap {
  double deepest = 0.0, limit = 0.0;     // m, at any time
  double at_rest = 0.0, residual = 0.0;  // m, at the end
  double speed = 0.0;                    // m/s, the fastest at the end
};
Heap fall_of(std::uint64_t seed, bool reference) {
  std::mt19937_64 engine(seed);
  const auto random = [&](double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; };
  cases::Case c = empty_case("drop");
  c.time.step = 1e-4;
  c.blocks.push_back(block_of(Shape::brick, "block", {}, {0.0, 0.0, 0.05}, {}));
  c.blocks.back().free = false, c.blocks.back().fixed = true;
  const int count = 3 + static_cast<int>(seed % 3);
  double top = 0.1;
  for (int i = 0; i < count; ++i) {
    const Shape shape = kShapes[static_cast<std::size_t>(random(0.0, 3.0))];
    const cases::Rotation turn{{random(-1, 1), random(-1, 1), random(0.1, 1)}, random(0.0, 180.0), {}};
    const geometry::Box3 box = extents(shape, turn);
    const Vec3 by{random(-0.12, 0.12), random(-0.12, 0.12), top + 0.01 - box.low.z};
    top = by.z + box.high.z;
    c.blocks.push_back(block_of(shape, "body " + std::to_string(i), turn, by, {0.0, 0.0, random(-2.0, 0.0)}));
  }
  ExactRun run(std::move(c), reference);
  double mass = 0.0;
  for (std::size_t i = 1; i < run.count(); ++i) mass += run.elements().mass[i];
  // All bodies at the speed of the one that falls from the top, on the softest spring.
  const double fastest = std::sqrt(4.0 + 2.0 * kGravity * top);
  Heap h;
  h.limit = kHalfSegment + 1.2 * fastest * std::sqrt(mass / overlap_stiffness(0.002, 0.002));
  for (int i = 0; run.sim().time() < 4.0; ++i) {
    run.sim().step({false, i % 10 == 0});
    if (i % 10 != 0) continue;
    h.deepest = run.deepest(h.deepest);
    h.residual = std::max(h.residual, run.sim().energy().residual);
  }
  h.at_rest = run.deepest(0.0);
  for (std::size_t i = 0; i < run.count(); ++i) {
    h.speed = std::max(h.speed, norm(Vec3{run.elements().vx[i], run.elements().vy[i], run.elements().vz[i]}));
  }
  return h;
}

void drop_heaps(int first, int count, bool reference, const std::string& name) {
  double over = -1.0, at_rest = 0.0, deepest = 0.0, residual = 0.0;
  int resting = 0;
  for (int i = first; i < first + count; ++i) {
    const Heap h = fall_of(static_cast<std::uint64_t>(i), reference);
    CAPTURE(i);
    CHECK(h.deepest <= h.limit);
    CHECK(h.residual <= 1e-2);
    over = std::max(over, h.deepest - h.limit), deepest = std::max(deepest, h.deepest), residual = std::max(residual, h.residual);
    if (h.speed > 0.01) continue;
    ++resting;
    CHECK(h.at_rest <= kFree + 1e-3);
    at_rest = std::max(at_rest, h.at_rest);
  }
  MESSAGE(count << " heaps, " << resting << " at rest; deepest " << deepest << " m");
  expect_below(name + ", " + std::to_string(count) + ": deepest beyond half a segment and the closure of all bodies' energy [m]", over,
               0.0);
  expect_below(name + ": deepest of those at rest [m], the free depth and 1 mm", at_rest, kFree + 1e-3);
  expect_below(name + ": residual of the ledger", residual, 1e-2);
}

}  // namespace

TEST_CASE("impact: nothing in a heap passes through anything") {
  for (const bool reference : {false, true}) drop_heaps(reference ? 4 : 0, 4, reference, reference ? "heaps, plain kernels" : "heaps");
}

TEST_CASE("impact: nothing in a heap passes through anything, 200 heaps" * doctest::skip()) {
  drop_heaps(0, 200, reference_kernels(), "heaps");
}

TEST_CASE("impact: nothing that is thrown at a block passes through it") {
  for (const bool reference : {false, true}) sweep(11, reference ? 5 : 0, reference, reference ? "impact, plain kernels" : "impact");
}

TEST_CASE("impact: nothing that is thrown at a block passes through it, all throws" * doctest::skip()) {
  sweep(1, 0, reference_kernels(), "impact, all throws");
}

}  // namespace voussoir::testing
