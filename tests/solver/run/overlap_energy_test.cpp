// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

// A brick is thrown at another one, at random angles: what springs of whole bodies give out is not hidden among losses.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

cases::Case thrown_brick(unsigned seed, double damping) {
  std::mt19937 random(seed);
  const auto any = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
  cases::Case c = small_wall(1, 1);
  c.base = std::nullopt;
  c.gravity.acceleration = {};
  c.damping.alpha = 0.0;
  c.contact.damping = damping;
  c.joints.default_law = "dry";
  c.segment_rule = geometry::SegmentRule::rim;
  c.blocks = {brick(0, 0, 0.0, 0.2), brick(4, 0, 0.0, 0.2)};
  for (cases::BlockSpec& b : c.blocks) {
    const double x = any(), y = any(), z = any();
    b.rotate = cases::Rotation{normalised(Vec3{x, y, z}), 180.0 * any(), {0.1, 0.05, b.box->front().z + 0.05}};
    b.free = true;
  }
  const double x = any(), y = any(), turn = any();
  c.blocks[1].velocity = {0.3 * x, 0.3 * y, -3.0};
  c.blocks[1].angular_velocity = {10.0 * turn, 5.0 * x, -5.0 * y};
  return c;
}

struct Thrown {
  double given = 0.0, lost = 0.0, patches = 0.0, dashpot = 0.0;  // J: by springs of whole bodies, by their dashpots; by points; of the row
  double least = 0.0, kinetic = 0.0, residual = 0.0;             // J: least of both together; before; of the ledger
};

Thrown thrown(unsigned seed, double damping) {
  const cases::Case c = thrown_brick(seed, damping);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  sim.step({false, true});
  Thrown t;
  t.kinetic = sim.energy().kinetic;
  const solver::Overlaps& o = sim.world().overlaps;
  while (sim.time() < 0.25) {
    sim.step({false, sim.steps() % 50 == 0});
    t.least = std::min(t.least, o.impact + o.dashpots);
  }
  sim.step({false, true});
  for (const auto& p : sim.world().patches.patch) t.patches += p.impact;
  t.given = -o.impact, t.lost = o.dashpots, t.dashpot = sim.energy().dashpot, t.residual = sim.energy().residual;
  return t;
}

}  // namespace

TEST_CASE("springs of whole bodies and their dashpots together give out nothing") {
  int met = 0, gave = 0;
  for (unsigned seed = 1; seed < 25; ++seed) {
    const Thrown t = thrown(seed, cases::Case{}.contact.damping);
    CAPTURE(seed);
    CHECK(t.least > -1e-6 * t.kinetic);
    CHECK(t.residual < 1e-3);
    met += t.lost > 0.0 ? 1 : 0, gave += t.given > 1e-3 * t.kinetic ? 1 : 0;
  }
  CHECK(met > 10);
  CHECK(gave > 1);
}

TEST_CASE("what springs of whole bodies give out without dashpots of their own is residual, whatever else is lost") {
  int gave = 0;
  for (unsigned seed = 1; seed < 25; ++seed) {
    const Thrown t = thrown(seed, 0.0);
    CAPTURE(seed);
    CHECK(t.lost == 0.0);
    CHECK(t.dashpot == doctest::Approx(t.patches + std::max(0.0, -t.given)).epsilon(1e-9));
    if (t.given < 1e-3 * t.kinetic) continue;
    ++gave;
    CHECK(t.residual * t.kinetic > 0.8 * t.given);
  }
  CHECK(gave > 1);
}
