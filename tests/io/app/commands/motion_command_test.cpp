// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/motion_command.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cases/case.h"
#include "io/input/files/errors.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
using io::FileError;
using io::motion_command;
using io::MotionOptions;

namespace {

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}
std::vector<std::string> lines_of_file(const std::string& path) {
  std::ifstream in(path);
  return lines_of(in);
}
std::vector<std::string> printed(const std::vector<std::string>& arguments, const MotionOptions& o = {}) {
  std::stringstream out;
  CHECK(motion_command(arguments, o, out) == 0);
  return lines_of(out);
}
std::vector<std::string> words_of(const std::string& line, char divider = ' ') {
  std::vector<std::string> words;
  std::stringstream in(line);
  for (std::string word; std::getline(in, word, divider);) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

const char* const kPulse = "t [s], a [m/s2]\n0,2\n0.5,2\n1,2\n1.5,0\n2,0\n";

}  // namespace

TEST_CASE("motion: the table of a file") {
  const TempFolder folder;
  const auto lines = printed({folder.write("pulse.csv", kPulse)});
  REQUIRE(lines.size() == 3);
  const auto words = words_of(lines[2]);
  // Velocity 2 (1 + 0.25); displacement at 1, 1.5, 2 s: 1, 1 + 0.5 (2 + 2.5) / 2, + 1.25; Arias pi / 2g · 4 · 1.25;
  // 5, 75 and 95 % of it at 0.0625, 0.9375 and 1 + 0.75 · 0.5 s.
  const std::vector<std::string> expected{"pulse.csv", "-",      "0.5",    "5",      "2.000", "2.0000", "0.20394",
                                          "0.000",     "2.5000", "3.3750", "0.8009", "0.875", "1.312",  "-"};
  CHECK(words == expected);
}

TEST_CASE("motion: a line per component of bam-like, of a folder and of files") {
  const TempFolder folder;
  folder.write("quake/record.toml", "name = \"Quake\"\nT = \"t.csv\"\n");
  folder.write("quake/t.csv", kPulse);
  const std::string at2 =
      folder.write("a.AT2", "x\nTown, 1/1/1990, Street, 228\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .5 SEC\n 0. 1.\n");
  const auto lines = printed({"bam-like", folder.path("quake"), at2});
  REQUIRE(lines.size() == 2 + 5);
  CHECK(words_of(lines[2])[1] == "L");
  CHECK(words_of(lines[3])[1] == "T");
  CHECK(words_of(lines[4])[1] == "V");
  CHECK(words_of(lines[5])[0] == "Quake");
  CHECK(words_of(lines[5])[1] == "T");
  CHECK(words_of(lines[6])[0] == "a.AT2");
  CHECK(words_of(lines[6])[1] == "228");
  CHECK(words_of(lines[6])[6] == "1.00000");
}

TEST_CASE("motion: --until counts the first seconds only") {
  MotionOptions o;
  o.until = 3.5;
  const auto lines = printed({"bam-like"}, o);
  CHECK(words_of(lines[2])[3] == "701");
  CHECK(words_of(lines[2])[4] == "3.500");
}

TEST_CASE("motion: spectra as a table") {
  const TempFolder folder;
  MotionOptions o;
  o.spectra = folder.path("spectra.csv");
  o.damping = {0.02, 0.05};
  o.until = 10.0;
  printed({"bam-like"}, o);
  const auto lines = lines_of_file(*o.spectra);
  REQUIRE(lines.size() == 1 + 3 * 2 * 271);
  CHECK(lines[0] == "record,component,damping,frequency [Hz],period [s],Sd [m],Sv [m/s],Sa [m/s2]");
  const auto first = words_of(lines[1], ','), last = words_of(lines.back(), ',');
  CHECK(first[1] == "L");
  CHECK(first[2] == "0.02");
  CHECK(std::stod(first[3]) == doctest::Approx(0.1));
  CHECK(last[1] == "V");
  CHECK(last[2] == "0.05");
  CHECK(std::stod(last[3]) == doctest::Approx(50.0));
  const auto row = words_of(lines[1 + 271 + 150], ',');
  const double f = std::stod(row[3]), w = 2.0 * 3.14159265358979 * f, sd = io::spectral_displacement(io::bam_like_1()[0], f, 0.05, 10.0);
  CHECK(std::stod(row[4]) == doctest::Approx(1.0 / f).epsilon(1e-5));
  CHECK(std::stod(row[5]) == doctest::Approx(sd).epsilon(1e-4));
  CHECK(std::stod(row[6]) == doctest::Approx(w * sd).epsilon(1e-4));
  CHECK(std::stod(row[7]) == doctest::Approx(w * w * sd).epsilon(1e-4));
}

