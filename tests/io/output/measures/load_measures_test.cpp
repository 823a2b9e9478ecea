// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/members/load_measures.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/output/measures/measures_file.h"
#include "io/output/measures/members/member_words.h"
#include "io/output/report/report_members.h"
#include "tests/io/output/measures/hut.h"

// Force of a load and displacement of the place where it acts: largest, at the end, as a curve.

namespace voussoir::io {
namespace {

using namespace test;

const std::string kLoaded = std::string(kHut) + R"(
[[load]]
at    = [0.7, -1.0, 0.25]
force = [0.0, 500.0, 0.0]
[[load]]
at    = [0.7, -1.0, 0.25]
force = [0.0, 500.0, 0.0]
[[load]]
path  = "way.csv"
force = [0.0, 0.0, -2000.0]
)";

void row(Hut& hut, double time, const std::array<solver::LoadSample, 3>& loads) {
  hut.results().loads(time, loads);
  hut.results().history(time, std::array<solver::HistorySample, 2>{});
}

void check_near(const page::Values& values, const page::Values& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == doctest::Approx(expected[i]));
}

}  // namespace

TEST_CASE("loads: largest force, displacement of the place along it then, largest displacement, and both at the end") {
  Hut hut(kLoaded);
  const Vec3 nowhere{std::numeric_limits<double>::quiet_NaN(), 0.0, std::numeric_limits<double>::quiet_NaN()}, down{0.0, 0.0, -2e3};
  hut.frame(0.0, stays);
  // The second load is a moment: no force at any time. The third acts nowhere at first.
  row(hut, 0.0, {{{{}, {}}, {{}, {1.0, 0.0, 0.0}}, {{}, nowhere}}});
  row(hut, 0.1, {{{{3e3, 4e3, 0.0}, {3e-3, 4e-3, 9.0}}, {{}, {}}, {down, {0.0, 0.0, -1e-3}}}});
  row(hut, 0.2, {{{{1.5e3, 2e3, 0.0}, {-6e-3, -8e-3, 9.0}}, {{}, {}}, {down, {0.0, 0.0, 2e-3}}}});
  row(hut, 0.3, {{{{0.6e3, 0.8e3, 0.0}, {1.2e-3, 1.6e-3, 9.0}}, {{}, {}}, {{}, nowhere}}});
  const Measures m = hut.measures();
  REQUIRE(m.loads.size() == 2);
  const LoadMeasures &push = m.loads[0], &moving = m.loads[1];
  CHECK(push.name == "load 1");
  CHECK(push.peak_force == doctest::Approx(5e3));
  CHECK(push.peak_force_time == 0.1);
  CHECK(push.displacement_at_peak == doctest::Approx(5e-3));
  CHECK(push.peak_displacement == doctest::Approx(-10e-3));
  CHECK(push.peak_displacement_time == 0.2);
  CHECK(push.force_at_peak_displacement == doctest::Approx(2.5e3));
  CHECK(push.end_force == doctest::Approx(1e3));
  CHECK(push.end_displacement == doctest::Approx(2e-3));
  CHECK(moving.name == "load 3");
  CHECK(moving.peak_force == 2e3);
  CHECK(moving.displacement_at_peak == doctest::Approx(1e-3));
  CHECK(moving.peak_displacement == doctest::Approx(-2e-3));
  CHECK(moving.end_force == 0.0);
  CHECK(std::isnan(moving.end_displacement));
  const std::string words = loads_text(m.loads);
  for (const char* part : {"load 1", "5.00 kN", "5.00 mm", "-10.00 mm", "2.50 kN", "1.00 kN", "load 3", "-2.00 mm"})
    CHECK_MESSAGE(words.find(part) != std::string::npos, part);
  const auto json = nlohmann::json::parse(measures_json(m));
  CHECK(json["loads"][0]["displacement_at_peak_force"].get<double>() == doctest::Approx(5e-3));
  CHECK(json["loads"][1]["end_displacement"].is_null());
  CHECK(loads_text({}).empty());
}

// In other axes, other last digits.
TEST_CASE("loads: a force that turns with its block counts along its first direction") {
  Hut hut(kLoaded);
  hut.frame(0.0, stays);
  const double turned = 0.5, force = 2e3 * (1.0 + 1e-15);
  row(hut, 0.0, {{{{0.0, 2e3, 0.0}, {0.0, 1e-3, 0.0}}, {{}, {}}, {{}, {}}}});
  row(hut, 0.1, {{{{force * std::sin(turned), force * std::cos(turned), 0.0}, {0.0, 3e-3, 0.0}}, {{}, {}}, {{}, {}}}});
  const LoadMeasures load = hut.measures().loads.at(0);
  CHECK(load.peak_force_time == 0.0);
  CHECK(load.displacement_at_peak == doctest::Approx(1e-3));
  CHECK(load.end_displacement == doctest::Approx(3e-3));
  CHECK(load.end_force == doctest::Approx(2e3 * std::cos(turned)));
}

TEST_CASE("loads: the page draws force over displacement of a force that changes, and displacement over time of a dead one") {
  Hut hut(kLoaded);
  hut.frame(0.0, stays);
  const Vec3 down{0.0, 0.0, -2e3};
  row(hut, 0.0, {{{{}, {}}, {{}, {}}, {down, {}}}});
  row(hut, 0.1, {{{{0.0, 4e3, 0.0}, {0.0, 4e-3, 0.0}}, {{}, {}}, {down, {0.0, 0.0, -1e-3}}}});
  row(hut, 0.2, {{{{0.0, 2e3, 0.0}, {0.0, 6e-3, 0.0}}, {{}, {}}, {down, {0.0, 0.0, -3e-3}}}});
  (void)hut.measures();
  std::vector<page::Plot> plots;
  add_loads(Hdf5File::open(hut.file()), plots);
  REQUIRE(plots.size() == 2);
  REQUIRE(plots[0].x);
  CHECK(plots[0].title.find("load 1") != std::string::npos);
  CHECK(plots[0].unit == "kN");
  CHECK(plots[0].x->unit == "mm");
  check_near(plots[0].x->values, {0.0, 4.0, 6.0});
  check_near(plots[0].curves.at(0).y, {0.0, 4.0, 2.0});
  CHECK_FALSE(plots[1].x);
  CHECK(plots[1].unit == "mm");
  REQUIRE(plots[1].curves.size() == 1);
  CHECK(plots[1].curves[0].name == "load 3");
  check_near(plots[1].curves[0].y, {0.0, 1.0, 3.0});
}

TEST_CASE("loads: a run without loads has no measures of them and no plot") {
  Hut hut;
  hut.frame(0.0, stays);
  CHECK(hut.measures().loads.empty());
  std::vector<page::Plot> plots;
  add_loads(Hdf5File::open(hut.file()), plots);
  CHECK(plots.empty());
}

}  // namespace voussoir::io
