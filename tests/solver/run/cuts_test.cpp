// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/cuts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "solver/run/simulation.h"
#include "solver/state/field_table.h"
#include "tests/solver/small_wall.h"

// What goes through a cut, against the forces on the base, the balance of what it parts, and other numbers of threads.
namespace voussoir::testing {
namespace {

enum Name { foot, bed, left, right, bed_from_below };

/// A wall of six courses that comes down; its cuts lie at its foot and between the second course and the third.
cases::Case cut_wall() {
  cases::Case c = mixed_wall(4, 6);
  std::vector<cases::Cut>& cuts = c.output.cuts;
  cuts.resize(5);
  cuts[foot].name = "foot", cuts[foot].point = {0.1, 0.2, 0.0};
  for (const Name name : {bed, left, right, bed_from_below}) cuts[name].name = std::to_string(name), cuts[name].point = {0.3, 0.05, 0.2};
  cuts[left].box = {{Vec3{-1.0, -1.0, -1.0}, Vec3{0.33, 1.0, 2.0}}};
  cuts[right].box = {{Vec3{0.33, -1.0, -1.0}, Vec3{2.0, 1.0, 2.0}}};
  cuts[bed_from_below].normal = {0.0, 0.0, -3.0};
  // Across the bed within either box, from the base across both, and above both.
  const auto strap = [&](Vec3 from, Vec3 to) {
    c.ties.push_back({.name = std::to_string(c.ties.size()), .from = from, .to = to, .area = 1e-6, .young = 5e9, .pretension = 100.0});
  };
  strap({0.05, 0.05, 0.15}, {0.25, 0.05, 0.35}), strap({0.75, 0.05, 0.35}, {0.5, 0.05, 0.15});
  strap({0.1, 0.05, 0.0}, {0.15, 0.05, 0.55}), strap({0.1, 0.05, 0.45}, {0.6, 0.05, 0.55});
  return c;
}

/// What the part above a height gets from all that touches it, by its motion in one step: Eqs. (22) and (23) solved for F and T.
solver::CutSample by_balance(const solver::World& before, const solver::World& after, Vec3 about, Vec3 gravity, Vec3 ground) {
  const solver::Elements &e = before.elements, &f = after.elements;
  solver::CutSample sum;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.body[i].ref.z < about.z) continue;
    const double a = 0.5 * e.alpha[i] * before.dt;
    const Vec3 v{e.vx[i], e.vy[i], e.vz[i]}, next{f.vx[i], f.vy[i], f.vz[i]};
    const Vec3 force = e.mass[i] * ((((1.0 + a) * next - (1.0 - a) * v) / before.dt) - gravity + ground);
    const Vec3 torque = (Vec3{f.lx[i], f.ly[i], f.lz[i]} - Vec3{e.lx[i], e.ly[i], e.lz[i]}) / before.dt;
    sum.force += force;
    sum.moment += cross(e.body[i].ref + Vec3{e.ux[i], e.uy[i], e.uz[i]} - about, force) + torque;
  }
  return sum;
}

solver::Options with(int threads) {
  solver::Options o;
  o.threads = threads;
  return o;
}

bool same(const std::vector<solver::CutSample>& a, const std::vector<solver::CutSample>& b) {
  bool all = a.size() == b.size() && !a.empty();
  for (std::size_t k = 0; all && k < a.size(); ++k) all = a[k].force == b[k].force && a[k].moment == b[k].moment;
  return all;
}

}  // namespace

TEST_CASE("cuts: balance of the part above, forces on the base, parts of a cut, until the wall is down") {
  const cases::Case c = cut_wall();
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion motion = strong_shaking();
  solver::Simulation sim(c, m, motion, with(1)), next(c, m, motion, with(1));
  double weight = 0.0;
  for (std::size_t i = 0; i < m.blocks.size(); ++i) weight += sim.world().elements.mass[i] * 9.8;
  double most = 0.0;
  for (int i = 0; i < 12000; ++i) {
    const bool look = i % 37 == 0;
    const double time = sim.time();
    next.step({look, look});
    if (!look) {
      sim.step({});
      continue;
    }
    const std::vector<solver::CutSample>& cuts = next.cuts();
    const solver::CutSample above =
        by_balance(sim.world(), next.world(), c.output.cuts[bed].point, {0, 0, -9.8}, cases::acceleration_at(motion, time));
    sim.step({look, look});
    const double scale = weight + norm(above.force);
    INFO("step " << i);
    REQUIRE(norm(cuts[bed].force + above.force) < 1e-9 * scale);
    REQUIRE(norm(cuts[bed].moment + above.moment) < 1e-9 * scale);
    REQUIRE(norm(cuts[left].force + cuts[right].force - cuts[bed].force) < 1e-12 * scale);
    REQUIRE(norm(cuts[left].moment + cuts[right].moment - cuts[bed].moment) < 1e-12 * scale);
    REQUIRE(norm(cuts[bed_from_below].force + cuts[bed].force) < 1e-12 * scale);
    REQUIRE(norm(cuts[foot].force + next.forces().base_shear) < 1e-9 * scale);
    const Vec3 about_origin = cuts[foot].moment + cross(c.output.cuts[foot].point, cuts[foot].force);
    REQUIRE(norm(about_origin + next.forces().base_moment) < 1e-9 * scale);
    most = std::max(most, norm(cuts[bed].force));
  }
  CHECK(most > 0.5 * weight);
  CHECK(next.damage().bonded < 0.5 * solver::Simulation(c, m, motion, with(1)).damage().bonded);  // it has come apart
}