TEST_CASE("motion: files of one name are called by their paths") {
  const TempFolder folder;
  const std::string a = folder.write("a/pulse.csv", kPulse), b = folder.write("b/pulse.csv", kPulse);
  const auto lines = printed({a, "bam-like", b});
  REQUIRE(lines.size() == 2 + 5);
  CHECK(words_of(lines[2])[0] == a);
  CHECK(words_of(lines[3])[0] == "bam-like");
  CHECK(words_of(lines[6])[0] == b);
  CHECK(words_of(printed({a})[2])[0] == "pulse.csv");
}

TEST_CASE("motion: nothing that exists is written over unless told to") {
  const TempFolder folder;
  MotionOptions o;
  o.spectra = folder.write("spectra.csv", "mine, too\n");
  std::stringstream out;
  CHECK_THROWS_WITH_AS(motion_command({"bam-like"}, o, out), doctest::Contains("exists; --overwrite replaces it"), FileError);
  CHECK(out.str().empty());
  CHECK(lines_of_file(*o.spectra) == std::vector<std::string>{"mine, too"});
  o.overwrite = true;
  printed({"bam-like"}, o);
  CHECK(lines_of_file(*o.spectra).size() == 1 + 3 * 271);
  MotionOptions nowhere;
  nowhere.spectra = folder.path("no/such/folder.csv");
  CHECK_THROWS_WITH_AS(motion_command({"bam-like"}, nowhere, out), doctest::Contains("cannot be written"), FileError);
}

TEST_CASE("motion: --write gives a folder that reads back") {
  const TempFolder folder;
  MotionOptions o;
  o.write = folder.path("bam");
  printed({"bam-like"}, o);
  CHECK(io::read_record_folder(*o.write, {}).ltv[2].acceleration == io::bam_like_1()[2].acceleration);
  const auto from_name = printed({"bam-like"}), from_folder = printed({*o.write});
  CHECK(from_name == from_folder);
}

TEST_CASE("motion: faults of the request") {
  const TempFolder folder;
  const std::string pulse = folder.write("pulse.csv", kPulse);
  std::stringstream out;
  const auto check = [&](const std::vector<std::string>& arguments, const MotionOptions& o, const char* key, const char* message) {
    CAPTURE(message);
    try {
      motion_command(arguments, o, out);
      FAIL("no error");
    } catch (const cases::InputError& e) {
      CHECK(e.key() == key);
      CHECK(e.problem().find(message) != std::string::npos);
    }
  };
  MotionOptions unit, until, damping, no_damping, write;
  unit.unit = "ft";
  until.until = 0.0;
  damping.damping = {0.02, 1.0};
  no_damping.damping = {};
  no_damping.spectra = folder.path("s.csv");
  write.write = folder.path("w");
  MotionOptions one_sample = write;
  one_sample.until = 1e-4;
  check({"bam-like"}, one_sample, "--until", "0.0001 s leaves one sample; allowed: 0.00");
  CHECK_FALSE(std::filesystem::exists(folder.path("w")));
  check({}, {}, "", "no record named; allowed: files");
  check({pulse}, unit, "--unit", "'ft'; allowed: \"g\"");
  check({pulse}, until, "--until", "0 s; allowed: above 0");
  check({pulse}, damping, "--damping", "1; allowed: from 0 to below 1");
  check({pulse}, no_damping, "--damping", "no value; allowed");
  check({pulse, pulse}, write, "--write", "2 records named; allowed: one");
  check({pulse}, write, "--write", "is a single file; allowed: bam-like, bam-like#N, or a folder");
  CHECK_THROWS_WITH_AS(motion_command({"kobe"}, {}, out),
                       doctest::Contains("kobe: no such file; allowed: a file, FILE#COMPONENT, a folder that holds record.toml"),
                       FileError);
  CHECK(out.str().empty());
}
