// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_stages.h"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <sstream>

#include "io/app/bench/bench_rows.h"
#include "io/app/bench/bench_table.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "tests/io/results_fixture.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

TEST_CASE("a step is split among its parts for every team; the run goes on and tells its rows") {
  cases::Case c = testing::small_wall(6, 6);
  c.output.ledger_interval = 1e-4, c.output.frame_interval = 1e-4;
  const cases::Model model = cases::build_model(c);
  const io::test::TempFolder folder;
  const std::array counts{1, 2}, steps{40, 40};
  solver::Simulation sim(c, model, {}, {});
  const int threads_before = sim.threads();
  solver::RunState plan;
  plan.shaking = true;
  const std::string results_folder = folder.file("run");
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
    for (const io::StepPart p : {io::StepPart::whole_joints, io::StepPart::assembly, io::StepPart::update, io::StepPart::output}) {
      CHECK(part(p) > 0.0);
    }
    CHECK(part(io::StepPart::contacts) < 0.1 * s.step());
  }
  CHECK(sim.threads() == threads_before);
  CHECK(sim.steps() == plan.steps);
  CHECK(plan.steps >= 2 * 3 * 40);
  CHECK(results.rows()[static_cast<std::size_t>(io::RowTable::frames)] > 10);
  CHECK(results.rows()[static_cast<std::size_t>(io::RowTable::energy)] > 10);
  const solver::ForceTimes then = sim.part_times();
  sim.step({});
  CHECK(sim.part_times() == then);
}

TEST_CASE("the parts of a step add up to its stages; handing out is taken off the joints that do it, no more than they have") {
  //                               search forces damage update ledger output
  const solver::StageTimes stages{0.5, 10.0, 0.25, 3.0, 0.125, 0.0625};
  const solver::ForceTimes forces{4.0, 2.0, 1.0, 0.5};  // whole, damaged, contacts, scatter
  using Part = io::StepPart;
  const auto at = [](const io::StepParts& parts, Part p) { return parts[static_cast<std::size_t>(p)]; };
  const io::StepParts parts = io::parts_of(stages, forces, 2.0, 0.75);
  CHECK(at(parts, Part::whole_joints) == 4.0 - 1.5);
  CHECK(at(parts, Part::damaged_joints) == 2.0 - 0.5);
  CHECK(at(parts, Part::contacts) == 1.0);
  CHECK(at(parts, Part::assembly) == 0.5 + 2.0);
  CHECK(at(parts, Part::waiting) == 10.0 - 7.5);
  CHECK(at(parts, Part::search) == 0.5);
  CHECK(at(parts, Part::damage) == 0.25);
  CHECK(at(parts, Part::update) == 3.0);
  CHECK(at(parts, Part::ledger) == 0.125);
  CHECK(at(parts, Part::output) == 0.0625);
  const io::StepParts most = io::parts_of(stages, forces, 20.0, 0.05);
  CHECK(at(most, Part::whole_joints) == 3.0);
  CHECK(at(most, Part::damaged_joints) == 0.0);
  for (const io::StepParts& p : {parts, most}) {
    CHECK(io::StepSplit{.threads = 1, .parts = p, .work = {}}.step() == doctest::Approx(0.5 + 10.0 + 0.25 + 3.0 + 0.125 + 0.0625));
  }
}

TEST_CASE("rates are work over time, shares those over what the machine can do; what is not known stays empty") {
  io::StepSplit split;
  split.threads = 2;
  split.parts[static_cast<std::size_t>(io::StepPart::update)] = 3e-3;
  split.parts[static_cast<std::size_t>(io::StepPart::ledger)] = 1e-3;
  split.work.update = {6e7, 3e6};
  const std::vector<io::Cells> rows = io::stage_rows(split, {80e9, 4e9});
  REQUIRE(rows.size() == io::kStepPartNames.size() + 1);
  CHECK(rows[static_cast<std::size_t>(io::StepPart::update)] == io::Cells{"2", "update", "3.0000", "0.750", "20.0", "0.25", "1.0", "0.25"});
  CHECK(rows[static_cast<std::size_t>(io::StepPart::ledger)] == io::Cells{"2", "ledger", "1.0000", "0.250", "", "", "", ""});
  CHECK(rows[static_cast<std::size_t>(io::StepPart::contacts)] == io::Cells{"2", "contacts", "0.0000", "0.000", "", "", "", ""});
  CHECK(rows.back() == io::Cells{"2", "step", "4.0000", "1.000", "", "", "", ""});
  for (const io::Cells& row : rows) CHECK(row.size() == io::stage_header().size());
}

TEST_CASE("a table is on the disk row by row, and a file is replaced only if asked for") {
  const io::test::TempFolder folder;
  const std::string path = folder.file("table.csv");
  const auto text = [&] {
    std::ostringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  };
  const auto output = [](const std::string& file, bool overwrite) { return io::Output{file, io::FileKind::table, "--csv", overwrite}; };
  io::refuse_to_replace(output(path, false));  // nothing there
  io::BenchTable table({"who", "what"}, output(path, false));
  io::Cells cells{"a"};
  io::put(cells, "%.2f", 1.0 / 3.0);
  table.add(cells);
  table.add({"b", ""});
  CHECK(text() == "who,what\na,0.33\nb,\n");
  CHECK_THROWS_AS(io::refuse_to_replace(output(path, false)), io::FileError);
  io::refuse_to_replace(output(path, true));
  const io::BenchTable other({"new", "row"}, output(path, true));
  CHECK(text() == "new,row\n");
  CHECK_THROWS_AS(io::BenchTable({"new"}, output(folder.file("none/table.csv"), true)), io::FileError);
}
