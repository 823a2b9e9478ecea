// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/run/simulation.h"
#include "solver/state/field_table.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A simulation with a given number of threads, all of which come to each job, however short.
struct Run {
  Run(const cases::Case& c, const cases::Model& m, const cases::GroundMotion& g, int threads_, solver::Options o = {})
      : threads(threads_), sim(c, m, g, o) {
    sim.set_threads(threads);
    sim.world().team.wait_for_all(true);
  }
  void step(bool ledger) { sim.step({ledger, ledger}); }
  int threads;
  solver::Simulation sim;
};

/// First field in which two worlds differ, empty if none does.
std::string difference(solver::World& a, solver::World& b) {
  const std::vector<solver::Field> p = solver::fields(a), q = solver::fields(b);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (solver::packed(p[i]) != solver::packed(q[i])) return p[i].name;
  }
  return {};
}

/// Slipped segment sides, after a check that the running counts are those of the state.
std::int64_t checked_slips(solver::Simulation& s) {
  std::int64_t bonded = 0, slipped = 0;
  solver::World& w = s.world();
  for (std::int64_t id = 0; id < w.sides.count(); ++id) {
    const auto side = static_cast<std::size_t>(id);
    if (w.sides.joint[side] < 0 || w.sides.retired[side]) continue;
    const kernels::SegmentsView q = w.sides.segments(id);
    for (int i = 0; i < w.points.count[static_cast<std::size_t>(w.sides.set[side])]; ++i) {
      bonded += kernels::holds(q.bond[i]) ? w.sides.faces[side] : 0;
      slipped += q.bond[i] == kernels::Bond::slipped ? w.sides.faces[side] : 0;
    }
  }
  CHECK(s.damage().slipped == slipped);
  CHECK(s.damage().bonded == bonded);
  return slipped;
}

void step_side_by_side(std::vector<std::unique_ptr<Run>>& runs, int steps) {
  for (int i = 0; i < steps; ++i) {
    for (auto& r : runs) r->step(i % 50 == 0);
    for (std::size_t k = 1; k < runs.size(); ++k) {
      const std::string where = difference(runs[0]->sim.world(), runs[k]->sim.world());
      INFO("step " << i << ", " << runs[k]->threads << " threads");
      REQUIRE(where == "");
      REQUIRE(runs[0]->sim.energy().residual == runs[k]->sim.energy().residual);
    }
  }
}

}  // namespace

TEST_CASE("the bits do not depend on the number of threads, through cracking, falling and contact") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3, 8}) runs.push_back(std::make_unique<Run>(c, m, g, threads));
  std::int64_t most_slips = 0;
  for (int part = 0; part < 36; ++part) {
    step_side_by_side(runs, 100);
    most_slips = std::max(most_slips, checked_slips(runs[0]->sim));
  }
  CHECK(most_slips > 50);
  const solver::Simulation& s = runs[0]->sim;
  CHECK(s.damage().tension > 500);
  CHECK(s.world().contacts.searches > 10);
  CHECK(std::any_of(s.world().patches.patch.begin(), s.world().patches.patch.end(), [](const auto& p) { return p.touching > 0; }));
}

TEST_CASE("the bits of a wall of bricks in cells do not depend on the number of threads, while bricks split") {
  cases::Case c = small_wall(3, 5);
  c.materials["adobe"].inside = "brick";
  c.joint_laws["brick"] = c.joint_laws["mortar"];  // no stronger than the mortar
  for (cases::BlockSpec& b : c.blocks) b.cells = cases::CellCounts{2, 1, 2};
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3}) runs.push_back(std::make_unique<Run>(c, m, g, threads));
  step_side_by_side(runs, 3000);
  std::int64_t split = 0;  // segments between cells of one brick
  solver::World& w = runs[0]->sim.world();
  for (std::size_t j = 0; j < w.sides.joint.size(); ++j) {
    if (w.sides.joint[j] < 0) continue;
    const geometry::Joint& joint = m.assembly.joints[static_cast<std::size_t>(w.sides.joint[j])];
    if (joint.element_b < 0) continue;
    const std::int32_t unit = m.blocks[static_cast<std::size_t>(joint.element_a)].unit;
    if (unit < 0 || unit != m.blocks[static_cast<std::size_t>(joint.element_b)].unit) continue;
    const kernels::SegmentsView q = w.sides.segments(static_cast<std::int64_t>(j));
    for (int i = 0; i < w.points.count[static_cast<std::size_t>(w.sides.set[j])]; ++i) split += kernels::holds(q.bond[i]) ? 0 : 1;
  }
  CHECK(split > 50);
}

