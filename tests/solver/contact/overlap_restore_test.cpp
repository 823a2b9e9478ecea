// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "tests/solver/rods.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Two crossed rods press on each other by their edges; a third body falls far from them, so that searches are due that are not theirs.
cases::Case crossed_rods_and_one_that_falls() {
  cases::Case c = small_wall(1, 1);
  c.base = std::nullopt;
  c.blocks = {rod(false, 0.0), rod(true, 2.0 * kHalfDiagonal + 0.0001), brick(2, 0, 5.0, 5.2)};
  c.blocks[0].fixed = true, c.blocks[1].free = c.blocks[2].free = true;
  c.blocks[2].velocity = {0.0, 0.0, -10.0};
  return c;
}

}  // namespace

TEST_CASE("a state restored where a search is due keeps the springs of bodies that overlap and are not searched again") {
  const cases::Case c = crossed_rods_and_one_that_falls();
  const cases::Model m = cases::build_model(c);
  solver::Simulation straight(c, m, {}, {});
  solver::RunState plan;
  int tried = 0;
  while (straight.time() < 0.1) {
    const solver::SavedState before = solver::save(straight, plan);
    const bool pressed = !straight.world().overlaps.springs.empty();
    const std::int64_t searches = straight.world().contacts.searches;
    straight.step({});
    if (!pressed || straight.world().contacts.searches == searches) continue;
    ++tried;
    solver::Simulation restored(c, m, {}, {});
    solver::RunState again;
    solver::restore(restored, again, before);
    for (const solver::OverlapPair& pair : restored.world().overlaps.pairs) {
      CHECK(restored.world().travel.is_active(pair.a));
      CHECK(restored.world().travel.is_active(pair.b));
    }
    restored.step({});
    const solver::SavedState a = solver::save(straight, plan), b = solver::save(restored, again);
    for (const auto& [name, field] : a) {
      CAPTURE(name);
      CHECK(field.bytes == b.at(name).bytes);
    }
  }
  CHECK(tried >= 3);
}
