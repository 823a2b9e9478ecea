// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/nth.h"
#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

// THEORY.md (20d).
namespace {

/// A dry box of 0.2 x 0.1 x 0.1 m with this lowest corner.
cases::BlockSpec box_at(const std::string& name, Vec3 low) {
  cases::BlockSpec b = brick(0, 0, 0.0, 0.2);
  b.name = name, b.box = {{low, low + Vec3{0.2, 0.1, 0.1}}};
  return b;
}

cases::Case boxes(std::vector<cases::BlockSpec> blocks, geometry::SegmentRule rule) {
  cases::Case c = small_wall(1, 1);
  c.joints.default_law = "dry", c.segment_rule = rule, c.gravity.acceleration = {0.0, 0.0, -9.81};
  c.blocks = std::move(blocks);
  return c;
}

/// 1/s, the bounds of the faces of an element whose outward normals are these.
double bounds_of_faces(const solver::World& w, std::int32_t element, const std::vector<Vec3>& normals) {
  double sum = 0.0;
  for (std::int32_t f = nth(w.elements.first_face, element); f < nth(w.elements.first_face, element + 1); ++f) {
    for (const Vec3 n : normals) sum += norm(nth(w.faces, f).normal - n) < 1e-9 ? nth(w.dashpot_bounds.face, f) : 0.0;
  }
  return sum;
}

constexpr Vec3 kDown{0.0, 0.0, -1.0}, kUp{0.0, 0.0, 1.0}, kLeft{-1.0, 0.0, 0.0}, kRight{1.0, 0.0, 0.0};

void step_for(solver::Simulation& sim, double seconds) {
  for (const double end = sim.time() + seconds; sim.time() < end;) sim.step({});
}

}  // namespace

TEST_CASE("dashpots are bounded by the faces that have something near, and faces beside those by none") {
  for (const auto rule : {geometry::SegmentRule::centres, geometry::SegmentRule::rim}) {
    CAPTURE(static_cast<int>(rule));
    // One lies on the base, one on another, flush; one flies; one slides along a wall.
    cases::Case c = boxes({box_at("alone", {}), box_at("lower", {1.0, 0.0, 0.0}), box_at("upper", {1.0, 0.0, 0.1}),
                           box_at("flies", {2.0, 0.0, 5.0}), box_at("beside", {3.0, 0.0, 0.0}), box_at("wall", {3.2, 0.0, 0.0})},
                          rule);
    c.blocks[3].free = true, c.blocks[3].velocity = {0.0, 0.0, 1.0};
    c.blocks[5].fixed = true;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    step_for(sim, 0.1);
    const solver::World& w = sim.world();
    const auto beta = [&](std::int32_t e) { return nth(w.elements.body, e).beta; };
    CHECK(beta(0) == bounds_of_faces(w, 0, {kDown}));
    CHECK(beta(0) < 0.45 * nth(w.dashpot_bounds.all, 0));
    CHECK(beta(1) == bounds_of_faces(w, 1, {kDown, kUp}));
    CHECK(beta(2) == bounds_of_faces(w, 2, {kDown}));
    CHECK(beta(3) == 0.0);
    CHECK(beta(4) == bounds_of_faces(w, 4, {kDown, kRight}));
    CHECK(beta(5) == 0.0);  // fixed
  }
}

TEST_CASE("dashpots of an element with something near all its faces are bounded as if all touched") {
  std::vector<cases::BlockSpec> blocks;
  for (int i = 0; i < 27; ++i) blocks.push_back(box_at("b" + std::to_string(i), {0.2 * (i % 3), 0.1 * (i / 3 % 3), 0.1 * (i / 9)}));
  const cases::Case c = boxes(std::move(blocks), geometry::SegmentRule::centres);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  step_for(sim, 0.01);
  const solver::World& w = sim.world();
  CHECK(nth(w.elements.body, 13).beta == nth(w.dashpot_bounds.all, 13));
  CHECK(nth(w.elements.body, 26).beta < 0.9 * nth(w.dashpot_bounds.all, 26));
}

TEST_CASE("no bound of dashpots is above that of all faces, and joints of such elements keep their dashpots") {
  const cases::Case c = small_wall(4, 4);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  step_for(sim, 0.01);
  const solver::World& w = sim.world();
  double most = 0.0;
  int raised = 0;
  for (std::int32_t e = 0; e < w.elements.count; ++e) {
    const double all = nth(w.dashpot_bounds.all, e), now = nth(w.elements.body, e).beta;
    CHECK(now > 0.0);
    CHECK(now <= all);
    most = std::max(most, now / all);
  }
  CHECK(most > 0.95);  // of a brick with four neighbours
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    if (w.sides.joint[id] < 0) continue;
    const kernels::SideBlock& b = w.sides.blocks[id / kernels::kLanes];
    const std::int32_t master = b.master[id % kernels::kLanes];
    const std::int32_t slave = nth(w.faces, w.sides.slave_face[id]).is_ground() ? master : b.slave[id % kernels::kLanes];
    const double all = nth(w.dashpot_bounds.all, master) + nth(w.dashpot_bounds.all, slave);
    const double now = nth(w.elements.body, master).beta + nth(w.elements.body, slave).beta;
    CHECK(w.sides.parts[id].dashpot_factor == doctest::Approx((1.0 + w.dt * all) / (1.0 + w.dt * now)).epsilon(1e-14));
    if (now < all) ++raised;
  }
  CHECK(raised > 0);
}

TEST_CASE("a restored state has the bounds of dashpots of the run that it is of") {
  // A wall that is knocked over: joints retire, bricks fly, lie and touch.
  cases::Case c = small_wall(4, 5);
  c.gravity.acceleration = {0.0, 0.0, -9.81};
  for (std::size_t i = 8; i < c.blocks.size(); ++i) c.blocks[i].velocity = {0.0, 2.0, 0.0};
  const cases::Model m = cases::build_model(c);
  solver::Simulation straight(c, m, {}, {});
  solver::RunState plan;
  int retired = 0, new_patches = 0;
  for (int k = 0; k < 400; ++k) {
    step_for(straight, 0.001);
    const solver::World& a = straight.world();
    solver::Simulation again(c, m, {}, {});
    solver::RunState other;
    solver::restore(again, other, solver::save(straight, plan));
    const solver::World& b = again.world();
    if (a.contacts.searched < static_cast<std::int64_t>(a.contacts.active.size())) ++new_patches;
    bool same = true;
    for (std::size_t e = 0; e < a.elements.body.size(); ++e) same = same && a.elements.body[e].beta == b.elements.body[e].beta;
    for (std::size_t id = 0; id < a.sides.joint.size(); ++id) {
      if (a.sides.joint[id] < 0) continue;
      if (a.sides.retired[id] != 0) {
        ++retired;
      } else {
        same = same && a.sides.parts[id].dashpot_factor == b.sides.parts[id].dashpot_factor;
      }
    }
    REQUIRE(same);
  }
  CHECK(retired > 0);
  CHECK(new_patches > 0);
}