TEST_CASE("cuts: bodies that overlap, where edges cross") {
  cases::Case c = small_wall(1, 2);  // one brick on another; the cut needs a joint to part
  cases::BlockSpec below, above;
  below.name = "below", below.material = "adobe", below.fixed = true;
  below.box = {{Vec3{0.8, -0.2, -0.2}, Vec3{1.2, 0.2, 0.2}}};
  below.rotate = cases::Rotation{{0, 1, 0}, 45.0, {1.0, 0.0, 0.0}};
  above.name = "above", above.material = "adobe", above.free = true;
  const double top = 0.2 * std::sqrt(2.0), middle = top + 0.1 * std::sqrt(2.0) + 1e-4;
  above.box = {{Vec3{0.9, -0.1, middle - 0.1}, Vec3{1.1, 0.1, middle + 0.1}}};
  above.rotate = cases::Rotation{{1, 0, 0}, 45.0, {1.0, 0.0, middle}};
  for (cases::BlockSpec* b : {&below, &above}) {
    c.blocks.push_back(*b);
  }
  for (cases::BlockSpec& b : c.blocks)
    if (!b.rotate) (*b.box)[0].z += 0.2, (*b.box)[1].z += 0.2;
  c.base.reset();
  c.blocks[0].fixed = true;
  cases::Cut cut;
  cut.name = "between", cut.point = {0.0, 0.0, 0.3};
  c.output.cuts = {cut};
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, with(1)), next(c, m, {}, with(1));
  bool overlapped = false;
  for (int i = 0; i < 8000; ++i) {
    next.step({true, true});
    const solver::CutSample got = by_balance(sim.world(), next.world(), cut.point, {0, 0, -9.8}, {});
    sim.step({true, true});
    INFO("step " << i);
    REQUIRE(norm(next.cuts()[0].force + got.force) < 1e-9 * (1e3 + norm(got.force)));
    REQUIRE(norm(next.cuts()[0].moment + got.moment) < 1e-9 * (1e3 + norm(got.force)));
    overlapped = overlapped || !next.world().overlaps.springs.empty();
  }
  CHECK(overlapped);
}

TEST_CASE("cuts: the same bits for any threads; they change nothing of the run") {
  const cases::Case c = cut_wall();
  cases::Case without = c;
  without.output.cuts.clear();
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion motion = strong_shaking();
  solver::Simulation one(c, m, motion, with(1)), three(c, m, motion, with(3));
  solver::Simulation plain(without, m, motion, with(2));
  for (int i = 0; i < 6000; ++i) {
    const bool look = i % 53 == 0;
    for (solver::Simulation* s : {&one, &three, &plain}) s->step({look, look});
    if (!look) continue;
    INFO("step " << i);
    REQUIRE(same(one.cuts(), three.cuts()));
    REQUIRE(solver::state_hash(one.world()) == solver::state_hash(plain.world()));
  }
}

TEST_CASE("cuts: one that parts nothing is refused") {
  cases::Case c = cut_wall();
  c.output.cuts[left].box = {{Vec3{5.0, -1.0, -1.0}, Vec3{6.0, 1.0, 2.0}}};
  const cases::Model m = cases::build_model(c);
  CHECK_THROWS_WITH_AS(
      solver::Simulation(c, m, {}, {}),
      "output.cut[2]: \"2\" cuts no joint: no two elements that touch have it between their centroids, with the middle in its box",
      cases::InputError);
}

}  // namespace voussoir::testing