TEST_CASE("the bits do not depend on threads that come and go, nor on who comes too late") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options own_pace;
  own_pace.threads = 3, own_pace.own_pace = true;
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 8, 8}) runs.push_back(std::make_unique<Run>(c, m, g, threads));
  runs.push_back(std::make_unique<Run>(c, m, g, 3, own_pace));
  for (std::size_t k = 2; k < runs.size(); ++k) runs[k]->sim.world().team.wait_for_all(false);
  std::mt19937 random(7);
  for (int i = 0; i < 1200; ++i) {
    for (std::size_t k = 1; k < 3; ++k) runs[k]->sim.set_threads(std::uniform_int_distribution<int>(1, 8)(random));
    step_side_by_side(runs, 2);
  }
  CHECK(runs[0]->sim.damage().tension > 300);
  CHECK(runs[0]->sim.world().contacts.searches > 5);
}

TEST_CASE("the bits of a wall in a mesh of straps do not depend on the number of threads, while they go slack, yield and break") {
  cases::Case c = small_wall(6, 10);
  for (int row = 0; row < 10; ++row) {
    for (int k = 0; k < 12; ++k) {
      const Vec3 at{0.05 + 0.1 * k, 0.0, 0.05 + 0.1 * row};
      for (const Vec3 by : {Vec3{0.1, 0.0, 0.0}, Vec3{0.0, 0.0, 0.1}, Vec3{0.1, 0.0, 0.1}}) {
        const Vec3 to = at + by;
        if (to.x > 1.2 || to.z > 1.0 || (row % 2 == 0 && k % 2 == 0 && by.z == 0.0)) continue;  // not within one brick
        c.ties.push_back(
            {.name = std::to_string(c.ties.size()), .from = at, .to = to, .area = 1e-6, .young = 1e9, .yield = 4e6, .elongation = 0.1});
      }
    }
  }
  // Those that hold one brick alone, in courses that begin with halves.
  std::erase_if(c.ties, [](const cases::Tie& t) {
    return t.from.z == t.to.z && std::lround(t.from.z / 0.1 - 0.5) % 2 == 1 && std::lround(t.from.x / 0.1 - 0.5) % 2 == 1;
  });
  REQUIRE(c.ties.size() > 256);  // from so many on they are shared out
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3}) runs.push_back(std::make_unique<Run>(c, m, g, threads));
  step_side_by_side(runs, 4000);
  const auto& ties = runs[0]->sim.world().ties.state;
  CHECK(std::ranges::any_of(ties, [](const auto& s) { return s.broken == 1; }));
  CHECK(std::ranges::any_of(ties, [](const auto& s) { return s.broken == 0 && s.plastic > 0.0 && s.force == 0.0; }));
  CHECK(runs[0]->sim.worst_residual() < 1e-2);
}

TEST_CASE("the bits of joints of two sides and of timber do not depend on the number of threads") {
  const cases::Case c = mixed_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3}) runs.push_back(std::make_unique<Run>(c, m, g, threads));
  const solver::World& w = runs[0]->sim.world();
  CHECK(std::ranges::count_if(m.assembly.joints, [](const geometry::Joint& j) { return j.element_b >= 0 && !j.merged; }) > 30);
  CHECK(std::ranges::count_if(m.assembly.joints, [](const geometry::Joint& j) { return j.element_b >= 0 && j.merged; }) > 20);
  std::int64_t most_slips = 0;
  for (int part = 0; part < 36; ++part) {
    step_side_by_side(runs, 100);
    most_slips = std::max(most_slips, checked_slips(runs[0]->sim));
  }
  CHECK(most_slips > 50);
  CHECK(runs[0]->sim.damage().tension > 500);
  CHECK(w.contacts.searches > 10);
}

