// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "solver/contact/contact_forces.h"
#include "solver/run/run.h"
#include "solver/state/saved_state.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A patch, whatever its place in the list (those that were never joined aside), and an element that it may touch.
using Pair = std::tuple<std::int32_t, bool, std::int32_t>;

/// \param from  active patch; before it none counts
std::set<Pair> pairs(const solver::World& w, std::int64_t from = 0) {
  std::set<Pair> all;
  const solver::Contacts& c = w.contacts;
  for (auto a = static_cast<std::size_t>(from); a < c.active.size(); ++a) {
    const auto p = static_cast<std::size_t>(c.active[a]);
    if (w.patches.from_side[p] < 0) continue;
    for (std::int64_t s = c.first_slot[a]; s < c.first_slot[a + 1]; ++s) {
      all.emplace(w.patches.from_side[p], w.patches.mastered[p] != 0, c.element[static_cast<std::size_t>(s)]);
    }
  }
  return all;
}

/// \param multirate  with several rates elements have reaches of their own
void check_that_near_pairs_are_listed(int multirate) {
  CAPTURE(multirate);
  cases::Case c = small_wall(4, 8);
  c.time.multirate = multirate;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  solver::World& w = sim.world();
  const solver::Contacts& contacts = w.contacts;
  std::size_t near = 0, far_reaching = 0;
  for (int i = 0; i < 5000; ++i) {
    sim.step({});
    sim.cracks().clear();
    if (i % 20 != 0) continue;
    for (std::int32_t e = 0; e < w.elements.count; ++e) far_reaching += w.travel.reach(e) > 0.6 * w.travel.skin();
    solver::RunState plan, plan_again;
    solver::Simulation again(c, m, g, {});
    solver::restore(again, plan_again, solver::save(sim, plan));
    again.world().travel = solver::Travel(again.world().elements, 1e-5);
    solver::search_all(again.world());
    const std::set<Pair> listed = pairs(w), only_origin = pairs(w, contacts.searched);  // of sides that came apart ten steps ago at most
    const auto is_new = [&](const Pair& p) {
      return std::ranges::any_of(only_origin,
                                 [&](const Pair& q) { return std::get<0>(p) == std::get<0>(q) && std::get<1>(p) == std::get<1>(q); });
    };
    for (const Pair& p : pairs(again.world())) {
      if (is_new(p)) continue;
      INFO("step " << i << ", side " << std::get<0>(p) << ", element " << std::get<2>(p));
      REQUIRE(listed.contains(p));
      ++near;
    }
  }
  CHECK(contacts.searches > (multirate == 1 ? 100 : 50));
  CHECK(near > 300);
  CHECK((far_reaching > 500) == (multirate > 1));
  MESSAGE(contacts.searches << " searches; " << near << " pairs near each other; reaches beyond the skin's half: " << far_reaching);
}

}  // namespace

TEST_CASE("at every moment the candidates of searched patches hold all that is near, whoever was searched when") {
  for (const int multirate : {1, 4}) check_that_near_pairs_are_listed(multirate);
}

TEST_CASE("a search lists whoever can come near before one of the two is searched again") {
  cases::Case c = small_wall(1, 1);
  const double skin = solver::Simulation(c, cases::build_model(c), {}, {}).world().travel.skin();
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
  solver::search_all(w);
  w.travel.set_searched();
  REQUIRE(between() == 2);
  place(0.17 * skin);       // counts as 0.24, for it may have turned too
  w.contacts.searched = 0;  // as if their sides had just retired
  solver::search_contacts(w);
  CHECK(between() == 2);  // both may come back, and go on by half the skin: they would touch
  place(0.26 * skin);
  solver::search_contacts(w);
  CHECK(between() == 0);  // where they are now is where they count from
  place(0.0);
  solver::search_contacts(w);
  CHECK(between() == 2);
}

