// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "io/input/files/errors.h"
#include "io/input/motion/formats/read_motion.h"
#include "tests/io/temp_folder.h"

using voussoir::cases::Accelerogram;
using voussoir::io::FileError;
using voussoir::io::read_accelerogram;
using voussoir::io::read_motion_csv;

namespace {

Accelerogram read(const std::string& text, const std::optional<std::string>& unit = {}) {
  const TempFolder folder;
  return read_motion_csv(folder.write("quake.csv", text), unit);
}

/// Expects this message after the path.
void check_fault(const std::string& text, const std::string& message, const std::optional<std::string>& unit = "g") {
  const TempFolder folder;
  const std::string path = folder.write("quake.csv", text);
  CAPTURE(message);
  try {
    read_motion_csv(path, unit);
    FAIL("no error");
  } catch (const FileError& e) {
    CHECK(e.path() == path);
    const std::string what = e.what();
    CHECK(what.substr(0, path.size() + message.size()) == path + message);
  }
}

}  // namespace

TEST_CASE("CSV: the header line states the unit, comments and blank lines are passed over") {
  const Accelerogram a = read("# from somewhere\n\nt [s], a [cm/s2]\n0, 100\n# in between\n0.01, -250\r\n0.02, 5e1\n", "g");
  CHECK(a.name == "quake");
  CHECK(a.dt == doctest::Approx(0.01).epsilon(1e-14));
  CHECK(a.acceleration == std::vector<double>{1.0, -2.5, 0.5});
  CHECK(read("t (s), a (cm/s2)\n0, 100\n0.01, -250\n", "g").acceleration == std::vector<double>{1.0, -2.5});
}

TEST_CASE("CSV: without a unit in the header the caller's holds") {
  CHECK(read("t, a\n0,1\n0.5,2\n", "m/s2").acceleration == std::vector<double>{1.0, 2.0});
  CHECK(read("0,1\n0.5,2\n", "g").acceleration == std::vector<double>{9.80665, 2 * 9.80665});
  CHECK(read("0,1\n0.5,2\n", "cm/s2").acceleration == std::vector<double>{0.01, 0.02});
}

TEST_CASE("CSV: semicolons, blanks, tabs, a byte order mark, no newline at the end") {
  for (const std::string text : {"0;1\n0.5;2\n", "0 1\n 0.5   2", "0\t1\n0.5\t2\n",
                                 "\xEF\xBB\xBF"
                                 "0,1\n0.5,2"}) {
    const Accelerogram a = read(text, "m/s2");
    CHECK(a.dt == 0.5);
    CHECK(a.acceleration == std::vector<double>{1.0, 2.0});
  }
}

TEST_CASE("CSV: the step must be the same to a millionth") {
  CHECK(read("0,1\n0.01,1\n0.020000005,1\n0.03,1\n", "g").acceleration.size() == 4);
  check_fault("0,1\n0.01,1\n0.02000002,1\n0.03,1\n",
              ":3: time 0.02000002 s is not a multiple of the mean step, 0.01 s; allowed: equal steps");
  check_fault("0,1\n0.01,1\n0.02,1\n0.04,1\n0.05,1\n",  // a row is missing: told where
              ":4: time 0.04 s is 0.02 s after the row before, and most steps are 0.01 s; allowed: equal steps");
  check_fault("0,1\n0.01,1\n0.01,1\n0.02,1\n0.03,1\n", ":3: time 0.01 s is 0 s after the row before");
  check_fault("0,1\n0.01,1\n0.02,1\n0.04,1\n0.03,1\n0.05,1\n0.06,1\n0.07,1\n", ":4: time 0.04 s is 0.02 s after the row before");
  check_fault("0,1\n0.01,1\n0.01,1\n0.02,1\n0.02,1\n", ":2: time 0.01 s is not a multiple of the mean step");  // 0.005 s, rounded
  check_fault("0,005;1\n0,01;1\n", ":1: acceleration '005;1' is no finite number; decimals need a point, not a comma");
  check_fault("0,005;0,3\n", ":1: more than two columns; wanted two columns: time [s], acceleration; decimals need a point, not a comma");
}

