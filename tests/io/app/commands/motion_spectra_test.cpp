// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "cases/case.h"
#include "io/app/commands/motion_command.h"
#include "io/input/files/errors.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/spectra/intensity.h"
#include "io/input/motion/spectra/spectra.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
using io::motion_command;
using io::MotionOptions;

namespace {

std::string printed(const std::vector<std::string>& arguments, const MotionOptions& o) {
  std::stringstream out;
  CHECK(motion_command(arguments, o, out) == 0);
  return out.str();
}

/// The line of the text that begins so, as words.
std::vector<std::string> words_of(const std::string& text, const std::string& begin) {
  std::stringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(begin)) continue;
    std::stringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    return all;
  }
  FAIL("no line begins with ", begin);
  return {};
}

/// Sa of the CSV's rows by component, in the order of rows.
std::map<std::string, std::vector<double>> accelerations(const std::string& path) {
  std::map<std::string, std::vector<double>> all;
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1);
    all[line.substr(first + 1, second - first - 1)].push_back(std::stod(line.substr(line.rfind(',') + 1)));
  }
  return all;
}

void check_fault(const std::vector<std::string>& arguments, const MotionOptions& o, const char* key, const char* message) {
  CAPTURE(message);
  std::stringstream out;
  try {
    motion_command(arguments, o, out);
    FAIL("no error");
  } catch (const cases::InputError& e) {
    CHECK(e.key() == key);
    CHECK(e.problem().find(message) != std::string::npos);
  }
  CHECK(out.str().empty());
}

const char* const kPulse = "t [s], a [m/s2]\n0,2\n0.5,2\n1,2\n1.5,0\n2,0\n";

}  // namespace

TEST_CASE("motion: two horizontal components together, beside a target, in one table") {
  const TempFolder folder;
  MotionOptions o;
  o.spectra = folder.path("s.csv");
  o.damping = {0.05};
  o.combine = true;
  o.target = "ec8:1:B:0.3g";
  printed({"bam-like"}, o);
  const auto sa = accelerations(*o.spectra);
  REQUIRE(sa.size() == 7);
  for (const char* name : {"L", "T", "V", "geomean", "RotD50", "RotD100"}) CHECK(sa.at(name).size() == 271);
  CHECK(sa.at("target").size() == 231);  // from 4 s, of 10 s
  for (std::size_t i = 0; i < 271; ++i) {
    CHECK(sa.at("geomean")[i] == doctest::Approx(std::sqrt(sa.at("L")[i] * sa.at("T")[i])).epsilon(1e-6));
    CHECK(sa.at("RotD100")[i] >= 0.9999 * std::max(sa.at("L")[i], sa.at("T")[i]));
    CHECK(sa.at("RotD50")[i] <= sa.at("RotD100")[i]);
  }
  CHECK(sa.at("target").back() == doctest::Approx(3.530394 * (1.0 + 0.02 / 0.15 * 1.5)).epsilon(1e-5));  // 50 Hz
}

TEST_CASE("motion: the factor brings the record to the target") {
  MotionOptions o;
  o.damping = {0.05};
  o.target = "ec8:1:B:0.3g";
  o.fit = {0.1, 0.8};
  const std::string text = printed({"bam-like"}, o);
  CHECK(text.find("target ec8:1:B:0.3g, fitted from 0.1 to 0.8 s") != std::string::npos);
  const std::string fits = text.substr(text.find("\ntarget"));
  const auto words = words_of(fits, "bam-like  T");
  // By the definition: the mean logarithm of target over record.
  const cases::Accelerogram t = io::bam_like_1()[1];
  double sum = 0.0;
  const auto periods = io::periods_between(0.1, 0.8, 101);
  for (const double period : periods) {
    const double w = 2.0 * M_PI / period;
    sum += std::log(io::eurocode8({1, 'B', 0.3 * 9.80665}, period, 0.05) / (w * w * io::spectral_displacement(t, 1.0 / period, 0.05)));
  }
  CHECK(std::stod(words[3]) == doctest::Approx(std::exp(sum / 101.0)).epsilon(1e-4));
  // A record made twice as strong needs half the factor.
  const TempFolder folder;
  io::Record twice{"twice", io::bam_like_1()};
  for (auto& a : twice.ltv) {
    for (double& x : a.acceleration) x *= 2.0;
  }
  io::write_record_folder(twice, folder.path("twice"), false);
  const std::string other = printed({folder.path("twice")}, o);
  CHECK(std::stod(words_of(other.substr(other.find("\ntarget")), "twice   T")[3]) ==
        doctest::Approx(0.5 * std::stod(words[3])).epsilon(1e-3));
}

