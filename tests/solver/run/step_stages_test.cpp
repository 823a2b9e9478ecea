// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/step_stages.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "solver/analysis/drive.h"
#include "solver/run/simulation.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;
using solver::StepStage;

namespace {

std::size_t number(StepStage s) { return static_cast<std::size_t>(s); }

/// The steps of a run, each compared with the list. \return the stages that came
std::set<StepStage> follow(const cases::Case& c, solver::Options o, int steps) {
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, o);
  solver::choose_drive(sim, c);
  std::vector<StepStage> stages;
  std::set<StepStage> seen;
  sim.world().log.write_to(&stages);
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2 && sim.phase() == solver::Phase::settling) sim.start_shaking();
    if (i == steps / 2 + 1) sim.world().travel.ask_for_search(1);
    stages.clear();
    const bool first = sim.steps() % sim.cycle() == 0;
    sim.step({.sample = first && i % 3 == 0, .ledger = first && i % 2 == 0});
    std::size_t next = 0;
    for (const StepStage s : stages) {
      CHECK(number(s) >= next);  // in the order of the list, none twice
      next = number(s) + 1;
      seen.insert(s);
    }
    const std::set<StepStage> here(stages.begin(), stages.end());
    for (const solver::StepStageEntry& e : solver::kStepStages) {
      CAPTURE(std::string(e.function));
      if (e.always) CHECK(here.contains(e.stage));
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("step: the list of stages has each once, in the order of their numbers") {
  std::size_t next = 0;
  for (const solver::StepStageEntry& e : solver::kStepStages) CHECK(number(e.stage) == next++);
  CHECK(next == number(StepStage::ledger_after) + 1);
}

TEST_CASE("step: steps go through the stages of the list, in its order, and through all of them") {
  cases::Case c = small_wall(3, 6);
  c.time.step = 1e-4;
  c.output.cuts.push_back({.name = "bed", .point = {0.3, 0.05, 0.2}, .normal = {0, 0, 1}, .box = {}});
  solver::Options o;
  o.threads = 2;
  std::set<StepStage> seen = follow(c, o, 40);
  c.gravity.settle = true;
  c.time.multirate = 2;
  seen.merge(follow(c, o, 400));
  c.time.multirate = 1;
  c.analysis.kind = cases::AnalysisKind::tilt, c.analysis.solver = cases::Solver::equilibrium;
  seen.merge(follow(c, o, 20));
  c.analysis.kind = cases::AnalysisKind::rest;
  c.blocks[0].fixed = true, c.blocks[0].motion = cases::SupportMotion{.turn = Vec3{0.1, 0.0, 0.0}};
  seen.merge(follow(c, o, 20));
  for (const solver::StepStageEntry& e : solver::kStepStages) {
    CAPTURE(std::string(e.function));
    CHECK(seen.contains(e.stage));
  }
}

TEST_CASE("step: the picture of its life names the functions of the list, in its order") {
  std::ifstream in(VOUSSOIR_SOURCE_DIR "/solver/LIFE_OF_A_STEP.md");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::size_t at = text.find("known: positions");
  const std::size_t end = text.find("known: x(n+1)");
  REQUIRE(at < end);
  REQUIRE(end != std::string::npos);
  for (const solver::StepStageEntry& e : solver::kStepStages) {
    CAPTURE(std::string(e.function));
    const std::string word = std::string(e.function) + " ";
    do at = text.find(word, at + 1);
    while (at < end && text[at - 1] != ' ' && text[at - 1] != '\n');
    REQUIRE(at < end);
  }
}
