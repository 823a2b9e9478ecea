// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/setup_stages.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "solver/state/field_table.h"
#include "solver/state/saved_state.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A wall for which every stage has something to do.
cases::Case busy_wall() {
  cases::Case c = mixed_wall(3, 6);
  c.time.multirate = 2;
  cases::JointLaw& mortar = c.joint_laws["mortar"];
  mortar.fracture_energy_tension = 0.1, mortar.fracture_energy_shear = 0.2;
  c.contact.compression = 2e4;
  c.ties.push_back({.name = "rod", .from = {0.1, 0.05, 0.05}, .to = {0.5, 0.05, 0.55}, .area = 1e-2, .young = 2e11});
  c.output.cuts.push_back({.name = "bed", .point = {0.3, 0.05, 0.2}, .normal = {0, 0, 1}, .box = {}});
  cases::Load load;
  load.block = "c5_1", load.force = {0.0, 30.0, 0.0};
  c.loads.push_back(load);
  return c;
}

using Stages = std::vector<solver::SetUpStage>;

/// An order that the needs allow, of those that are drawn: whichever stage can come next.
Stages another_order(std::mt19937& random) {
  Stages left(solver::setup_stages().begin(), solver::setup_stages().end()), order;
  std::shuffle(left.begin(), left.end(), random);
  for (std::uint32_t there = 0; !left.empty();) {
    const auto next = std::ranges::find_if(left, [&](const auto& stage) { return (stage.needs & ~there) == 0; });
    REQUIRE(next != left.end());
    there |= next->makes;
    order.push_back(*next);
    left.erase(next);
  }
  return order;
}

}  // namespace

TEST_CASE("set-up: any order that the needs of its stages allow makes the same world") {
  const cases::Case c = busy_wall();
  const cases::Model m = cases::build_model(c);
  const auto usual = solver::build_world(c, m, {});
  REQUIRE(usual->multirate.wanted == 2);
  REQUIRE(usual->ties.tie.size() == 1);
  REQUIRE(usual->ties.tie[0].law.stiffness < 2e9);  // no more than the step allows beside the joints
  REQUIRE(usual->loads.size() == 1);
  REQUIRE(usual->sides.law_state.size() == 2);
  REQUIRE(usual->sides.pair_on.size() > 0);
  std::mt19937 random(7);
  std::set<std::string> orders;
  for (int i = 0; i < 20; ++i) {
    const Stages order = another_order(random);
    std::string names;
    for (const solver::SetUpStage& stage : order) names += std::string(stage.name) + ", ";
    orders.insert(names);
    CAPTURE(names);
    const auto world = solver::build_world(c, m, {}, order);
    CHECK(solver::model_hash(*world) == solver::model_hash(*usual));
    CHECK(solver::state_hash(*world) == solver::state_hash(*usual));
    CHECK(world->travel.skin() == usual->travel.skin());
    CHECK(world->ties.tie[0].law.stiffness == usual->ties.tie[0].law.stiffness);
    for (std::size_t id = 0; id < world->sides.joint.size(); ++id) {
      CHECK((world->sides.laws_of(id).crushing != nullptr) == (usual->sides.laws_of(id).crushing != nullptr));
      CHECK(world->sides.parts[id].points.n == usual->sides.parts[id].points.n);
    }
  }
  CHECK(orders.size() > 10);
}

TEST_CASE("set-up: a list with a stage before what it needs, or with one twice, is seen") {
  struct Stage {
    std::uint32_t needs, makes;
  };
  CHECK(solver::in_order(std::vector<Stage>{{0, 1}, {1, 2}, {3, 4}}));
  CHECK_FALSE(solver::in_order(std::vector<Stage>{{0, 1}, {2, 4}, {1, 2}}));
  CHECK_FALSE(solver::in_order(std::vector<Stage>{{0, 1}, {0, 1}}));
  CHECK(solver::in_order(std::vector<Stage>{{8, 1}}, 8));
}
