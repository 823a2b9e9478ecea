// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/memory.h"

#include <doctest/doctest.h>

#include <memory>

#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

// Every feature that needs memory is counted where it is said to be.

using namespace voussoir;

namespace {

constexpr std::size_t kPage = 4096;

cases::Case wall() {
  cases::Case c = testing::small_wall(4, 6);
  return c;
}

struct Built {
  cases::Model model;
  std::unique_ptr<solver::World> world;
  solver::MemoryUse use;
  explicit Built(const cases::Case& c)
      : model(cases::build_model(c)), world(solver::build_world(c, model, {})), use(solver::memory_use(*world)) {}
};

}  // namespace

TEST_CASE("memory: rows of several rates are counted with elements") {
  cases::Case c = wall();
  const Built one(c);
  c.time.multirate = 4;
  const Built four(c);
  const auto rows = static_cast<std::size_t>(four.world->elements.rows);
  const std::size_t of_level = rows * (kernels::kTwistStride + kernels::kWrenchStride + kernels::kDashpotStride) * sizeof(double);
  CHECK(four.use.elements >= one.use.elements + 2 * of_level);
}

TEST_CASE("memory: ties are counted with elements") {
  cases::Case c = wall();
  const Built without(c);
  c.ties.push_back({.name = "rod", .from = {0.0, 0.05, 0.15}, .to = {0.8, 0.05, 0.15}, .area = 1e-4, .young = 2e11});
  const Built with(c);
  CHECK(with.use.elements >= without.use.elements + sizeof(solver::Ties::Tie) + 2 * sizeof(solver::Ties::Hold));
}

TEST_CASE("memory: what softening, crushing and closing keep is counted with sides, segments and patches") {
  const Built plain(wall());
  const auto sides = static_cast<std::size_t>(plain.world->sides.count());
  cases::Case softening = wall();
  softening.joint_laws["mortar"].fracture_energy_tension = 10.0, softening.joint_laws["mortar"].fracture_energy_shear = 50.0;
  CHECK(Built(softening).use.sides >= plain.use.sides + sides * sizeof(kernels::SideLaws));

  cases::Case crushing = wall();
  crushing.contact.compression = 1e6;
  Built crushed(crushing);
  CHECK(crushed.use.sides >= plain.use.sides + sides * sizeof(kernels::SideLaws));
  REQUIRE(crushed.world->patches.crushed.size() > 0);
  CHECK(crushed.use.patches >= plain.use.patches + crushed.world->patches.crushed.size() * sizeof(double));
  crushed.world->sides.law_state.at(0).values[0] = 1e-4;
  CHECK(solver::memory_use(*crushed.world).segments >= crushed.use.segments + kPage);

  cases::Case closing = wall();
  cases::JointLaw dry;
  dry.tension = dry.cohesion = 0.0, dry.maximum_closure = 1e-4, dry.normal_stiffness = 1e9, dry.shear_stiffness = 5e8;
  closing.joint_laws["mortar"] = dry;
  CHECK(Built(closing).use.sides >= plain.use.sides + sides * sizeof(kernels::SideLaws));
}
