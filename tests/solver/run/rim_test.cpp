// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/state/field_table.h"
#include "solver/state/saved_state.h"
#include "tests/solver/rods.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// segments.rule = "rim": what holds by the rule of centres holds with points up to the rim of joints too.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Joints off any grid, timber, and a plank: overlaps of many sizes.
cases::Case rim_wall(int length, int courses) {
  cases::Case c = mixed_wall(length, courses);
  c.segment_rule = geometry::SegmentRule::rim;
  return c;
}

std::string difference(solver::World& a, solver::World& b) {
  const std::vector<solver::Field> p = solver::fields(a), q = solver::fields(b);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (solver::packed(p[i]) != solver::packed(q[i])) return p[i].name;
  }
  return {};
}

std::ptrdiff_t patches_that_touch(const solver::World& w) {
  return std::ranges::count_if(w.patches.patch, [](const auto& p) { return p.touching > 0; });
}

}  // namespace

TEST_CASE("rim: the bits do not depend on the number of threads, through cracking, falling and contact") {
  const cases::Case c = rim_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  CHECK(std::ranges::all_of(m.assembly.joints, [](const geometry::Joint& j) { return j.merged == (j.element_b != geometry::kBase); }));
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation one(c, m, g, {}), two(c, m, g, {});
  two.set_threads(2);
  std::ptrdiff_t most_touching = 0;
  for (int i = 0; i < 15000; ++i) {  // 0.55 s
    const bool ledger = i % 50 == 0;
    one.step({ledger, ledger});
    two.step({ledger, ledger});
    if (i % 20 != 0) continue;
    CAPTURE(i);
    REQUIRE(difference(one.world(), two.world()) == "");
    most_touching = std::max(most_touching, patches_that_touch(one.world()));
  }
  CHECK(one.damage().tension > 500);
  CHECK(most_touching > 0);
  CHECK(one.worst_residual() < 1e-3);
}

TEST_CASE("rim: fast and reference kernels, the same wall until it cracks, then the same segments break in the same order") {
  const cases::Case c = rim_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options plain;
  plain.reference_kernels = true;
  solver::Simulation fast(c, m, g, {}), reference(c, m, g, plain);
  int i = 0;
  for (; fast.damage().tension == 0; ++i) fast.step({}), reference.step({});
  CHECK(fast.damage().tension == reference.damage().tension);
  for (const int end = i + 1200; i < end; ++i) fast.step({false, true}), reference.step({false, true});
  REQUIRE(std::min(fast.cracks().size(), reference.cracks().size()) > 200);
  for (std::size_t k = 0; k < 200; ++k) {
    const solver::CrackRow &a = fast.cracks()[k], &b = reference.cracks()[k];
    CAPTURE(k);
    CHECK(a.time == b.time);
    CHECK(a.joint == b.joint);
    CHECK(a.mode == b.mode);
    CHECK(norm(a.position - b.position) < 1e-6);
  }
}

TEST_CASE("rim: a run that is stopped in a collapse and gone on with has the bits of one that is not") {
  const cases::Case c = rim_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation straight(c, m, g, {}), first(c, m, g, {}), second(c, m, g, {});
  RowHash rows, rows_of_first;
  solver::RunState plan, plan_of_first, plan_of_second;
  const double end = 0.5, middle = 0.3;
  const auto go_on = [](const solver::RunStatus&) { return true; };
  solver::run(straight, plan, c, end, rows, go_on);
  const auto stop = [&](const solver::RunStatus& s) { return s.time < middle; };
  CHECK(solver::run(first, plan_of_first, c, end, rows_of_first, stop).stopped);
  CHECK(first.damage().tension > 0);
  solver::restore(second, plan_of_second, solver::save(first, plan_of_first));
  solver::run(second, plan_of_second, c, end, rows_of_first, go_on);
  CHECK(difference(straight.world(), second.world()) == "");
  CHECK(rows.values() == rows_of_first.values());
  CHECK(patches_that_touch(second.world()) > 0);
}

TEST_CASE("rim: a wall that is shaken, cracks and falls loses energy and gains none") {
  const cases::GroundMotion g = strong_shaking();
  const cases::Case c = rim_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, g, {});
  solver::EnergyRow before{};
  double least = 0.0;  // of what is lost between two rows, over all that has been
  while (sim.time() < 0.6) {
    sim.step({false, sim.steps() % 20 == 0});
    sim.cracks().clear();
    if ((sim.steps() - 1) % 20 != 0) continue;
    const solver::EnergyRow& now = sim.energy();
    const double all = now.friction + now.fracture + now.dashpot + now.damping + 1e-300;
    for (const double gain :
         {before.friction - now.friction, before.fracture - now.fracture, before.dashpot - now.dashpot, before.damping - now.damping})
      least = std::min(least, -gain / all);
    before = now;
  }
  CAPTURE(least);
  CHECK(sim.damage().tension + sim.damage().shear > 500);
  CHECK(sim.worst_residual() < 1e-4);
  CHECK(least > -1e-6);
}

TEST_CASE("rim: in a wall that stands no free point touches a neighbour, though faces are flush") {
  cases::Case c = rim_wall(4, 6);
  for (auto& [name, law] : c.joint_laws) law.tension *= 1e6, law.cohesion *= 1e6, law.compression *= 1e6;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  for (int i = 0; i < 1500; ++i) {
    sim.step({});
    REQUIRE(patches_that_touch(sim.world()) == 0);
  }
}

TEST_CASE("rim: crossed edges of bodies that fall on each other sink a millimetre or so, not half a segment") {
  for (const bool rim : {false, true}) {
    cases::Case c = small_wall(1, 1);
    c.segment_rule = rim ? geometry::SegmentRule::rim : geometry::SegmentRule::centres;
    c.base = std::nullopt;
    c.blocks = {rod(false, 0.0), rod(true, 2.0 * kHalfDiagonal + 0.001)};
    c.blocks[0].fixed = true, c.blocks[1].free = true;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    double least = 0.0;
    while (sim.time() < 0.1) {
      sim.step({});
      least = std::min(least, sim.world().elements.uz[1]);
    }
    const double sunk = -least - 0.001;
    MESSAGE("rim " << rim << ": " << 1e3 * sunk << " mm");
    CHECK(sunk > 0.0);
    CHECK(sunk < (rim ? 0.0025 : 0.0125));
  }
}

TEST_CASE("under segments.torsion joints within a solid have no twist of their own, to the last digit, wherever they stand") {
  for (int i = 0; i < 8; ++i) {
    cases::Case c = small_wall(1, 0);
    c.segment_rule = geometry::SegmentRule::rim, c.segment_torsion = geometry::Torsion::solid;
    for (int k = 0; k < 18; ++k) {
      cases::BlockSpec b = brick(k / 9, k % 9, 0.0, 0.2);
      for (Vec3& corner : *b.box) corner.x += 0.2 * (k % 3) + 0.173 * i, corner.y += 0.1 * (k / 3 % 3) + 0.31 * i;
      c.blocks.push_back(b);
    }
    const cases::Model m = cases::build_model(c);
    const solver::Simulation sim(c, m, {}, {});
    const solver::Sides& sides = sim.world().sides;
    int found = 0;
    for (std::int64_t id = 0; id < sides.count(); ++id) {
      const kernels::Side s = sides.side(id);
      if (std::min(s.master, s.slave) != 4 || std::max(s.master, s.slave) != 13) continue;
      CHECK(s.twist == 0.0);
      ++found;
    }
    CHECK(found == 1);
  }
}
