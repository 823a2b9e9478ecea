// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"
#include "io/input/files/whole_file.h"
#include "io/output/report/report_capacity.h"
#include "tests/io/results_fixture.h"

namespace voussoir::io {

using namespace test;

namespace {

/// The rows of a pushover along y: the load grows for two seconds, and falls. \param each  called in each row, with its number
template <class Each>
void push(ResultsWriter& writer, const Each& each) {
  solver::Drive drive;
  drive.frequency = 10.0, drive.pace = 2.0, drive.weight = 100.0;
  writer.drive(drive);
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i, factor = i < 20 ? 0.05 * i : 2.0 - 0.05 * i;
    solver::EnergyRow energy;
    energy.time = t, energy.input = 0.01 * i;
    writer.energy(energy);
    writer.forces({t, {0.0, -100.0 * factor, 0.0}, {}});
    writer.assessment({t, factor, 0.001 * i, 0.002 * i, 0.001 * i, 100.0 * factor, 0.0, 0.0});
    each(i);
  }
}

/// A pushover of the two cubes. \return why the page does not take `limit`, or what it makes of
/// it \param pipe  in place of the file
std::string opinion_on(const std::string& limit, bool pipe = false) {
  const TempFolder folder;
  ResultsWriter writer(folder.path(), two_cubes(), std::string(kCase) + "\n[analysis]\nkind = \"pushover\"\ndirection = [0.0, 2.0]\n",
                       kNames, {}, by_hand());
  record(writer, 0);
  push(writer, [](int) {});
  writer.finish();
  if (!limit.empty()) write_text_file(folder.file("limit.json"), limit);
  if (pipe) REQUIRE(::mkfifo(folder.file("limit.json").c_str(), 0600) == 0);
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const LoadedCase c = read_case({"case.toml", run.attribute_text("/case", "toml")});
  std::vector<page::Plot> plots;
  try {
    return report_capacity(run, &c.value, plots).value_or("");
  } catch (const FileError& e) {
    return std::string("refused: ") + e.what();
  }
}

/// The plots of a pushover along y of the two cubes, which move together, with and without a demand.
std::vector<page::Plot> plots_under(const std::string& demand) {
  const TempFolder folder;
  ResultsWriter writer(folder.path(), two_cubes(),
                       std::string(kCase) + "\n[analysis]\nkind = \"pushover\"\ndirection = [0.0, 2.0]\n" + demand, kNames, {}, by_hand());
  push(writer, [&](int i) {
    const auto y = static_cast<float>(0.001 * i);
    writer.frame(
        {0.1 * i, std::array<float, 6>{0, y, 0, 0, y, 0}, std::array<float, 8>{1, 0, 0, 0, 1, 0, 0, 0}, std::array<float, 2>{0, 0}});
  });
  writer.finish();
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  std::vector<page::Plot> plots;
  report_capacity(run, nullptr, plots);
  return plots;
}

std::string limit_of(const std::string& title, const std::string& direction, int mortar) {
  return "{\"title\": \"" + title + "\", \"direction\": " + direction + R"(, "cone_error": 0.076, "converged": true, "mortar_joints": )" +
         std::to_string(mortar) + R"(, "associated": {"multiplier": 0.21}, "coulomb": {"multiplier": 0.19}})";
}

}  // namespace

TEST_CASE("limit analysis stands beside a pushover as a second opinion, with the reasons why they may differ") {
  const std::string title = "two cubes", y = "[0.0, 1.0, 0.0]", with = opinion_on(limit_of(title, y, 7));
  CHECK(with.find("\"limit\":{\"associated\":0.21,\"coulomb\":0.19,") != std::string::npos);
  CHECK(with.find("strength of 7 joints") != std::string::npos);
  CHECK(with.find("off by up to 7.6 %") != std::string::npos);
  CHECK(opinion_on(limit_of(title, y, 0)).find("Mortar") == std::string::npos);
  CHECK(opinion_on("").find("\"limit\":null") != std::string::npos);
  CHECK(opinion_on(limit_of(title, "[1.0, 0.0, 0.0]", 7)).find("limit.json: is of another direction than the run") != std::string::npos);
  CHECK(opinion_on(limit_of("a wall", y, 7)).find("limit.json: is of another case, \"a wall\"") != std::string::npos);
  for (const char* text : {"{", "[1, 2]", R"({"title": "two cubes"})"})
    CHECK(opinion_on(text).find("limit.json: is not what `voussoir limit CASE --format json` writes") != std::string::npos);
}

TEST_CASE("limit.json is what the program writes in every member that the page shows, and a regular file") {
  const std::string good = limit_of("two cubes", "[0.0, 1.0, 0.0]", 7);
  const auto with = [&](const std::string& old, const std::string& put) {
    const std::size_t at = good.find(old);
    REQUIRE(at != std::string::npos);
    return opinion_on(std::string(good).replace(at, old.size(), put));
  };
  CHECK(with("0.21", "null").find("\"associated\":null") != std::string::npos);
  CHECK(with("{\"multiplier\": 0.19}", "null").find("\"coulomb\":null") != std::string::npos);
  CHECK(with("\"mortar_joints\": 7", "\"mortar_joints\": 4294967297").find("strength of 4294967297 joints") != std::string::npos);
  const std::string refusal = "limit.json: is not what `voussoir limit CASE --format json` writes";
  CHECK(with("{\"multiplier\": 0.21}", "{}").find(refusal) != std::string::npos);
  CHECK(with("0.21", "\"<b>\"").find(refusal) != std::string::npos);
  CHECK(with("\"mortar_joints\": 7", "\"mortar_joints\": 1e300").find(refusal) != std::string::npos);
  CHECK(with("\"mortar_joints\": 7", "\"mortar_joints\": -1").find(refusal) != std::string::npos);
  CHECK(with("[0.0, 1.0, 0.0]", "[0.0, 1.0]").find(refusal) != std::string::npos);
  CHECK(with("0.076", "\"\"").find(refusal) != std::string::npos);
  CHECK(opinion_on("", true).find("limit.json: is not a regular file") != std::string::npos);
}

TEST_CASE("capacity and demand stand in one diagram, where there is a demand") {
  const auto titled = [](const std::vector<page::Plot>& plots) {
    return std::ranges::find_if(plots, [](const page::Plot& p) { return p.title == "Capacity and demand"; });
  };
  const std::vector<page::Plot> plots = plots_under("demand = \"ec8:1:B:0.1g\"\n"), without = plots_under("");
  CHECK(titled(without) == without.end());
  const auto plot = titled(plots);
  REQUIRE(plot != plots.end());
  CHECK(plot->lines.at(0).name == "demand, ec8:1:B:0.1g");
  CHECK(plot->lines.at(1).name == "bilinear, EC 8");
  REQUIRE_FALSE(plot->points.empty());
  // The cubes go alike: Γ is 1, and acceleration times their mass is the base shear.
  const auto most = std::ranges::max_element(plots[0].curves.at(0).y), here = std::ranges::max_element(plot->curves.at(0).y);
  CHECK(1e3 * *most / *here == doctest::Approx(1e3 * plots[0].curves.at(0).y.at(5) / plot->curves.at(0).y.at(5)));
  CHECK(plot->x->values.back() == doctest::Approx(plots[0].x->values.back()).epsilon(1e-4));
  // On the spectrum: S_e on its plateau is 2.5 · 1.2 · 0.1 g.
  CHECK(*std::ranges::max_element(plot->lines[0].y) == doctest::Approx(2.5 * 1.2 * 0.980665));
}

}  // namespace voussoir::io
