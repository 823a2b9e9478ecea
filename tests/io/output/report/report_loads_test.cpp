// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_loads.h"

#include <nlohmann/json.hpp>

#include "io/output/replay/frame_reader.h"
#include "tests/io/output/measures/hut.h"

// Loads in run.h5 and as arrows on the page: where each acts, and how large it is, at the moment shown.

namespace voussoir::io {
namespace {

using namespace test;

const std::string kLoaded = std::string(kHut) + R"(
[[load]]
at    = [0.7, -1.0, 0.25]
force = [0.0, 500.0, 0.0]
ramp  = [0.1, 0.3]
[[load]]
path  = "way.csv"
force = [0.0, 0.0, -2000.0]
[[load]]
at      = [0.3, -1.0, 0.25]
force   = [0.0, 100.0, 0.0]
follows = true
)";

}  // namespace

TEST_CASE("the page has each load where it acts then, as large as it is then") {
  const cases::Case c = read_case({"hut.toml", kLoaded}).value;
  cases::Model model = cases::build_model(c);
  cases::SupportHistory& way = model.support_motions[static_cast<std::size_t>(model.load_path[1])];
  way.time = {0.0, 0.4}, way.displacement = {{0.3, 0.1, 2.0}, {1.1, 0.1, 2.0}};
  TempFolder folder;
  {
    ResultsOptions options = by_hand();
    options.motion = load_datasets(c, model);
    ResultsWriter results(folder.path(), model, kLoaded, kNames, {}, options);
    const std::size_t n = model.blocks.size();
    std::vector<float> stays(3 * n), upright, turned;
    for (std::size_t e = 0; e < n; ++e) {
      upright.insert(upright.end(), {1, 0, 0, 0});
      turned.insert(turned.end(), {0.70710678F, 0, 0, 0.70710678F});  // a quarter about z
    }
    results.frame({0.0, stays, upright, std::vector<float>(n)});
    results.frame({0.2, stays, upright, std::vector<float>(n)});
    results.frame({0.5, stays, turned, std::vector<float>(n)});
    results.finish();
  }
  const Hdf5File file = Hdf5File::open(folder.file("run.h5"));
  const auto page = nlohmann::json::parse(report_loads(file, FrameReader(file)));
  REQUIRE(page.size() == 3);
  const auto number = [&](std::size_t load, std::size_t frame, std::size_t i) { return page[load]["frames"][frame][i].get<double>(); };
  CHECK(page[0]["name"] == "load 1");
  CHECK(page[0]["frames"][0].is_null());  // before its ramp
  CHECK(number(0, 1, 1) == doctest::Approx(0.7));
  CHECK(number(0, 1, 2) == doctest::Approx(0.0));  // the face that it meets
  CHECK(number(0, 1, 5) == doctest::Approx(250.0));
  CHECK(number(0, 2, 5) == doctest::Approx(500.0));
  CHECK(number(1, 0, 1) == doctest::Approx(0.3));
  CHECK(number(1, 1, 1) == doctest::Approx(0.7).epsilon(0.02));  // half way
  CHECK(number(1, 2, 1) == doctest::Approx(1.1));
  CHECK(number(1, 1, 6) == doctest::Approx(-2000.0));
  CHECK(number(2, 1, 5) == doctest::Approx(100.0));
  CHECK(number(2, 2, 4) == doctest::Approx(-100.0));  // turned with its element
  CHECK(number(2, 2, 5) == doctest::Approx(0.0));
}

TEST_CASE("a load that grows has the load factor of the analysis; a run without loads has none on its page") {
  const std::string text = std::string(kHut) + "[[load]]\nat = [0.7, -1.0, 0.25]\nforce = [0.0, 500.0, 0.0]\ngrows = true\n";
  std::string whole = text + "[analysis]\nkind = \"pushover\"\npattern = \"given\"\n";
  const cases::Case c = read_case({"hut.toml", whole}).value;
  const cases::Model model = cases::build_model(c);
  TempFolder folder;
  {
    ResultsOptions options = by_hand();
    options.motion = load_datasets(c, model);
    ResultsWriter results(folder.path(), model, whole, kNames, {}, options);
    const std::size_t n = model.blocks.size();
    std::vector<float> stays(3 * n), upright;
    for (std::size_t e = 0; e < n; ++e) upright.insert(upright.end(), {1, 0, 0, 0});
    for (const double t : {0.0, 0.1}) {
      solver::AssessmentRow row;
      row.time = t, row.factor = 10 * t;
      results.assessment(row);
      results.frame({t, stays, upright, std::vector<float>(n)});
    }
    results.finish();
  }
  const Hdf5File file = Hdf5File::open(folder.file("run.h5"));
  const auto page = nlohmann::json::parse(report_loads(file, FrameReader(file)));
  CHECK(page[0]["frames"][0].is_null());
  CHECK(page[0]["frames"][1][5].get<double>() == doctest::Approx(500.0));  // a factor of 1

  Hut hut;
  hut.frame(0.0, stays);
  hut.measures();
  const Hdf5File without = Hdf5File::open(hut.file());
  CHECK(report_loads(without, FrameReader(without)).empty());
  CHECK(load_datasets(read_case({"hut.toml", kHut}).value, hut.model()).empty());
}

}  // namespace voussoir::io
