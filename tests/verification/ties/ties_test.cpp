// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cases/names.h"
#include "io/app/session/prepared_case.h"
#include "tests/verification/fixture.h"

// V16: ties against closed forms.
namespace voussoir::testing {
namespace {

const kernels::TieState& tie(const Run& run) { return run.sim().world().ties.state[0]; }

/// Where a point of an element now is that was at `at` at the start.
Vec3 material_point(const Run& run, std::size_t i, Vec3 at) {
  const Quaternion q = run.orientation(i);
  const Vec3 v{q.x, q.y, q.z}, arm = at - run.sim().world().elements.body[i].ref;
  return run.position(i) + arm + 2.0 * cross(v, cross(v, arm) + q.w * arm);
}

/// The wall of tie_wall.toml, stepped until it has come to rest or overturned. \return whether it has overturned
bool overturns(double multiplier) {
  cases::Case c = load("tie_wall").value;
  c.gravity.acceleration.x = multiplier * kGravity;
  Run run(c);
  const auto tilt = [&] { return 2.0 * std::abs(run.orientation(0).y); };
  while (!run.sim().at_rest() && !run.sim().settled_too_long() && tilt() < 0.1) run.cycle({false, run.sim().steps() % 20 == 0});
  if (tilt() >= 0.1) return true;
  run.sim().start_shaking();
  run.until(2.0);
  return tilt() > 0.1;
}

}  // namespace

TEST_CASE("V16: force of a tie over its elongation") {
  const io::LoadedCase pull = load("tie_pull");
  const cases::Model model = io::prepared_model(pull.value);  // with the way of the support
  solver::Options options;
  options.threads = 1, options.reference_kernels = reference_kernels();
  solver::Simulation sim(pull.value, model, {}, options);
  sim.start_shaking();
  const kernels::TieState& rod = sim.world().ties.state[0];
  const double k = 2e11 * 2e-4 / 2.0, yield = 3e8 * 2e-4, slope = 2e9 * 2e-4 / 2.0, first = yield / k;
  const auto envelope = [&](double e) { return e < first ? k * e : yield + slope * (e - first); };
  const double most = envelope(8e-3), plastic = 8e-3 - most / k;
  // After the last point of each branch: the state before a step belongs to the step behind it.
  const std::array<std::array<double, 2>, 5> at{
      {{0.2, envelope(2e-3)}, {0.4, most}, {0.6, most - 3e-3 * k}, {0.8, 0.0}, {1.0, envelope(1e-2)}}};
  for (const auto& [time, force] : at) {
    while (sim.time() < time + 0.5 * sim.dt()) sim.step({false, true});
    expect_within("V16: force at " + cases::text(time) + " s over the yield force", rod.force / yield, std::max(force, 0.0) / yield, 1e-6);
    if (time == 0.6) expect_near("V16: plastic elongation [m]", rod.plastic, plastic, 1e-6);
  }
  const double stored = 0.5 * std::pow(envelope(1e-2), 2) / k, end = 1e-2 - envelope(1e-2) / k;
  expect_near("V16: energy lost by yielding [J]", rod.lost, 0.5 * (yield + envelope(1e-2)) * end, 1e-4);
  expect_near("V16: energy stored [J]", sim.energy().strain, stored, 1e-6);
  expect_below("V16: residual of the ledger", sim.worst_residual(), 1e-6);
}

TEST_CASE("V16: a tie that breaks releases what it stored") {
  const io::LoadedCase pull = load("tie_pull", {"tie[0].elongation=1.25e-3", "tie[0].yield=1e9"});
  const cases::Model model = io::prepared_model(pull.value);
  solver::Options options;
  options.threads = 1, options.reference_kernels = reference_kernels();
  solver::Simulation sim(pull.value, model, {}, options);
  sim.start_shaking();
  const kernels::TieState& rod = sim.world().ties.state[0];
  double most = 0.0;
  while (sim.time() < 0.3) {
    sim.step({false, true});
    most = std::max(most, rod.force);
  }
  const double k = 2e11 * 2e-4 / 2.0, broken_at = 2.5e-3, step = 0.006 / 0.2 * 1e-4;
  CHECK(rod.broken == 1);
  CHECK(rod.force == 0.0);
  expect_within("V16: largest force of a tie that breaks, over k e_u", most / (k * broken_at), 1.0, step / broken_at);
  expect_near("V16: energy released by its break [J]", sim.energy().fracture, 0.5 * k * broken_at * broken_at, 2.0 * step / broken_at);
  expect_below("V16: residual of the ledger, a tie that breaks", sim.worst_residual(), 1e-6);
}

TEST_CASE("V16: pretension of a tied column and, by a plate over two bricks, of a tied wall") {
  for (const auto& [name, area] : {std::pair{"tie_column", 0.04}, {"tie_plate", 2 * 0.19 * 0.2}}) {
    Run run(name);
    CHECK(run.settle());
    run.until(2.0, {false, true}, [] {});
    const double k = 2.1e11 * 5e-5 / 0.6, weight = 1800.0 * area * 0.2 * kGravity;
    const std::array<double, 3> joint{0.1 / (Adobe::plane * area), 0.2 / (Adobe::plane * area), 0.2 / (Adobe::plane * area)};
    const double all = joint[0] + joint[1] + joint[2], sag = weight * (3 * joint[0] + 2 * joint[1] + joint[2]);
    expect_near(std::string("V16: force of the tie [N], ") + name, tie(run).force, (4000.0 - k * sag) / (1.0 + k * all), 1e-6);
    expect_below(std::string("V16: residual of the ledger, ") + name, run.sim().worst_residual(), 1e-6);
  }
}

TEST_CASE("V16: pretension of a tied arch") {
  const std::array<Vec3, 2> end{Vec3{0.1, -1.1, 0.1}, Vec3{0.1, 1.1, 0.1}};
  const std::array<std::size_t, 2> springer{4, 0};
  const auto apart = [&](const Run& run) {
    std::array<Vec3, 2> now;
    for (std::size_t i = 0; i < 2; ++i) now[i] = material_point(run, springer[i], end[i]);
    return norm(now[1] - now[0]) - norm(end[1] - end[0]);
  };
  Run tied("tie_arch");
  CHECK(tied.settle());
  tied.until(2.0, {false, true}, [] {});
  const double k = 2e11 * 1e-4 / 2.2, force = tie(tied).force;
  CHECK(std::abs(force - 1000.0) > 100.0);  // what the arch gives way by
  expect_near("V16: force of the tie in an arch [N]", force, 1000.0 + k * apart(tied), 1e-6);

  cases::Case loaded = load("tie_arch").value;
  loaded.ties.clear();
  for (std::size_t i = 0; i < 2; ++i) {
    cases::Load by_tie;
    by_tie.block = loaded.blocks[springer[i]].name, by_tie.at = end[i], by_tie.force = {0.0, i == 0 ? force : -force, 0.0};
    loaded.loads.push_back(by_tie);
  }
  Run second(loaded);
  CHECK(second.settle());
  second.until(2.0, {false, true}, [] {});
  expect_near("V16: how far the springers have moved apart [m]", apart(tied), apart(second), 1e-6);
  expect_below("V16: residual of the ledger, tied arch", tied.sim().worst_residual(), 1e-6);
}

TEST_CASE("V16: a wall held by a tie overturns at the multiplier of the moment balance") {
  const double mass = 2000.0 * 0.3 * 0.6 * 1.2, yield = 1e8 * 1e-5;
  const double expected = (mass * kGravity * 0.15 + yield * 1.0) / (mass * kGravity * 0.6);
  double low = 0.9 * expected, high = 1.1 * expected;
  REQUIRE(!overturns(low));
  REQUIRE(overturns(high));
  while (high - low > 2e-3 * expected) {
    const double middle = 0.5 * (low + high);
    (overturns(middle) ? high : low) = middle;
  }
  expect_near("V16: multiplier at which the tied wall overturns", 0.5 * (low + high), expected, 1e-2);
}

TEST_CASE("V16: a deck in shear is as stiff as the shear panel") {
  Run run("deck_shear");
  run.until(0.8);
  const auto last = static_cast<std::size_t>(run.sim().world().elements.count) - 1;  // "right", and "left" before it
  const double panel = 100.0 * 0.5 / (2.0e4 * 0.8);
  expect_near("V16: one beam of a deck against the other, pushed along them [m]", run.displacement(last - 1).y - run.displacement(last).y,
              panel, 1e-2);
}

TEST_CASE("V16: a tie stiffer than the step bears is bounded, and takes no smaller step") {
  const std::vector<std::string> stiff{"tie[0].area=0.05", "tie[0].pretension=0.0"};
  Run plain("tie_column"), run("tie_column", stiff);
  CHECK(run.sim().dt() == plain.sim().dt());
  const solver::Ties::Tie& t = run.sim().world().ties.tie[0];
  CHECK(plain.sim().world().ties.tie[0].law.stiffness == plain.sim().world().ties.tie[0].wanted);
  CHECK(t.law.stiffness < 0.5 * t.wanted);
  CHECK(run.settle());
  for (double* v : {&run.sim().world().elements.vz[2], &run.sim().world().elements.vx[2]}) *v = 0.05;
  run.until(0.2, {false, true}, [] {});
  expect_below("V16: residual of the ledger, a tie at the bound of its stiffness", run.sim().worst_residual(), 1e-3);
  expect_below("V16: speed after the swing [m/s]", norm(run.velocity(2)), 0.1);
}

}  // namespace voussoir::testing
