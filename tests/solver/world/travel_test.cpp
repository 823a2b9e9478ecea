// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/travel.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "solver/run/run.h"
#include "solver/state/field_table.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

// Bricks come loose one after the other and fall on others: batches are active from many different steps on.
TEST_CASE("velocity rows that are read are those of this step, whether their batch was active or not") {
  const cases::Case c = small_wall(60, 4, 4.0);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion shaking = strong_shaking();
  for (const bool reference : {false, true}) {
    solver::Options o;
    o.reference_kernels = reference;
    solver::Simulation when_looked_at(c, m, shaking, o), always(c, m, shaking, o);
    for (std::int32_t e = 0; e < always.world().elements.rows; e += kernels::kBatch)
      always.world().travel.activate(always.world().elements, e);
    const auto active = [&] { return std::ranges::count(when_looked_at.world().travel.active(), 1); };
    int unlike = 0, times = 0;
    auto before = active();
    for (int i = 0; i < 1500; ++i) {
      const solver::Due due{false, i % 10 == 0};
      when_looked_at.step(due), always.step(due);
      unlike += when_looked_at.energy().strain != always.energy().strain || when_looked_at.energy().contact != always.energy().contact;
      times += active() != before;
      before = active();
    }
    CHECK(unlike == 0);
    CHECK(solver::state_hash(when_looked_at.world()) == solver::state_hash(always.world()));
    CHECK(always.damage().tension > 100);
    CHECK(!always.world().contacts.active.empty());
    if (!reference) CHECK(times > 3);
  }
}

TEST_CASE("no batch of a whole wall is active") {
  const cases::Case c = small_wall(4, 8, 1000.0);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  for (int i = 0; i < 100; ++i) sim.step({});
  CHECK(std::ranges::count(sim.world().travel.active(), 0) == std::ssize(sim.world().travel.active()));
}

TEST_CASE("a batch that is activated has the velocity rows of all its elements at once") {
  const cases::Case c = small_wall(60, 4, 1000.0);
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, strong_shaking(), {});
  for (int i = 0; i < 50; ++i) sim.step({});
  solver::Elements& e = sim.world().elements;
  constexpr std::int32_t kOne = kernels::kBatch + 3;
  solver::Travel& travel = sim.world().travel;
  REQUIRE(!travel.is_active(kOne));
  travel.activate(e, kOne);
  CHECK(travel.is_active(kOne));
  for (std::int32_t i = kernels::kBatch; i < 2 * kernels::kBatch; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const kernels::Twist row = kernels::load_twist(e.twist.data(), i);
    CHECK(row.v == Vec3{e.vx[k], e.vy[k], e.vz[k]});
    CHECK(row.w == Vec3{e.wx[k], e.wy[k], e.wz[k]});
    CHECK(norm(row.v) > 0.0);
  }
}
