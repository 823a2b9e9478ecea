// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/multirate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/state/field_table.h"
#include "tests/solver/row_hash.h"
#include "tests/solver/small_wall.h"

// Multi-rate stepping (THEORY.md (24a)) against the single step, which is the reference.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kStep = 5e-5;  // s; bricks alone could take 2.07e-4, the timber of a mixed wall 3.7e-5 and more with bricks beside it

/// A wall with timber in and on it, too strong to break.
cases::Case elastic_wall(int courses = 14) {
  cases::Case c = mixed_wall(4, courses);
  for (auto& [name, law] : c.joint_laws) law.tension = law.cohesion = law.compression = 1e12;
  c.damping.alpha = 0.0;
  c.gravity.acceleration = {};
  c.time.step = kStep;
  return c;
}

solver::Simulation simulate(const cases::Case& c, const cases::Model& m, const cases::GroundMotion& g) { return {c, m, g, {}}; }

/// Displacement along x, weighted by height so that it is that of the first mode above all: every twelfth step.
std::vector<double> sway(cases::Case c, int cycle, int steps) {
  c.time.multirate = cycle;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g;
  solver::Simulation sim = simulate(c, m, g);
  solver::Elements& e = sim.world().elements;
  for (std::int32_t i = 0; i < e.count; ++i) e.vx[static_cast<std::size_t>(i)] = 0.1 * e.body[static_cast<std::size_t>(i)].ref.z;
  std::vector<double> path;
  for (int k = 0; k < steps; ++k) {
    if (k % 12 == 0) {
      path.push_back(0.0);
      for (std::int32_t i = 0; i < e.count; ++i)
        path.back() += e.mass[static_cast<std::size_t>(i)] * e.body[static_cast<std::size_t>(i)].ref.z * e.ux[static_cast<std::size_t>(i)];
    }
    sim.step({});
  }
  return path;
}

/// Angular frequency, per sample, of what oscillates near `guess`: how far the phase gets from the first half of a path to the second, each
/// under a window that leaves nothing of other modes.
double frequency_near(const std::vector<double>& x, double guess) {
  const std::size_t half = x.size() / 2;
  const auto phase = [&](std::size_t from) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < half; ++i) {
      const double window = 1.0 - std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(half));
      sum += window * x[from + i] * std::polar(1.0, -guess * static_cast<double>(from + i));
    }
    return std::arg(sum);
  };
  const double turned = std::remainder(phase(half) - phase(0), 2.0 * std::numbers::pi);
  return guess + turned / static_cast<double>(half);
}

/// From the times at which a path goes up through zero.
double rough_frequency(const std::vector<double>& x) {
  std::vector<double> times;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i - 1] < 0.0 && x[i] >= 0.0) times.push_back(static_cast<double>(i));
  }
  REQUIRE(times.size() > 3);
  return 2.0 * std::numbers::pi * static_cast<double>(times.size() - 1) / (times.back() - times.front());
}

/// One block on a base that is inclined by gravity's direction, not glued to it.
cases::Case block_on_slope(double along) {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.contact.friction = 30.0;
  c.gravity.acceleration = {along, 0.0, -9.8};
  c.gravity.settle = false;
  c.base = cases::Base{};
  c.segment_size = 0.05;
  c.joints.default_law = "dry";
  c.blocks.push_back(brick(0, 0, 0.0, 0.2));
  c.blocks.back().material = "stone";
  c.time.step = 4e-5;
  return c;
}

/// An element that a joint holds has no higher level for its contacts than for its joints. Levels of elements that contact couples differ
/// by one at most. No pair is evaluated more often than its elements are moved on, not even one whose joint comes apart before the next
/// search.
void check_contact_levels(const solver::World& w) {
  const solver::Multirate& m = w.multirate;
  const auto index = [](std::int32_t e) { return static_cast<std::size_t>(e); };
  const auto moved_in_time = [&](std::int32_t a, std::int32_t b, int level) {
    for (const std::int32_t e : {a, b}) CHECK(w.batch_level(index(e / kernels::kBatch)) <= level);
  };
  for (std::size_t id = 0; id < w.sides.retired.size(); ++id) {
    if (w.sides.retired[id]) continue;
    const kernels::SideBlock& block = w.sides.blocks[id / kernels::kLanes];
    const std::int32_t a = block.master[id % kernels::kLanes], b = block.slave[id % kernels::kLanes];
    for (const std::int32_t e : {a, b}) CHECK(m.of_contacts[index(e)] <= m.of_joints[index(e)]);
    moved_in_time(a, b, m.contact_level(a, b));
  }
  const solver::Contacts& c = w.contacts;
  for (std::size_t a = 0; a < c.level.size(); ++a) {  // not yet of patches of sides that have just come apart
    for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
      const std::int32_t other = c.element[index(static_cast<std::int32_t>(slot))];
      moved_in_time(c.master[a], other, c.level[a]);
      if (other == w.elements.base || a >= index(static_cast<std::int32_t>(c.searched))) continue;
      for (const std::int32_t e : {c.master[a], other}) CHECK(m.of_contacts[index(e)] <= c.level[a] + 1);
    }
  }
}