TEST_CASE("with several rates a search lists whom a fast element may come to in 10 ms, and waits until it has come half of that way") {
  cases::Case c = small_wall(1, 1);
  const double skin = solver::Simulation(c, cases::build_model(c), {}, {}).world().travel.skin();
  c.time.multirate = 2;
  c.blocks.push_back(brick(0, 1, 0.2 + 0.5 * skin + 0.029, 0.5));
  const cases::Model m = cases::build_model(c);
  for (const double speed : {0.0, 3.0}) {
    CAPTURE(speed);
    solver::Simulation sim(c, m, {}, {});
    solver::World& w = sim.world();
    w.elements.vx[0] = speed;
    solver::search_all(w);
    const auto between = std::ranges::count_if(w.contacts.element, [&](std::int32_t e) { return e != w.elements.base; });
    CHECK(between == (speed > 0.0 ? 2 : 0));
    CHECK(w.travel.reach(0) == doctest::Approx(speed > 0.0 ? 0.03 : 0.5 * skin));
    CHECK(w.travel.reach(1) == 0.5 * skin);
    w.elements.ux[0] = 0.6 * skin / std::sqrt(2.0);  // counts as 0.6 skin, for it may have turned too
    CHECK((w.travel.displacement_over_limit(w.elements, 0) > 0.0) == (speed == 0.0));
    const std::int64_t searches = w.contacts.searches;
    solver::search_contacts(w);
    CHECK(w.contacts.searches == searches + 1);
    CHECK((w.travel.searched_pose(0).u.x > 0.0) == (speed == 0.0 || 0.6 * skin > 0.015));
  }
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

TEST_CASE("points that a search takes from a partner far away find another in the same step, though nothing else has moved") {
  cases::Case c = small_wall(1, 0);
  c.blocks = {brick(0, 0, 0.0, 0.19), brick(0, 1, 0.5, 0.7), brick(1, 0, 0.0, 0.2), brick(0, 2, 0.2, 0.3)};
  for (const std::size_t i : {0U, 1U, 3U}) c.blocks[i].fixed = true;
  for (Vec3& corner : *c.blocks[2].box) corner.z += 1e-3;  // in no joint with the first; the last, a tall one, holds it
  (*c.blocks[3].box)[1].z = (*c.blocks[2].box)[1].z;
  cases::Model m = cases::build_model(c);
  const double dt = solver::Simulation(c, m, {}, {}).dt();
  cases::SupportHistory& away = m.support_motions.emplace_back();
  away.time = {0.0, dt, 2.0 * dt}, away.displacement = {{}, {}, {-0.4, 0.0, 0.0}};
  m.blocks[0].support_motion = 0;
  solver::Simulation sim(c, m, {}, {});
  solver::World& w = sim.world();
  const auto place = [&](std::int32_t e, Vec3 u) {
    const auto i = static_cast<std::size_t>(e);
    w.elements.ux[i] = u.x, w.elements.uy[i] = u.y, w.elements.uz[i] = u.z;
    kernels::store_displacement(w.elements.pose.data(), e, u);
  };
  place(1, {-0.505, 0.0, -1e-4});  // where the first is, 0.1 mm lower
  place(2, {0.0, 0.0, -1.2e-3});
  const auto partners = [&] {  // of the points of the upper brick
    std::set<std::int32_t> all;
    for (std::size_t p = 0; p < w.patches.patch.size(); ++p) {
      const solver::FreePatch& patch = w.patches.patch[p];
      if (patch.element != 2 || patch.touching == 0) continue;
      const kernels::ContactPoints q = w.patches.points(static_cast<std::int64_t>(p));
      all.insert(q.partner, q.partner + w.points.count[static_cast<std::size_t>(patch.set)]);
    }
    return all;
  };
  sim.step({});
  CHECK(partners() == std::set<std::int32_t>{0});
  sim.step({});  // now the first has gone; the next step searches before it looks
  CHECK(partners() == std::set<std::int32_t>{0});
  sim.step({});
  CHECK(w.contacts.searches == 2);
  CHECK(partners() == std::set<std::int32_t>{1});
}
