// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/words/headway.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "tests/solver/no_rows.h"
#include "tests/solver/small_wall.h"

// What the line of progress says of analyses by states of rest.
namespace voussoir::io {
namespace {

/// The headway at every tick of a run, up to some state of rest.
std::vector<std::string> followed(const cases::Case& c, const cases::Model& m, std::int64_t states) {
  solver::Simulation sim(c, m, {}, {});
  solver::choose_drive(sim, c);
  solver::RunState plan;
  testing::NoRows out;
  std::vector<std::string> said;
  (void)solver::run(sim, plan, c, c.end(), out, [&](const solver::RunStatus& s) {
    if (!s.settling) said.push_back(headway(sim));
    return s.states < states;
  });
  REQUIRE(!said.empty());
  return said;
}

}  // namespace

TEST_CASE("headway: a settlement tells the movement of its supports, what is wanted, and the time in their histories") {
  cases::Case c;
  c.materials["stone"] = {2000.0, 1e8, 0.2};
  c.analysis.kind = cases::AnalysisKind::settlement, c.analysis.path_step = 0.2, c.analysis.longest = 2.0;
  const Vec3 boxes[][2] = {{{0.0, 0.0, -0.2}, {0.4, 0.4, 0.0}}, {{0.6, 0.0, -0.2}, {1.0, 0.4, 0.0}}, {{0.0, 0.0, 0.0}, {1.0, 0.4, 0.2}}};
  for (std::size_t i = 0; i < 3; ++i) {
    cases::BlockSpec b;
    b.name = std::to_string(i), b.material = "stone", b.box = {{boxes[i][0], boxes[i][1]}}, b.fixed = i < 2;
    if (i == 0) b.motion.emplace().file = "sink.csv";
    c.blocks.push_back(b);
  }
  cases::Model m = cases::build_model(c);
  m.support_motions[0].time = {0.0, 6.1}, m.support_motions[0].displacement = {{}, {0.0, 0.0, -0.03}};
  const std::vector<std::string> said = followed(c, m, 1'000'000);
  CHECK(said.front() == "supports moved by 0.0 of 30.0 mm, 0.00 of 6.1 s of their histories");
  CHECK(said.back() == "supports moved by 30.0 of 30.0 mm, 6.10 of 6.1 s of their histories");
}

TEST_CASE("headway: a pushover tells its displacement, the share of the largest load, and where both end it") {
  cases::Case c = testing::small_wall(3, 4);
  c.gravity.settle = true;
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.direction = {0.0, 1.0};
  c.analysis.drop = 0.3, c.analysis.largest_drift = 0.2;  // of the middle of the uppermost course, 0.35 m up
  const std::vector<std::string> said = followed(c, cases::build_model(c), 4);
  CAPTURE(said.back());
  CHECK(said.back().starts_with("load factor 0."));
  CHECK(said.back().find(" of 70 mm, load ") != std::string::npos);
  CHECK(said.back().find("load 100 % of its largest (ends at 70 %)") != std::string::npos);
}

}  // namespace voussoir::io