TEST_CASE("motion: window, baseline and taper change what is printed and written, and are said") {
  const TempFolder folder;
  MotionOptions o;
  o.treatment.from = 2.0;
  o.treatment.to = 6.0;
  o.treatment.baseline = cases::Baseline::mean;
  o.treatment.taper = {0.1, 0.1};
  o.write = folder.path("cut");
  const std::string text = printed({"bam-like"}, o);
  CHECK(words_of(text, "bam-like  L")[3] == "801");
  CHECK(text.find("\nfrom 2 to 6 s, baseline mean, tapered over 0.1 and 0.1 s\n") != std::string::npos);
  const io::Record cut = io::read_record_folder(*o.write, {});
  REQUIRE(cut.ltv[0].acceleration.size() == 801);
  CHECK(cut.ltv[0].acceleration[0] == 0.0);
  const auto& now = cut.ltv[0].acceleration;
  const std::vector<double> whole = io::bam_like_1()[0].acceleration;
  CHECK(now[400] - now[300] == doctest::Approx(whole[800] - whole[700]).epsilon(1e-9));  // but for the mean
}

TEST_CASE("motion: a window of a file") {
  const TempFolder folder;
  MotionOptions o;
  o.treatment.from = 0.5;
  o.treatment.to = 1.5;
  const auto words = words_of(printed({folder.write("pulse.csv", kPulse)}, o), "pulse.csv");
  CHECK(words[3] == "3");
  CHECK(words[4] == "1.000");
}

TEST_CASE("motion: one column, with step and unit") {
  const TempFolder folder;
  const std::string path = folder.write("one.txt", "1\n2\n-3\n");
  MotionOptions o;
  o.unit = "m/s2";
  o.dt = 0.25;
  const auto words = words_of(printed({path}, o), "one.txt");
  CHECK(words[2] == "0.25");
  CHECK(words[3] == "3");
  CHECK(words[5] == "3.0000");
}

TEST_CASE("motion: faults of spectra, combinations and fits") {
  const TempFolder folder;
  const std::string pulse = folder.write("pulse.csv", kPulse), other = folder.write("other.csv", "t [s], a [m/s2]\n0,2\n0.1,2\n");
  MotionOptions combine, spectra, fit, range, dt, both, from;
  combine.combine = true;
  spectra.combine = true;
  spectra.spectra = folder.path("s.csv");
  fit.target = range.target = "ec8:1:A:1";
  fit.fit = {1.0, 0.5};
  range.fit = {1.0, 5.0};
  dt.dt = 0.0;
  both.until = both.treatment.to = 1.0;
  from.treatment.from = 30.0;
  check_fault({"bam-like"}, combine, "--combine", "allowed: with --spectra FILE.csv, or with --target");
  check_fault({pulse}, spectra, "--combine", "1 components, and nothing says which two are horizontal");
  check_fault({pulse, other}, spectra, "--combine", "steps of 0.5 and 0.1 s");
  check_fault({"bam-like"}, fit, "--fit", "from 1 to 0.5 s; allowed: two rising periods");
  check_fault({"bam-like"}, range, "--fit", "has no value at 4.0");
  check_fault({pulse}, dt, "--dt", "0 s; allowed: from 1e-6 to 10");
  check_fault({pulse}, both, "--until", "does not go with --to");
  check_fault({"bam-like"}, from, "--from", "30 s; allowed: from 0 to below 2");
  CHECK_FALSE(std::filesystem::exists(*spectra.spectra));
}

TEST_CASE("motion command: the measures of motion.intensity, of both horizontal components together") {
  MotionOptions o;
  o.periods = {0.3};
  const std::array<cases::Accelerogram, 3> ltv = io::bam_like_1();
  const auto value = [&](cases::IntensityMeasure m, std::optional<double> period, cases::IntensityOf components) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4g", io::intensity({m, 1.0, period, components}, ltv[0], ltv[1]));
    return std::string(digits);
  };
  const std::string text = printed({"bam-like"}, o);
  CHECK(text.find("\nbam-like:\n  measure                      L           T  geometric mean      RotD50      larger\n") !=
        std::string::npos);
  using cases::IntensityMeasure, cases::IntensityOf;
  const auto row = [&](const std::string& begin, IntensityMeasure m, std::optional<double> period) {
    const std::vector<std::string> words = words_of(text, "  " + begin);
    REQUIRE(words.size() >= 5);
    const std::vector<std::string> last(words.end() - 5, words.end());
    const double l = std::stod(last[0]), t = std::stod(last[1]);
    CHECK(std::sqrt(l * t) == doctest::Approx(std::stod(last[2])).epsilon(1e-3));
    CHECK(last[2] == value(m, period, IntensityOf::geometric_mean));
    CHECK(last[3] == value(m, period, IntensityOf::rotd50));
    CHECK(last[4] == (l > t ? last[0] : last[1]));
  };
  row("PGA, m/s2", IntensityMeasure::pga, {});
  row("PGV, m/s ", IntensityMeasure::pgv, {});
  row("Sa(0.3 s), m/s2", IntensityMeasure::sa, 0.3);
}
