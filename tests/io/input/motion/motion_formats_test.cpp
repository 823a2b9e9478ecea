// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "cases/case.h"
#include "io/app/commands/motion_command.h"
#include "io/input/motion/motion_files.h"
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using namespace voussoir;
using io::FileError;
using io::read_accelerogram;
using io::read_motion_file;

namespace {

/// L, V, T of constant 1, 3, 2 m/s2.
std::string iranian() {
  const auto constant = [](double a) { return std::vector<double>(3, 10.0 * a / kG); };
  return bhrc_component('L', constant(1.0), 0.03) + bhrc_component('V', constant(3.0), 0.03) + bhrc_component('T', constant(2.0), 0.03);
}

std::string californian(const std::string& direction, double value) {
  char number[16];
  std::snprintf(number, sizeof number, "%10.3f", value);
  return "CORRECTED ACCELEROGRAM\nCHAN  1: " + direction + "\nPEAK ACCELERATION = -7.000 CM/SEC/SEC AT 1 SEC.\n" +
         "2 POINTS OF ACCEL DATA EQUALLY SPACED AT .02 SEC. (UNITS: CM/SEC/SEC)\n" + number + number + "\n/&\n";
}

const std::string kCalifornian =
    californian("90 DEG", 100.0) + californian("UP", 200.0) + californian("0 DEG", 300.0) + californian("0 DEG", 400.0);

Vec3 at_start(const cases::GroundMotion& m) { return acceleration_at(m, 0.0); }

void check_near(Vec3 a, Vec3 b) {
  CHECK(a.x == doctest::Approx(b.x).epsilon(1e-6));
  CHECK(a.y == doctest::Approx(b.y).epsilon(1e-6));
  CHECK(a.z == doctest::Approx(b.z).epsilon(1e-6));
}

}  // namespace

TEST_CASE("formats: a file goes to its reader by its first lines, whatever its name") {
  const TempFolder folder;
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  for (const std::string name : {"a.V1", "a.AT2", "a.csv", "a"}) {
    CHECK(read_motion_file(folder.write(name, byte_order_mark + iranian()), {}).size() == 3);
    CHECK(read_motion_file(folder.write(name, kCalifornian), {}).size() == 4);
  }
  const auto refused = [&](const std::string& text, const char* message) {
    CHECK_THROWS_WITH_AS(read_motion_file(folder.write("b.dat", text), {}), doctest::Contains(message), FileError);
  };
  refused("EVENT_NAME: x\n", "the header's last key, USER5");
  refused("Origin Time       now\nSampling Freq(Hz) 100Hz\n", "the header, which has 17 lines");
  refused("Corrected acceleration    (Format v01.20 with 13 text lines)\n", "the end of the 13 text lines");
  refused("Corrected accelerogram x\nNumber of points 1\n", "Number of points is 1");
  refused("Corrected accelerogram x\n", "POINTS OF ACCEL DATA");
  refused("", "is in no format that is read; allowed: BHRC V1, ESM ASC, K-NET, COSMOS, GeoNet V2A, CSMIP V2, USC V2, PEER AT2 (known by");
  refused("UNCORRECTED ACCELEROGRAM\n", "is in no format that is read");
}

TEST_CASE("formats: a component by the file's own word or its number") {
  const TempFolder folder;
  const std::string path = folder.write("quake.V2", kCalifornian);
  CHECK(read_accelerogram(path + "#up", {}).acceleration[0] == doctest::Approx(2.0));
  CHECK(read_accelerogram(path + "#90 DEG", {}).acceleration[0] == doctest::Approx(1.0));
  CHECK(read_accelerogram(path + "#4", {}).acceleration[0] == doctest::Approx(4.0));
  CHECK(read_accelerogram(path, {}, 'V').acceleration[0] == doctest::Approx(2.0));
  const auto refused = [&](const std::string& choice, const char* message) {
    CHECK_THROWS_WITH_AS(read_accelerogram(path + choice, {}), doctest::Contains(message), FileError);
  };
  refused("", "quake.V2: holds 4 components; say which is wanted behind the file's name: #1 (90 DEG), #2 (UP), #3 (0 DEG), #4 (0 DEG)");
  refused("#0 DEG", "quake.V2: no one component is '#0 DEG'; allowed: #1 (90 DEG)");
  refused("#5", "no one component is '#5'");
  refused("#0", "no one component is '#0'");
  refused("#1x", "no one component is '#1x'");
  CHECK_THROWS_WITH_AS(read_accelerogram(path, {}, 'L'), doctest::Contains("holds 4 components; say which"), FileError);
  // A file that is called so comes first.
  CHECK(read_accelerogram(folder.write("quake.V2#4", californian("UP", 900.0)), {}).acceleration[0] == doctest::Approx(9.0));
}