double slid(cases::Case c, int cycle, double end) {
  c.time.multirate = cycle;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g;
  solver::Simulation sim = simulate(c, m, g);
  while (sim.time() < end) sim.step({});
  return sim.world().elements.ux[0];
}

}  // namespace

TEST_CASE(
    "multi-rate: an element and two rings round it take the step that it allows, each further ring at most twice the step of the ring "
    "inside it, and sides of one "
    "level stand in blocks of their own") {
  cases::Case c = elastic_wall(22);
  c.materials["cork"] = {600.0, 6e7, 0.3};  // allows twice the step, 1.5e-4 s
  for (cases::BlockSpec& b : c.blocks) {
    if (b.name.starts_with("c10_")) b.material = "cork";
  }
  c.time.multirate = 4;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g;
  solver::Simulation sim = simulate(c, m, g);
  const solver::World& w = sim.world();
  CHECK(w.multirate.every == std::vector<std::int32_t>{1, 2, 4});
  // Eq. 19 of a box: half of its shortest edge by the speed of sound in it.
  const auto own_level = [&](std::size_t e) {
    const cases::Material& material = m.materials[static_cast<std::size_t>(m.blocks[e].material)].value;
    const geometry::Box3 box = geometry::bounds(m.blocks[e].shape);
    const double edge = std::min({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
    const double bound = 0.5 * edge * std::sqrt((1.0 - material.poisson * material.poisson) * material.density / material.young);
    return bound < 2.0 * kStep ? 0 : bound < 4.0 * kStep ? 1 : 2;
  };
  std::vector<std::uint8_t> expected(m.blocks.size(), 0);
  for (std::size_t e = 0; e < expected.size(); ++e) expected[e] = static_cast<std::uint8_t>(own_level(e));
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> inside = expected;
    for (const geometry::Joint& j : m.assembly.joints) {
      if (j.element_b < 0) continue;
      const auto a = static_cast<std::size_t>(j.element_a), b = static_cast<std::size_t>(j.element_b);
      expected[a] = std::min(expected[a], inside[b]), expected[b] = std::min(expected[b], inside[a]);
    }
  }
  for (int k = 0; k < 2; ++k) {
    for (const geometry::Joint& j : m.assembly.joints) {
      if (j.element_b < 0) continue;
      const auto a = static_cast<std::size_t>(j.element_a), b = static_cast<std::size_t>(j.element_b);
      expected[a] = std::min<std::uint8_t>(expected[a], expected[b] + 1),
      expected[b] = std::min<std::uint8_t>(expected[b], expected[a] + 1);
    }
  }
  CHECK(std::equal(expected.begin(), expected.end(), w.multirate.of_joints.begin()));
  solver::renew_contact_levels(sim.world());
  CHECK(w.multirate.of_contacts == w.multirate.of_joints);  // all bonds hold
  // Elements are moved on as often as their contacts may ask, also while these are joints that have yet to come apart.
  solver::renew_moves(sim.world());
  std::int32_t slow = 0;
  while (slow < w.elements.count && w.batch_level(static_cast<std::size_t>(slow / kernels::kBatch)) == 0) ++slow;
  REQUIRE(slow < w.elements.count);
  sim.world().multirate.of_contacts[static_cast<std::size_t>(slow)] = 0;
  solver::renew_moves(sim.world());
  CHECK(w.batch_level(static_cast<std::size_t>(slow / kernels::kBatch)) == 0);
  std::array<int, 3> found{};
  const std::size_t levels = w.multirate.every.size();
  for (std::size_t i = 0; i + 1 < w.sides.live_level.size(); ++i) {
    for (std::int32_t k = w.sides.live_level[i]; k < w.sides.live_level[i + 1]; ++k) {
      const auto block = static_cast<std::size_t>(w.sides.live[static_cast<std::size_t>(k)]);
      for (unsigned l = 0; l < kernels::kLanes; ++l) {
        if ((w.sides.live_lanes[block] >> l & 1U) == 0) continue;
        const kernels::SideBlock& b = w.sides.blocks[block];
        const int level = w.multirate.joint_level(b.master[l], b.slave[l]);
        CHECK(level == static_cast<int>(i % levels));
        ++found[static_cast<std::size_t>(level)];
      }
    }
  }
  for (const int sides : found) CHECK(sides > 10);
}

TEST_CASE("multi-rate: an elastic wall sways as by the single step, and neither gains nor loses energy") {
  const int steps = 24'000;
  const std::vector<double> one = sway(elastic_wall(), 1, steps);
  const double most = *std::ranges::max_element(one);
  const double frequency = frequency_near(one, rough_frequency(one));
  for (const int cycle : {2, 4}) {
    CAPTURE(cycle);
    const std::vector<double> several = sway(elastic_wall(), cycle, steps);
    // Elements with fast and slow pairs go to and fro between two impulses, and slow pairs see the ends of that way, not its middle: their
    // joints, four of fourteen courses here, seem stiffer. By 4.6e-4 and 5.9e-4 of the frequency.
    CHECK(frequency_near(several, rough_frequency(several)) == doctest::Approx(frequency).epsilon(1e-3).scale(0.0));
    // In the last quarter as in the first: a resonance would have grown by then.
    const auto quarter = static_cast<std::ptrdiff_t>(several.size() / 4);
    const double first = *std::max_element(several.begin(), several.begin() + quarter);
    const double last = *std::max_element(several.end() - quarter, several.end());
    CHECK(last == doctest::Approx(first).epsilon(0.1).scale(0.0));
    CHECK(first == doctest::Approx(most).epsilon(0.1).scale(0.0));
  }
}

TEST_CASE("multi-rate: a block slides down a slope as by hand, and one that friction holds does not creep") {
  const double tan_phi = std::tan(30.0 * std::numbers::pi / 180.0), end = 0.5;
  for (const int cycle : {1, 2, 4}) {
    CAPTURE(cycle);
    const double along = 8.0, expected = 0.5 * (along - tan_phi * 9.8) * end * end;
    CHECK(slid(block_on_slope(along), cycle, end) == doctest::Approx(expected).epsilon(0.01).scale(0.0));
    // The elastic slip of its springs is there at once; from then on it stays.
    CHECK(std::abs(slid(block_on_slope(4.0), cycle, 1.0) - slid(block_on_slope(4.0), cycle, 0.5)) < 1e-9);
  }
}

TEST_CASE("multi-rate: a wall that falls keeps the ledger, and has the same bits with any number of threads") {
  cases::Case c = mixed_wall(4, 12);
  c.time.step = kStep;
  c.time.multirate = 4;
  c.output.frame_interval = 0.01;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  RowHash first;
  for (const int threads : {1, 2, 3}) {
    RowHash rows;
    solver::Simulation sim(c, m, g, {.threads = threads});
    solver::RunState plan;
    const solver::RunResult r = solver::run(sim, plan, c, 1.0, rows, [&](const solver::RunStatus&) {
      if (threads == 1) check_contact_levels(sim.world());
      return true;
    });
    CHECK(r.summary.fallen_mass_fraction > 0.1);
    CHECK(r.summary.worst_residual < 2e-3);
    const solver::Contacts& contacts = sim.world().contacts;
    for (const int level : {0, 1}) CHECK(std::ranges::count(contacts.level, level) > 5);
    if (threads == 1) first = rows;
    CHECK(rows.values() == first.values());
  }
}

TEST_CASE("multi-rate: a wall of loose bricks and timber at rest loses no energy to its dashpots") {
  for (const int cycle : {4, 8}) {
    CAPTURE(cycle);
    cases::Case c = mixed_wall(4, 12);
    c.joints.default_law = "dry", c.joints.between.clear();
    c.damping.alpha = 0.0;
    c.time.step = 0.5 * kStep;
    c.time.multirate = cycle;
    const cases::Model m = cases::build_model(c);
    const cases::GroundMotion g;
    solver::Simulation sim = simulate(c, m, g);
    const auto lost_by = [&](double time) {
      while (sim.time() < time) sim.step({});
      sim.step({.ledger = true});
      return sim.energy().dashpot + sim.energy().friction;
    };
    const double at_first = lost_by(0.4);
    CHECK(at_first > 0.05);  // J
    CHECK(lost_by(0.6) - at_first < 1e-3 * at_first);
  }
}

TEST_CASE("multi-rate: other cycles are refused, and a quasi-static analysis has one rate") {
  cases::Case c = small_wall(2, 2);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g;
  for (const int none : {3, 16}) {
    c.time.multirate = none;
    CHECK_THROWS_WITH_AS(simulate(c, m, g), doctest::Contains("allowed: 1, 2, 4, 8"), cases::InputError);
  }
  c.time.multirate = 2;
  c.analysis.kind = cases::AnalysisKind::tilt;
  CHECK(!solver::Simulation(c, m, g, {}).world().multirate.on());
}