TEST_CASE("an out-of-cache model gives the same bits with any number of threads") {
  const cases::Case c = small_wall(8, 6);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options far;
  far.out_of_cache_from = 1;
  far.cell = 0.45;
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3, 8}) runs.push_back(std::make_unique<Run>(c, m, g, threads, far));
  const solver::World& w = runs[0]->sim.world();
  CHECK(w.out_of_cache);
  CHECK(w.sides.task_first.size() > 5);
  step_side_by_side(runs, 60);
  CHECK(std::ranges::count(w.sides.side_state, kernels::SideState::whole) > 50);
  step_side_by_side(runs, 2340);
  CHECK(runs[0]->sim.damage().tension > 500);
  CHECK(w.contacts.searches > 10);
  // Near, sums have another order: the same response but for round-off, up to first damage.
  Run near(c, m, g, 2), again(c, m, g, 2, far);
  CHECK(!near.sim.world().out_of_cache);
  for (int i = 0; i < 60; ++i) near.step(false), again.step(false);
  const auto &a = near.sim.world().elements.uz, &b = again.sim.world().elements.uz;
  CHECK(std::ranges::any_of(a, [](double u) { return std::abs(u) > 1e-9; }));
  for (std::size_t e = 0; e < a.size(); ++e) CHECK(std::abs(a[e] - b[e]) < 1e-15);
}

TEST_CASE("what is known of pairs saves looks at points and changes no bit, through cracking, falling and contact") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  Run knows(c, m, g, 1), forgets(c, m, g, 1);
  std::int64_t waiting = 0, touching = 0;
  for (int i = 0; i < 6000; ++i) {
    solver::list_candidates(forgets.sim.world());
    knows.step(false), forgets.step(false);
    INFO("step " << i);
    REQUIRE(difference(knows.sim.world(), forgets.sim.world()) == "");
    for (const kernels::Candidate& k : knows.sim.world().contacts.candidate) {
      waiting += k.safe > 0.0;
      touching += k.face >= 0;
    }
  }
  CHECK(touching > 10000);
  CHECK(waiting > 10000);
}

TEST_CASE("sides that span more than two cells are run after all others, with the same bits for any number of threads") {
  const cases::Case c = small_wall(4, 4);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options small;
  small.cell = 0.06;  // bricks lie 0.1 and 0.2 m apart
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 3}) runs.push_back(std::make_unique<Run>(c, m, g, threads, small));
  const solver::Sides& s = runs[0]->sim.world().sides;
  CHECK(s.overflow_colour > 0);
  CHECK(s.overflow_colour + 2 == static_cast<std::int32_t>(s.colour_first.size()));
  step_side_by_side(runs, 2500);
  Run all(c, m, g, 2);
  CHECK(all.sim.world().sides.overflow_colour == -1);
  // Another order of summation: the same response but for round-off, up to first damage.
  Run first(c, m, g, 2, small);
  for (int i = 0; i < 300; ++i) all.step(false), first.step(false);
  for (std::size_t e = 0; e < static_cast<std::size_t>(all.sim.world().elements.count); ++e) {
    CHECK(all.sim.world().elements.uy[e] == doctest::Approx(first.sim.world().elements.uy[e]).epsilon(1e-9).scale(1e-6));
  }
}

TEST_CASE("the plain kernels give the same bits with any number of threads") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options plain;
  plain.reference_kernels = true;
  std::vector<std::unique_ptr<Run>> runs;
  for (const int threads : {1, 2, 3}) runs.push_back(std::make_unique<Run>(c, m, g, threads, plain));
  step_side_by_side(runs, 400);
}