TEST_CASE("formats: a file that says which are L, T and V is a record") {
  const TempFolder folder;
  folder.write("quake.V1", iranian());
  cases::Motion m;
  m.record = "quake.V1";
  m.direction = "TLV";
  check_near(at_start(io::load_motion(m, folder.path())), {2, 1, 3});
  m.record = folder.write("quake.V2", kCalifornian);
  CHECK_THROWS_WITH_AS(io::load_motion(m, ""),
                       doctest::Contains("quake.V2: does not mark one of its components as L, as a record must; it holds #1 (90 DEG), #2"),
                       FileError);
  m.record = folder.write("twice.V1", iranian() + iranian());
  CHECK_THROWS_WITH_AS(io::load_motion(m, ""), doctest::Contains("twice.V1: does not mark one of its components as L"), FileError);
}

TEST_CASE("formats: keys L, T, V take their components of one file; folders and axes may name them") {
  const TempFolder folder;
  folder.write("quake.V1", iranian());
  folder.write("quake.V2", kCalifornian);
  cases::Motion m;
  m.ltv = {"quake.V1", "quake.V1", "quake.V1"};
  check_near(at_start(io::load_motion(m, folder.path())), {1, 2, 3});
  cases::Motion axes;
  axes.xyz = {"quake.V1#T", "quake.V2#3", std::nullopt};
  check_near(at_start(io::load_motion(axes, folder.path())), {2, 3, 0});
  axes.xyz[0] = "quake.V1";
  CHECK_THROWS_WITH_AS(io::load_motion(axes, folder.path()), doctest::Contains("holds 3 components; say which is wanted"), FileError);
  const std::string all = iranian();
  folder.write("cut.V1", all.substr(0, all.find("/&") + 3));  // its first component alone, which is L
  m.ltv = {"cut.V1", "cut.V1", std::nullopt};
  CHECK_THROWS_WITH_AS(io::load_motion(m, folder.path()), doctest::Contains("holds L alone"), FileError);
  m.ltv = {"cut.V1", "cut.V1#1", std::nullopt};
  check_near(at_start(io::load_motion(m, folder.path())), {1, 1, 0});
  folder.write("record.toml", "L = \"quake.V1\"\nT = \"quake.V2#90 deg\"\nV = \"quake.V2\"\n");
  const io::Record record = io::read_record_folder(folder.path(), {});
  CHECK(record.ltv[0].acceleration[0] == doctest::Approx(1.0).epsilon(1e-6));
  CHECK(record.ltv[1].acceleration[0] == doctest::Approx(1.0));
  CHECK(record.ltv[2].acceleration[0] == doctest::Approx(2.0));
}

TEST_CASE("formats: the table of a file has a line for each component and the peak its header states") {
  const TempFolder folder;
  std::stringstream out;
  io::motion_command({folder.write("quake.V2", kCalifornian), folder.write("quake.V1", iranian())}, {}, out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(out, line);) lines.push_back(line);
  REQUIRE(lines.size() == 2 + 4 + 3);
  CHECK(lines[0].ends_with(" stated"));
  CHECK(lines[2].find("  90 DEG ") != std::string::npos);
  CHECK(lines[2].ends_with(" 0.0700"));
  CHECK(lines[6].ends_with(" -"));
  std::stringstream one;
  io::motion_command({folder.path("quake.V2") + "#2"}, {}, one);
  lines.clear();
  for (std::string line; std::getline(one, line);) lines.push_back(line);
  REQUIRE(lines.size() == 2 + 1);
  CHECK(lines[2].starts_with("quake.V2#2  UP "));
}
