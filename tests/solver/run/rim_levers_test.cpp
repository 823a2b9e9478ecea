// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cases/census.h"
#include "solver/analysis/modes.h"
#include "solver/run/simulation.h"
#include "solver/setup/setup.h"
#include "tests/cases/paper_house.h"
#include "tests/solver/small_wall.h"

// What the two rules for contact points do to levers and bending stiffness: figures of cases/catalogue/segment-rules.md.

using namespace voussoir;
using geometry::SegmentRule;

namespace {

constexpr double kGravity = 9.8;  // m/s2
constexpr SegmentRule kRules[] = {SegmentRule::centres, SegmentRule::rim};
std::string name(SegmentRule r) { return r == SegmentRule::rim ? "rim" : "centres"; }

/// Dry blocks of all but rigid stone on the base; nothing slides.
cases::Case stone(SegmentRule rule) {
  cases::Case c;
  c.materials["stone"] = {1800.0, 9.8e9, 0.25};
  c.base = cases::Base{};
  c.contact.friction = 60.0;
  c.gravity.ramp = 0.5, c.gravity.settle_limit = 0.1;
  c.segment_rule = rule;
  return c;
}

/// A block of 0.2 x 0.2 x 0.8 m with `n` segments over its base.
cases::Case slender_block(SegmentRule rule, int n) {
  cases::Case c = stone(rule);
  cases::BlockSpec b;
  b.name = "block", b.material = "stone";
  b.box = {{Vec3{-0.1, -0.1, 0.0}, Vec3{0.1, 0.1, 0.8}}};
  c.blocks.push_back(b);
  c.segment_size = 0.2 / n;
  return c;
}

/// Whether any element comes to turn or move by so much within `duration` after settling.
bool falls(const cases::Case& c, double angle, double way, double duration) {
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  while (!sim.at_rest() && !sim.settled_too_long()) sim.step({false, sim.steps() % 20 == 0});
  sim.start_shaking();
  const solver::Elements& e = sim.world().elements;
  while (sim.time() < duration) {
    sim.step({});
    for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
      if (2.0 * std::acos(std::min(1.0, e.qw[i])) > angle || norm(Vec3{e.ux[i], e.uy[i], e.uz[i]}) > way) return true;
    }
  }
  return false;
}

