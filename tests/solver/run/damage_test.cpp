// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/damage.h"

#include <doctest/doctest.h>

#include <vector>

#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

TEST_CASE("failures by the limit reached first and by what opened the bond are counts of the same segments, and those of the crack rows") {
  const cases::Case c = small_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  std::vector<solver::CrackRow> rows;
  const solver::FirstLimits none = solver::first_limits(sim.world());
  CHECK(none.tension + none.shear + none.compression == 0);
  while (sim.time() < 0.6) {
    sim.step({});
    rows.insert(rows.end(), sim.cracks().begin(), sim.cracks().end());
    sim.cracks().clear();
  }
  const solver::FirstLimits first = solver::first_limits(sim.world());
  const solver::Damage& by = sim.damage();
  CHECK(first.tension + first.shear + first.compression == by.tension + by.shear + by.compression + by.slipped);
  solver::FirstLimits of_rows;
  std::int64_t slipped_first_opened_in_tension = 0;
  for (const solver::CrackRow& r : rows) {
    const std::int64_t sides = r.element_b < 0 ? 1 : 2;  // all joints of two bricks are merged here
    if (r.first_mode == solver::FailureMode::tension) of_rows.tension += sides;
    if (r.first_mode == solver::FailureMode::shear) of_rows.shear += sides;
    if (r.first_mode == solver::FailureMode::compression) of_rows.compression += sides;
    if (r.first_mode == solver::FailureMode::shear && r.mode == solver::FailureMode::tension) slipped_first_opened_in_tension += sides;
  }
  CHECK(first.tension == of_rows.tension);
  CHECK(first.shear == of_rows.shear + by.slipped);
  CHECK(first.compression == of_rows.compression);
  CHECK(slipped_first_opened_in_tension > 100);  // so the two counts differ
  CHECK(first.tension > 100);
}