TEST_CASE("CSV: times may begin anywhere, and may be rounded where that leaves one step") {
  const auto rows = [](double dt, int first, int count, int decimals) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      char row[64];
      std::snprintf(row, sizeof row, "%.*f, %d\n", decimals, (first + i) * dt, i);
      text += row;
    }
    return text;
  };
  CHECK(read(rows(0.005, 1, 400, 3), "g").dt == doctest::Approx(0.005).epsilon(1e-12));
  CHECK(read(rows(0.005, -200, 400, 3), "g").dt == doctest::Approx(0.005).epsilon(1e-12));
  CHECK(read(rows(0.005, 0, 400, 2), "g").dt == 0.005);
  CHECK(read(rows(0.005, 1, 400, 2), "g").dt == 0.005);
  for (const int decimals : {3, 4, 5}) {
    for (const int first : {0, 1, -128}) CHECK(read(rows(1.0 / 128, first, 400, decimals), "g").dt == 1.0 / 128);
  }
  CHECK(read(rows(0.0073, 0, 2000, 3), "g").dt == doctest::Approx(0.0073).epsilon(1e-4));
  CHECK(read(rows(1.0 / 128, 0, 400, 4), "g").acceleration.size() == 400);
  // the step that the case states settles what rounding leaves open
  const TempFolder folder;
  const std::string open = rows(1.0 / 128, 0, 20, 2);
  CHECK(read_motion_csv(folder.write("a.csv", open), {"g", 1.0 / 128}).dt == 1.0 / 128);
  check_fault(open, ":4: time 0.02 s is 0 s after the row before");
  // a row is missing: rounding explains it with a step of 0.010025 s, which nobody meant
  std::string gap = rows(0.01, 0, 401, 2);
  gap.erase(gap.find("2.00, "), 10);
  check_fault(gap, ":201: time 2.01 s is 0.02 s after the row before");
}

TEST_CASE("CSV: a first row of count and step") {
  const Accelerogram a = read("3 0.005\n1\n2\n3\n", "g");
  CHECK(a.dt == 0.005);
  CHECK(a.acceleration.size() == 3);
  for (const char* times : {" 3 0.005\n 0.005 1\n 0.010 2\n 0.015 3\n", "3, 0.005\n0, 1\n0.005, 2\n0.01, 3\n"}) {
    CHECK(read(times, "m/s2").dt == doctest::Approx(0.005).epsilon(1e-12));
    CHECK(read(times, "m/s2").acceleration == std::vector<double>{1.0, 2.0, 3.0});
  }
  CHECK(read("t [s], a [m/s2]\n2, 0.5\n3, 1\n").acceleration == std::vector<double>{0.5, 1.0});  // no count
  check_fault("4 0.005\n1\n2\n3\n", ":1: the first row says 4 values at steps of 0.005 s, and 3 rows follow; allowed: as many");
  check_fault("3 0.005\n0 1\n0.01 2\n0.02 3\n", ":2: times have steps of 0.01 s, and the first row says 0.005 s; allowed: the same");
  const TempFolder folder;
  CHECK_THROWS_WITH_AS(read_motion_csv(folder.write("a.csv", "3\n1\n2\n3\n"), {"g", 0.01}),
                       doctest::Contains("the first number, 3, is the number of rows behind it, no acceleration"), FileError);
}

