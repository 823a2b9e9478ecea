// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "solver/run/simulation.h"
#include "tests/io/input/stones/stones_fixture.h"
#include "tests/io/shell.h"

// Assemblies that other programs wrote, in ../shared/stones beside the checkout (or where VOUSSOIR_STONES says).

namespace {

using namespace voussoir;

std::string stones_folder() {
  const char* given = std::getenv("VOUSSOIR_STONES");
  return given != nullptr ? given : std::string(VOUSSOIR_SOURCE_DIR) + "/../shared/stones";
}

/// Loads a file with the shortest case, counts its joints by other means, and lets it settle under gravity.
void check_file(const std::string& name, const std::string& keys, std::size_t stones) {
  const std::string path = stones_folder() + "/" + name;
  if (!std::filesystem::exists(path)) {
    MESSAGE("not there, nothing is tested: " << path);
    return;
  }
  CAPTURE(name);
  const auto c = ::stones::load(path, keys, "[gravity]\nramp = 0.5\n[damping]\nalpha = 3.0\n");
  const cases::Model model = cases::build_model(c);
  CHECK(model.blocks.size() == stones);
  const auto counted = shell::run("python3 " + shell::source("tests/io/input/stones/count_joints.py") + " " + shell::quoted(path));
  CHECK(counted.code == 0);
  CHECK(counted.text == std::to_string(model.blocks.size()) + " " + std::to_string(model.assembly.joints.size()) + "\n");
  solver::Options options;
  options.threads = 1;
  solver::Simulation sim(c, model, {}, options);
  while (!sim.at_rest() && !sim.settled_too_long()) sim.step({false, sim.steps() % 20 == 0});
  CHECK(sim.at_rest());
  double most = 0.0;
  const auto& e = sim.world().elements;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) most = std::max(most, std::hypot(e.ux[i], e.uy[i], e.uz[i]));
  MESSAGE(name << ": " << model.assembly.joints.size() << " joints; at rest at " << sim.time() << " s, moved by " << most << " m");
  CHECK(most < 5e-3);  // the arch of 10 m, shortened by its weight; of stone ten times as stiff it moves by a tenth
}

}  // namespace

TEST_CASE("wall.obj: 38 blocks come to rest") { check_file("wall.obj", "", 38); }
TEST_CASE("arch_assembly.json: 30 blocks come to rest") { check_file("arch_assembly.json", "", 30); }
TEST_CASE("wall_assembly.json: 52 blocks come to rest") { check_file("wall_assembly.json", "", 52); }
TEST_CASE("two-blocks_assembly.json: two blocks come to rest") { check_file("two-blocks_assembly.json", "", 2); }
TEST_CASE("ursula.obj: stones that lie in each other by centimetres are refused, the deepest first") {
  const std::string path = stones_folder() + "/ursula.obj";
  if (!std::filesystem::exists(path)) {
    MESSAGE("not there, nothing is tested: " << path);
    return;
  }
  const std::string message = ::stones::refusal(path, "supports = \"ground\"");
  CHECK(message.find("stone \"Mesh 3\" (element 3): overlaps stone \"Mesh 4\" (element 4) by 0.051091 m") != std::string::npos);
  CHECK(message.find("about (0.825") != std::string::npos);
}
