// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include "tests/solver/interrupted_analysis.h"
#include "tests/solver/no_rows.h"
#include "tests/solver/small_wall.h"

// What a run tells of its loads: their forces, and the displacement of the places where they act. And which element is the control point.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

class Rows final : public testing::NoRows {
 public:
  void history(double time, std::span<const solver::HistorySample> s) override {
    times.push_back(time), followed.push_back(s.empty() ? solver::HistorySample{} : s[0]);
  }
  void loads(double, std::span<const solver::LoadSample> s) override { told.emplace_back(s.begin(), s.end()); }

  std::vector<double> times;
  std::vector<solver::HistorySample> followed;
  std::vector<std::vector<solver::LoadSample>> told;
};

/// A wall that settles; then its top brick c3_1 is pushed at a corner, ever harder, and a follower and a moment act on others.
cases::Case loaded_wall() {
  cases::Case c = small_wall(3, 4);
  c.gravity.settle = true, c.gravity.ramp = 0.1, c.gravity.settle_limit = 0.1;
  c.time.duration = 0.1;
  c.output.history_interval = 0.005;
  c.output.history.push_back({"top", {0.2, 0.05, 0.35}});
  cases::Load push;
  push.block = "c3_1", push.force = {0.0, 15.0, 0.0}, push.at = Vec3{0.3, 0.05, 0.4}, push.ramp = {0.0, 0.1};
  cases::Load moment;
  moment.block = "c2_0", moment.moment = {0.0, 0.0, 0.1};
  c.loads = {push, moment};
  return c;
}

void check_same(const Rows& a, const Rows& b) {
  REQUIRE(a.told.size() == b.told.size());
  for (std::size_t i = 0; i < a.told.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(a.told[i][k].force == b.told[i][k].force);
      CHECK(a.told[i][k].displacement == b.told[i][k].displacement);
    }
}

}  // namespace

TEST_CASE("a load's sample is its force, and the displacement of its place since settling, rotation included") {
  const Outcome<Rows> run = run_in_legs<Rows>(loaded_wall());
  const Rows& out = run.out;
  REQUIRE(out.told.size() == out.times.size());
  REQUIRE(out.told.size() > 15);
  double most = 0.0, turned = 0.0;
  const Vec3 arm{0.1, 0.0, 0.05};  // of the corner from the centroid of c3_1
  for (std::size_t i = 0; i < out.told.size(); ++i) {
    REQUIRE(out.told[i].size() == 2);
    const auto& [force, displacement] = out.told[i][0];
    CHECK(force.y == doctest::Approx(15.0 * std::min(1.0, out.times[i] / 0.1)));
    const Vec3 u = out.followed[i].displacement, by_turn = cross(out.followed[i].rotation, arm);
    CHECK(norm(displacement - u - by_turn) < 1e-4 * norm(by_turn) + 1e-9);  // rotations are small
    most = std::max(most, norm(u)), turned = std::max(turned, norm(by_turn));
    CHECK(out.told[i][1].force == Vec3{});
    CHECK(std::isfinite(out.told[i][1].displacement.x));
  }
  CHECK(norm(out.told[0][0].displacement) < 1e-9);  // what settling did is not in it
  CHECK(most > 1e-6);
  CHECK(turned > 1e-7);
  CHECK(norm(out.told.back()[1].displacement) > 0.0);
}

TEST_CASE("samples of loads are the same bits across stops, while settling too, and for any number of threads") {
  const Outcome<Rows> straight = run_in_legs<Rows>(loaded_wall());
  std::int64_t steps = 0;
  std::memcpy(&steps, straight.state.at("plan_steps").bytes.data(), sizeof steps);
  check_same(straight.out, run_in_legs<Rows>(loaded_wall(), {steps / 10, 7 * steps / 10, 9 * steps / 10}, {2, 1, 3}).out);
}

TEST_CASE("a load that moves is sampled where it is, and nowhere before and after its way") {
  cases::Case c = small_wall(3, 4);
  c.time.duration = 0.1;
  c.output.history_interval = 0.01;
  cases::Load load;
  load.force = {0.0, 0.0, -100.0}, load.path = "way.csv";
  c.loads.push_back(load);
  cases::Model m = cases::build_model(c);
  m.support_motions[0].time = {0.02, 0.08}, m.support_motions[0].displacement = {{0.05, 0.05, 1.0}, {0.55, 0.05, 1.0}};
  solver::Simulation sim(c, m, {}, {});
  solver::RunState plan;
  Rows out;
  (void)solver::run(sim, plan, c, c.end(), out, [](const solver::RunStatus&) { return true; });
  REQUIRE(out.told.size() > 9);
  for (std::size_t i = 0; i < out.told.size(); ++i) {
    const bool on = out.times[i] > 0.019;  // constant after its end
    CAPTURE(out.times[i]);
    CHECK(std::isfinite(out.told[i][0].displacement.z) == on);
    if (on) CHECK(out.told[i][0].force.z == doctest::Approx(-100.0));
  }
}

TEST_CASE("the control point of a named part is its element on top that is nearest to the axis of its centre of mass") {
  cases::Case c = small_wall(5, 6);
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.direction = {0.0, 1.0};
  for (cases::BlockSpec& b : c.blocks) b.part = b.box->at(0).z > 0.25 ? "upper part" : "lower part";
  const auto control = [&](const std::string& name) {
    c.analysis.control_name = name;
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    return m.blocks[static_cast<std::size_t>(sim.program().control())].name;
  };
  CHECK(control("lower part") == "c2_2");
  CHECK(control("upper part").starts_with("c5_"));
  CHECK(control("") == control("upper part"));
  CHECK(control("c1_0") == "c1_0");
}