TEST_CASE("CSV: faults, with their line") {
  check_fault("", ": holds 0 rows of numbers; allowed: 2 or more");
  check_fault("t, a\n0,1\n", ": holds 1 rows of numbers; allowed: 2 or more");
  check_fault("1\n2\n3\n", ":1: one column, and its step is not stated; wanted two columns");
  check_fault("0,1,2\n", ":1: more than two columns; wanted two columns");
  check_fault("t, a\n0,1\n0.1,x\n", ":3: acceleration 'x' is no finite number");
  check_fault("t, a\n0,1\n0.1,\n", ":3: acceleration '' is no finite number");
  check_fault("0,1\nnan,1\n", ":2: time 'nan' is no finite number");
  check_fault("0,1\n0.1,inf\n", ":2: acceleration 'inf' is no finite number");
  check_fault("0,1\n0.1,-1e308\n", ":2: acceleration is too large for a number in m/s2");
  check_fault("0,1\nt, a\n0.1,1\n", ":2: time 't' is no finite number");
  check_fault("0,1\n0,1\n", ":2: time does not grow");
  check_fault("0,1\n-1,1\n", ":2: time does not grow");
  check_fault("t, a, b\n0,1\n1,1\n", ":1: header 't, a, b': wanted two columns");
  check_fault("time only\n0,1\n1,1\n", ":1: header 'time only': wanted two columns");
  check_fault("t [ms], a [g]\n0,1\n1,1\n", ":1: unit of time is 'ms'; allowed: s");
  check_fault("t (ms), a (g)\n0,1\n5,1\n", ":1: unit of time is 'ms'; allowed: s");
  check_fault("0,1\n20,1\n40,1\n", ":1: times have steps of 20 s; allowed: from 1e-6 to 10 s");
  check_fault("t [s], a [mph]\n0,1\n1,1\n", ":1: unit of acceleration is 'mph'; allowed: g, m/s2, cm/s2");
  check_fault("0,1\n1,1\n", ": the unit of acceleration is not stated; give the file a header line 't [s], a [m/s2]', or set unit", {});
}

TEST_CASE("files that are missing, folders, devices, too large or in no known format") {
  const TempFolder folder;
  CHECK_THROWS_WITH_AS(read_accelerogram(folder.path("none.AT2"), {}), doctest::Contains("none.AT2: no such file"), FileError);
  CHECK_THROWS_WITH_AS(read_accelerogram(folder.path(), {}), doctest::Contains("is a folder, wanted a file"), FileError);
  CHECK_THROWS_WITH_AS(read_accelerogram("/dev/zero", {}), doctest::Contains("is not a regular file"), FileError);
  const std::string large = folder.write("large.csv", "0,1\n");
  std::filesystem::resize_file(large, voussoir::io::kLargestMotionFile + 1);  // a hole: takes no room
  CHECK_THROWS_WITH_AS(read_accelerogram(large, {}), doctest::Contains("has 67108865 bytes; allowed: at most 67108864"), FileError);
  CHECK_THROWS_WITH_AS(read_accelerogram(folder.write("a.V2", "a\nb\nc\nd\n"), {}),
                       doctest::Contains("is in no format that is read; allowed:"), FileError);
}

TEST_CASE("a PEER file is known by its third line under any name") {
  const TempFolder folder;
  const std::string text = "x\nname\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 2, DT= .5 SEC\n 1. 2.\n";
  CHECK(read_accelerogram(folder.write("a.acc", text), {}).acceleration == std::vector<double>{9.80665, 2 * 9.80665});
  CHECK(read_accelerogram(folder.write("a.at2", text), {}).name == "name");
}

TEST_CASE("CSV: units with a dot behind, with squares as signs and in capitals") {
  for (const char* unit : {"cm/s\xC2\xB2", "cm/s\xB2", "cm\xC2\xB7s\xE2\x81\xBB\xC2\xB2", "cm/sec2.", "GAL.", "CM / S2", "cm s-2"}) {
    CAPTURE(unit);
    const Accelerogram a = read("t [s], a [" + std::string(unit) + "]\n0, 1\n0.01, 2\n");
    CHECK(a.acceleration == std::vector<double>{0.01, 0.02});
  }
}

TEST_CASE("CSV: a carriage return alone ends a line") {
  const Accelerogram a = read("t [s], a [m/s2]\r0, 1\r0.01, 2\r0.02, 3\r");
  CHECK(a.acceleration == std::vector<double>{1.0, 2.0, 3.0});
  CHECK(a.dt == doctest::Approx(0.01));
}
