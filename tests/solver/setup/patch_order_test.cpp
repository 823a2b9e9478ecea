// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/patch_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "solver/contact/contact_forces.h"
#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

bool in_order(const solver::Patches& p) {
  return std::ranges::is_sorted(p.patch, {}, [](const kernels::Patch& k) { return k.element; });
}

/// Retires all sides, the last first: their patches come in no order of elements.
void take_apart(solver::World& w) {
  for (std::int64_t id = w.sides.count(); id-- > 0;) {
    if (w.sides.joint[static_cast<std::size_t>(id)] >= 0) solver::retire_side(w, static_cast<std::int32_t>(id));
  }
  solver::list_live_blocks(w);
}

/// A number that a patch and its points bear, whatever their place: of its element, its face and the side it comes from.
double stamp(const solver::Patches& p, std::size_t i) {
  return p.patch[i].element + 1e-3 * p.patch[i].face + 1e-8 * (2 * p.from_side[i] + p.mastered[i]);
}

double& crushed_of(solver::Patches& p, std::size_t i, int k) { return p.points(static_cast<std::int64_t>(i)).crushed[k]; }
double& pressed_of(solver::Patches& p, std::size_t i, int k) { return p.points(static_cast<std::int64_t>(i)).pressed[k]; }

}  // namespace

TEST_CASE("free patches sorted by element keep what is theirs, and a state that holds them is restored") {
  cases::Case c = small_wall(4, 8);
  c.contact.compression = 2e4, c.contact.residual_compression = 4e3, c.contact.crushing_energy = 2.0, c.contact.crushing_depth = 2e-3;
  c.contact.restitution = 0.5;
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  solver::World& w = sim.world();
  CHECK(in_order(w.patches));
  take_apart(w);
  CHECK_FALSE(in_order(w.patches));
  solver::Patches& p = w.patches;
  const std::size_t count = p.patch.size();
  for (std::size_t i = 0; i < count; ++i) {
    p.patch[i].stored = stamp(p, i);
    for (int k = 0; k < w.points.count[static_cast<std::size_t>(p.patch[i].set)]; ++k) {
      p.points(static_cast<std::int64_t>(i)).set_slip(k, {stamp(p, i) + k, 0.0, 0.0});
      crushed_of(p, i, k) = 2.0 * stamp(p, i) + k, pressed_of(p, i, k) = 3.0 * stamp(p, i) + k;
    }
  }
  solver::sort_patches(w);
  REQUIRE(p.patch.size() == count);
  CHECK(in_order(p));
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(p.patch[i].stored == stamp(p, i));
    for (int k = 0; k < w.points.count[static_cast<std::size_t>(p.patch[i].set)]; ++k) {
      CHECK(p.points(static_cast<std::int64_t>(i)).slip(k).x == stamp(p, i) + k);
      CHECK(crushed_of(p, i, k) == 2.0 * stamp(p, i) + k);
      CHECK(pressed_of(p, i, k) == 3.0 * stamp(p, i) + k);
    }
  }
  solver::search_all(w);
  solver::RunState plan, plan_again;
  const solver::SavedState saved = solver::save(sim, plan);
  solver::Simulation again(c, m, {}, {});
  solver::restore(again, plan_again, saved);
  for (const auto& entry : solver::save(again, plan_again)) CHECK_MESSAGE(entry.second.bytes == saved.at(entry.first).bytes, entry.first);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(again.world().patches.patch[i].element == p.patch[i].element);
    CHECK(again.world().patches.patch[i].face == p.patch[i].face);
    CHECK(again.world().patches.patch[i].set == p.patch[i].set);
  }
}
