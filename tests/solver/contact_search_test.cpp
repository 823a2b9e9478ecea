// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "solver/contact_forces.h"
#include "solver/run.h"
#include "solver/saved_state.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A patch, whatever its place in the list (those that were never joined aside), and an element that it may touch.
using Pair = std::tuple<std::int32_t, bool, std::int32_t>;

std::set<Pair> pairs(const solver::World& w) {
  std::set<Pair> all;
  const solver::Contacts& c = w.contacts;
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    const auto p = static_cast<std::size_t>(c.active[a]);
    if (w.patches.from_side[p] < 0) continue;
    for (std::int64_t s = c.first_slot[a]; s < c.first_slot[a + 1]; ++s) {
      all.emplace(w.patches.from_side[p], w.patches.mastered[p] != 0, c.element[static_cast<std::size_t>(s)]);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("at every moment the candidates of searched patches hold all that is near, found by a search of all or of new patches") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  solver::World& w = sim.world();
  const solver::Contacts& contacts = w.contacts;
  int of_new = 0;
  std::size_t near = 0;
  for (int i = 0; i < 5000; ++i) {
    sim.step({});
    sim.cracks().clear();
    const auto active = static_cast<std::int64_t>(contacts.active.size());
    if (contacts.searched < active) {  // bricks that fly ask for a search of all before the ten steps are over
      solver::search_new_patches(w, solver::measure_moves(w, 0, w.elements.rows));
      ++of_new;
    }
    if (i % 20 != 0) continue;
    solver::RunState plan, plan_again;
    solver::Simulation again(c, m, g, {});
    solver::restore(again, plan_again, solver::save(sim, plan));
    again.world().contacts.skin = 1e-5;
    solver::search_contacts(again.world());
    const std::set<Pair> listed = pairs(w);
    for (const Pair& p : pairs(again.world())) {
      INFO("step " << i << ", side " << std::get<0>(p) << ", element " << std::get<2>(p));
      REQUIRE(listed.contains(p));
      ++near;
    }
  }
  CHECK(of_new > 20);
  CHECK(contacts.searches > 20);
  CHECK(near > 500);
  MESSAGE(of_new << " searches of new patches, " << contacts.searches << " of all; " << near << " pairs near each other");
}

TEST_CASE("a search of new patches lists whoever can come near before the next search of all") {
  cases::Case c = small_wall(1, 1);
  const double skin = solver::Simulation(c, cases::build_model(c), {}, {}).world().contacts.skin;
  c.blocks.push_back(brick(0, 1, 0.2 + 0.99 * skin, 0.4));
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  solver::World& w = sim.world();
  const auto between = [&] {  // a face of each against the other
    return std::ranges::count_if(w.contacts.element, [&](std::int32_t e) { return e != w.elements.base; });
  };
  const auto place = [&](double apart) {
    for (const std::int32_t e : {0, 1}) {
      const Vec3 u{e == 0 ? -apart : apart, 0.0, 0.0};
      w.elements.ux[static_cast<std::size_t>(e)] = u.x;
      kernels::store_displacement(w.elements.pose.data(), e, u);
    }
  };
  solver::search_contacts(w);
  REQUIRE(between() == 2);
  const double moved = 0.49 * skin;
  place(moved);
  w.contacts.searched = 0;  // as if their sides had just retired
  solver::search_new_patches(w, moved);
  CHECK(between() == 2);  // both may come back, and as far again: they would touch
  w.contacts.searched = 0;
  solver::search_new_patches(w, 0.4 * skin);
  CHECK(between() == 0);
}

TEST_CASE("a support that begins elsewhere than it settled is looked for in its first step") {
  cases::Case c = small_wall(1, 1);
  c.gravity.settle = true;
  c.blocks.push_back(brick(0, 1, 0.5, 0.7));
  c.blocks.back().fixed = true;
  cases::Model m = cases::build_model(c);
  cases::SupportHistory& elsewhere = m.support_motions.emplace_back();
  elsewhere.time = {-1.0, 1.0}, elsewhere.displacement = {{-0.3, 0.0, 0.0}, {-0.3, 0.0, 0.0}};
  m.blocks[1].support_motion = 0;
  solver::Simulation sim(c, m, {}, {});
  for (int i = 0; i < 3; ++i) sim.step({});
  const solver::Contacts& contacts = sim.world().contacts;
  REQUIRE(contacts.searches == 1);
  sim.start_shaking();
  sim.step({});
  CHECK(contacts.searches == 2);
  CHECK(std::ranges::count(contacts.element, 1) > 0);  // it now stands at the other's end
}