template <class Above>
double bisect(double low, double high, double width, const Above& above) {
  while (high - low > width) {
    const double middle = 0.5 * (low + high);
    (above(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// A semicircular arch of 25 plane-faced voussoirs, mean radius 1.5 m, n = 4 segments across its thickness.
cases::Case arch(SegmentRule rule, double thickness) {
  constexpr int kVoussoirs = 25;
  cases::Case c = stone(rule);
  c.segment_size = thickness / 4.0;
  for (int i = 0; i < kVoussoirs; ++i) {
    cases::BlockSpec b;
    b.name = "v" + std::to_string(i), b.material = "stone", b.extrude = {{0.0, 0.2}};
    const auto corner = [&](double r, int joint) {
      const double angle = std::numbers::pi * joint / kVoussoirs;
      b.polygon.push_back({r * std::cos(angle), joint == 0 || joint == kVoussoirs ? 0.0 : r * std::sin(angle)});
    };
    const double low = 1.5 - 0.5 * thickness, high = 1.5 + 0.5 * thickness;
    corner(low, i), corner(high, i), corner(high, i + 1), corner(low, i + 1);
    c.blocks.push_back(b);
  }
  return c;
}

}  // namespace

TEST_CASE("rules: the joint of a block turns by M l / (E' I) up to the rim, and by 1/(1 - 1/n²) more with centres") {
  for (const SegmentRule rule : kRules) {
    for (const int n : {2, 3, 4}) {
      cases::Case c = testing::paper_materials();
      c.gravity.acceleration = {};
      c.gravity.settle = false;
      c.base = cases::Base{};
      c.damping.ratio = 0.0, c.damping.alpha = 400.0;
      c.joint_laws["normal"].tension = c.joint_laws["normal"].cohesion = c.joint_laws["normal"].compression = 1e12;
      c.segment_rule = rule;
      c.segment_size = 0.2 / n;
      cases::BlockSpec b;
      b.name = "block", b.material = "adobe", b.box = {{Vec3{-0.1, -0.1, 0.0}, Vec3{0.1, 0.1, 0.1}}};
      c.blocks.push_back(b);
      cases::Load load;
      load.block = "block", load.moment = {0.0, 1.0, 0.0}, load.ramp = {0.0, 0.1};
      c.loads.push_back(load);
      const cases::Model m = cases::build_model(c);
      solver::Simulation sim(c, m, {}, {});
      while (sim.time() < 0.5) sim.step({});
      const double plane = 9.8e7 / (1.0 - 0.0625), inertia = std::pow(0.2, 4) / 12.0, exact = 0.05 / (plane * inertia);
      const double got = 2.0 * sim.world().elements.qy[0], ratio = exact / got;
      MESSAGE(name(rule), ", n = ", n, ": bending stiffness over E'I ", ratio);
      CHECK(ratio == doctest::Approx(rule == SegmentRule::rim ? 1.0 : 1.0 - 1.0 / (n * n)).epsilon(1e-4));
    }
  }
}

TEST_CASE("rules: a block on a slope topples at b/h up to the rim, and 1/n sooner with centres") {
  const double alpha = std::atan(0.1 / 0.4);
  for (const SegmentRule rule : kRules) {
    const double lever = rule == SegmentRule::rim ? 0.1 : 0.075, expected = std::atan(lever / 0.4);
    const double found = bisect(0.97 * expected, 1.03 * expected, 2e-3 * expected, [&](double tilt) {
      cases::Case c = slender_block(rule, 4);
      c.gravity.acceleration = {kGravity * std::sin(tilt), 0.0, -kGravity * std::cos(tilt)};
      return falls(c, 0.5 * alpha, 1.0, 3.0);
    });
    const double degrees = 180.0 / std::numbers::pi;
    MESSAGE(name(rule), ", n = 4: topples at ", degrees * found, " degrees, by its lever ", degrees * expected);
    CHECK(std::tan(found) == doctest::Approx(lever / 0.4).epsilon(0.01));
  }
}

TEST_CASE("rules: quarter period of a rocking block") {
  for (const SegmentRule rule : kRules) {
    // Passes the upright with the speed that takes it to half its angle of overturning (Housner 1963).
    const double lever = rule == SegmentRule::rim ? 0.1 : 0.075, h = 0.4, radius = std::hypot(lever, h), alpha = std::atan(lever / h);
    const double inertia = (0.01 + h * h) / 3.0 + radius * radius, rate = std::sqrt(kGravity * radius / inertia);
    const double speed = std::sqrt(2.0 * kGravity * radius * (std::cos(0.5 * alpha) - std::cos(alpha)) / inertia);
    cases::Case c = slender_block(rule, 4);
    c.gravity.settle = false;
    c.blocks[0].velocity = {h * speed, 0.0, lever * speed};
    c.blocks[0].angular_velocity = {0.0, speed, 0.0};
    const cases::Model m = cases::build_model(c);
    solver::Simulation sim(c, m, {}, {});
    double most = 0.0, at_most = 0.0;
    while (sim.time() < 1.4) {
      sim.step({});
      const double angle = 2.0 * sim.world().elements.qy[0];
      if (angle > most) most = angle, at_most = sim.time();
      if (sim.time() > 0.01 && angle < 0.0) break;
    }
    const double quarter = sim.time() - at_most, expected = std::acosh(2.0) / rate;
    MESSAGE(name(rule), ", n = 4: quarter period ", quarter, " s, closed form ", expected, " s; angle ", most, " of ", 0.5 * alpha);
    CHECK(quarter == doctest::Approx(expected).epsilon(0.01).scale(0.0));
    CHECK(most == doctest::Approx(0.5 * alpha).epsilon(0.02).scale(0.0));
  }
}

TEST_CASE("rules: least thickness of a semicircular arch with n = 4") {
  // Limit analysis of 25 voussoirs with hinges at the outermost points: t/R = 0.1070, over 1 − 1/n with centres.
  for (const SegmentRule rule : kRules) {
    const double expected = rule == SegmentRule::rim ? 0.1070 : 0.1070 / 0.75;
    CHECK(!falls(arch(rule, 1.01 * expected * 1.5), 1.0, 0.01, 2.0));
    CHECK(falls(arch(rule, 0.99 * expected * 1.5), 1.0, 0.01, 2.0));
  }
}

TEST_CASE("rules: frequencies and points of the paper's houses" * doctest::skip()) {
  const std::pair<std::string, cases::Case> houses[] = {{"flat20n", testing::paper_flat20()},
                                                        {"flat40n", testing::paper_flat40()},
                                                        {"flat20r", testing::reinforced(testing::paper_flat20())},
                                                        {"vault20n", testing::paper_vault20()},
                                                        {"vault40n", testing::paper_vault40()},
                                                        {"vault20r", testing::reinforced(testing::paper_vault20())}};
  for (const auto& [house, value] : houses) {
    for (const SegmentRule rule : kRules) {
      cases::Case c = value;
      c.segment_rule = rule;
      const cases::Model m = cases::build_model(c);
      const cases::Census n = cases::census(m);
      const std::vector<solver::Mode> modes = solver::natural_modes(*solver::build_world(c, m, {}), 4);
      const auto first = [&](double Vec3::*axis) {
        return std::ranges::max_element(modes, {}, [&](const solver::Mode& x) { return x.mass_share.*axis; })->frequency;
      };
      MESSAGE(house, " ", name(rule), ": ", first(&Vec3::x), " / ", first(&Vec3::y), " Hz; sides ", n.joint_sides, ", free ",
              n.free_segments);
    }
  }
}

TEST_CASE("rules: cost of a step of Flat20N, at rest and shaken" * doctest::skip()) {
  for (const SegmentRule rule : kRules) {
    cases::Case c = testing::paper_flat20();
    c.segment_rule = rule;
    c.gravity.settle = false;
    const cases::Model m = cases::build_model(c);
    solver::Options one;
    one.threads = 1;
    solver::Simulation sim(c, m, testing::strong_shaking(), one);
    for (int part = 0; part < 6; ++part) {
      const std::clock_t from = std::clock();
      for (int i = 0; i < 100; ++i) sim.step({});
      MESSAGE(name(rule), ", step ", sim.steps(), ": ", 10.0 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC, " ms; broken ",
              sim.damage().tension + sim.damage().shear);
      for (int i = 0; i < 400; ++i) sim.step({});
    }
  }
}
