// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/bench_stages.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <array>
#include <fstream>
#include <sstream>

#include "io/bench_table.h"
#include "io/errors.h"
#include "tests/io/results_fixture.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

TEST_CASE("a step is split among its parts for every team; the run goes on and tells its rows") {
  cases::Case c = testing::small_wall(6, 6);
  c.output.ledger_interval = c.output.frame_interval = 1e-4;
  const cases::Model model = cases::build_model(c);
  const io::test::TempFolder folder;
  const std::array counts{1, 2}, steps{40, 40};
  const int threads_before = omp_get_max_threads();
  for (const bool gather : {false, true}) {
    solver::Options options;
    options.gather = gather;
    solver::Simulation sim(c, model, {}, options);
    solver::RunState plan;
    plan.shaking = true;
    const std::string results_folder = folder.file(gather ? "gather" : "colour");
    std::filesystem::create_directory(results_folder);
    io::ResultsWriter results(results_folder, model, "", {}, io::provenance(0));
    const std::vector<io::StepSplit> splits = io::split_steps({c, sim, plan, results}, counts, steps, 3);
    REQUIRE(splits.size() == counts.size());
    for (std::size_t k = 0; k < splits.size(); ++k) {
      const io::StepSplit& s = splits[k];
      const auto part = [&](io::StepPart p) { return s.parts[static_cast<std::size_t>(p)]; };
      CHECK(s.threads == counts[k]);
      double sum = 0.0;
      for (const double t : s.parts) {
        CHECK(t >= 0.0);
        sum += t;
      }
      CHECK(s.step() == doctest::Approx(sum));
      for (const io::StepPart p : {io::StepPart::whole_joints, io::StepPart::scatter, io::StepPart::update, io::StepPart::output}) {
        CHECK(part(p) > 0.0);
      }
      CHECK(part(io::StepPart::contacts) < 0.1 * s.step());
    }
    CHECK(sim.steps() == plan.steps);
    CHECK(plan.steps >= 2 * 3 * 40);
    CHECK(results.rows()[static_cast<std::size_t>(io::RowTable::frames)] > 10);
    CHECK(results.rows()[static_cast<std::size_t>(io::RowTable::energy)] > 10);
    const solver::ForceTimes then = sim.part_times();
    sim.step({});
    CHECK(sim.part_times() == then);
  }
  CHECK(omp_get_max_threads() == threads_before);
}

TEST_CASE("a table is on the disk row by row, and a file is replaced only if asked for") {
  const io::test::TempFolder folder;
  const std::string path = folder.file("table.csv");
  const auto text = [&] {
    std::ostringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  };
  io::BenchTable table({"who", "what"}, path, false);
  io::Cells cells{"a"};
  io::put(cells, "%.2f", 1.0 / 3.0);
  table.add(cells);
  table.add({"b", ""});
  CHECK(text() == "who,what\na,0.33\nb,\n");
  CHECK_THROWS_AS(io::BenchTable({"who"}, path, false), io::FileError);
  CHECK(text() == "who,what\na,0.33\nb,\n");
  const io::BenchTable other({"new"}, path, true);
  CHECK(text() == "new\n");
}
