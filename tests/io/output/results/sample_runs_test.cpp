// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/sample_runs.h"

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "io/app/commands/summary_command.h"
#include "io/app/session/session.h"
#include "io/output/assess/assess_words.h"
#include "io/output/measures/building/building.h"
#include "io/output/replay/run_file.h"
#include "io/output/report/paraview_files.h"
#include "io/output/report/report_data.h"
#include "io/output/results/case_of_run.h"
#include "io/output/results/comparison.h"
#include "tests/io/results_fixture.h"

/// Results of every schema_version are read by every reader (tests/io/samples/README.md).
namespace voussoir::io {
namespace {

using test::TempFolder;
using Json = nlohmann::json;

void write_sample(const std::string& path, int schema) {
  const std::vector<std::byte> bytes = test::sample_run(schema);
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

TEST_CASE("a run of each schema: its measures are those of the newest") {
  const TempFolder dir;
  const std::string path = dir.file("run.h5");
  for (int schema = kOldestSchema; schema <= kResultsSchema; ++schema) {
    CAPTURE(schema);
    REQUIRE(test::has_sample(schema));
    write_sample(path, schema);
    const Hdf5File run = open_run(dir.path());
    CHECK(run.attribute_int("/", "schema_version") == schema);
    const Json summary = Json::parse(summary_json(run));
    CHECK(summary["damage_grade"] == 4);
    CHECK(summary["finished"] == 1);
    CHECK(summary["end_time"].get<double>() == doctest::Approx(0.3).epsilon(1e-3));
    CHECK(summary["walls"].size() == 4);
    CHECK(summary["walls"][0]["name"] == "front wall");
    CHECK(summary["peak_drift"].get<double>() == doctest::Approx(0.356).epsilon(0.01));
    CHECK(check_run(dir.path()) == 1);
  }
}

TEST_CASE("a run of each schema: assess, report, paraview, compare") {
  const TempFolder dir;
  const std::string path = dir.file("run.h5"), newest = dir.file("newest.h5");
  write_sample(newest, test::kSampleSchemas);
  for (int schema = kOldestSchema; schema <= test::kSampleSchemas; ++schema) {
    CAPTURE(schema);
    write_sample(path, schema);
    {
      const Hdf5File run = open_run(path);
      const cases::Case c = case_of_run(run);
      const Building building = building_of(run);
      const Assessment a = assess(run, c, building, std::nullopt, {});
      const cases::GroundMotion base = base_of_run(run, c);
      const Json said = Json::parse(assessment_json(a, floor_accelerations(run, history_names(c), base), base));
      CHECK(said["walls"].size() == 4);
      CHECK(a.weight == doctest::Approx(1611.48).epsilon(1e-4));
    }
    CHECK(report_html({path}).size() > 100'000);
    CHECK(report_html({path}).find("id=\"live\"") == std::string::npos);
    CHECK(live_html(path, 7.5).find("<script type=\"application/json\" id=\"live\">7.5</script>") != std::string::npos);
    CHECK_NOTHROW(write_paraview(dir.path(), true));
    CHECK(compare_files(path, path).differing == 0);
    CHECK((compare_files(path, newest).differing == 0) == (schema == test::kSampleSchemas));
  }
}

}  // namespace voussoir::io
