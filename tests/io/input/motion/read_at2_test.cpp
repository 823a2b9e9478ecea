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
using voussoir::io::read_at2;

namespace {

constexpr double kG = 9.80665;

const std::string kHead = "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/2/1990, Station (a, b), L\n";
const std::string kUnit = "ACCELERATION TIME SERIES IN UNITS OF G\n";
const std::string kSeven =
    "   .1647381E-02   .5444729E-02   .7233436E-02   .3403727E-02  -.6483949E+00\n"
    "   .2636603E-02   .1008352E-01\n";

std::string with_crlf(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

void check_seven(const std::string& text, double dt, const std::string& name) {
  const TempFolder folder;
  for (const std::string& variant : {text, with_crlf(text)}) {
    const Accelerogram a = read_at2(folder.write("a.AT2", variant));
    CHECK(a.name == name);
    CHECK(a.dt == dt);
    REQUIRE(a.acceleration.size() == 7);
    CHECK(a.acceleration[0] == doctest::Approx(0.001647381 * kG).epsilon(1e-14));
    CHECK(a.acceleration[4] == doctest::Approx(-0.6483949 * kG).epsilon(1e-14));
    CHECK(a.acceleration[6] == doctest::Approx(0.01008352 * kG).epsilon(1e-14));
  }
}

/// Reads the text as a.AT2 and expects this message after the path.
void check_fault(const std::string& text, const std::string& message) {
  const TempFolder folder;
  const std::string path = folder.write("a.AT2", text);
  CAPTURE(message);
  try {
    read_at2(path);
    FAIL("no error");
  } catch (const FileError& e) {
    CHECK(e.path() == path);
    const std::string what = e.what();
    CHECK(what.substr(0, path.size() + message.size()) == path + message);
  }
}

}  // namespace

TEST_CASE("AT2: NGA-West2 headers, plain and with filter corners cut off") {
  const std::string name = "Somewhere, 1/2/1990, Station (a, b), L";
  check_seven(kHead + kUnit + "NPTS=      7, DT=   .0200 SEC                                              \n" + kSeven, 0.02, name);
  check_seven(kHead + kUnit + "NPTS=      7, DT=   .0050 SEC,                                             \n" + kSeven, 0.005, name);
  check_seven(kHead + kUnit + "NPTS=      7, DT=   .0100 SEC,   0 POLE @    30.00000 HZ,  -5 POLE @      .40000\n" + kSeven, 0.01, name);
  check_seven(kHead + kUnit + "NPTS=      7, DT=   .0100 SEC,  -5 POLE @      .05000 HZ,   0 POLE @      .00000\n" + kSeven, 0.01, name);
}

TEST_CASE("AT2: Pacific Engineering headers") {
  check_seven(
      "PACIFIC ENGINEERING AND ANALYSIS STRONG-MOTION DATA\nSOME VALLEY 10/15/79 2316, Array #4, 140          \n"
      "ACCELERATION TIME HISTORY IN UNITS OF G,  PGA=   .48431 G, PGV=   39.6246 CM/SEC, PGD=   25.1238 CM\n"
      "NPTS=      7, DT=   .0050 SEC,   0 POLE @    40.00000 HZ,  -5 POLE @      .05000 HZ, ACAUSAL\n" +
          kSeven,
      0.005, "SOME VALLEY 10/15/79 2316, Array #4, 140");
}

TEST_CASE("AT2: old PEER headers, dt in lower case") {
  check_seven(
      "PEER STRONG MOTION DATABASE RECORD. PROCESSING BY PACIFIC ENGINEERING.\nSOME PEAK AS, 10/29/83, 23:29, HAU, 000\n"
      "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz LP=62.5 Hz\nNPTS=      7, dt=  .00500\n" +
          kSeven,
      0.005, "SOME PEAK AS, 10/29/83, 23:29, HAU, 000");
}

TEST_CASE("AT2: NGA-West1 headers, numbers first") {
  check_seven(kHead + kUnit + "7    0.0100    NPTS, DT\n" + kSeven, 0.01, "Somewhere, 1/2/1990, Station (a, b), L");
  check_seven(kHead + kUnit + "   7    0.0100    npts, dt\n" + kSeven, 0.01, "Somewhere, 1/2/1990, Station (a, b), L");
}

TEST_CASE("AT2: NGA-East, values with a leading digit") {
  check_seven(
      "PEER NGA STRONG MOTION DATABASE RECORD\nX-20, 10/20/2011, CCM, BHZ00\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS=  7, DT=    "
      "0.05 SEC\n"
      "  1.647381E-03  5.444729E-03  7.233436E-03  3.403727E-03 -6.483949E-01\n  2.636603E-03  1.008352E-02\n",
      0.05, "X-20, 10/20/2011, CCM, BHZ00");
}

TEST_CASE("AT2: other units, no newline at the end, blank lines, plus signs, an empty title") {
  const TempFolder folder;
  const Accelerogram a =
      read_at2(folder.write("rock.at2", "x\n   \nACCELERATION IN UNITS OF CM/S/S\nNPTS = 3, DT = 0.5\n\n +1.0 -2.\n\n 3"));
  CHECK(a.name == "rock");
  CHECK(a.acceleration == std::vector<double>{0.01, -0.02, 0.03});
}

TEST_CASE("AT2: a file cut within its last value is refused, one without a newline at its end is not") {
  const std::string text = kHead + kUnit + "NPTS=      7, DT=   .0200 SEC\n" + kSeven;
  const TempFolder folder;
  const auto last = [&](std::size_t lost) {
    return read_at2(folder.write("a.AT2", text.substr(0, text.size() - lost))).acceleration.back();
  };
  CHECK(last(0) == last(1));
  for (std::size_t lost = 2; lost <= 12; ++lost) CHECK_THROWS_AS(last(lost), FileError);
}

TEST_CASE("AT2: velocity and displacement files are refused by name of the quantity") {
  const std::string numbers = "NPTS= 2, DT= .01 SEC\n .1 .2\n";
  check_fault(kHead + "VELOCITY TIME SERIES IN UNITS OF CM/S\n" + numbers, ":3: the file holds velocity, wanted acceleration");
  check_fault(kHead + "DISPLACEMENT TIME HISTORY IN UNITS OF CM\n" + numbers, ":3: the file holds displacement, wanted acceleration");
  const TempFolder folder;
  const std::string path = folder.write("a.VT2", kHead + "VELOCITY TIME SERIES IN UNITS OF CM/S\n" + numbers);
  CHECK_THROWS_WITH_AS(read_accelerogram(path, {}), doctest::Contains("the .AT2 file of the same component"), FileError);
}

TEST_CASE("AT2: faults of the header") {
  check_fault("", ":1: the file ends within the header");
  check_fault("only\ntwo\n", ":3: the file ends within the header");
  check_fault(kHead + kUnit, ":4: the file ends within the header");
  check_fault(kHead + "no unit here\nNPTS= 2, DT= .01\n1 2", ":3: 'no unit here': wanted 'ACCELERATION");
  check_fault(kHead + "ACCELERATION IN UNITS OF FURLONGS\nNPTS= 2, DT= .01\n1 2", ":3: unit 'FURLONGS' is not known; allowed: G");
  check_fault(kHead + kUnit + "nothing to see\n1 2", ":4: 'nothing to see': wanted 'NPTS= n");
  check_fault(kHead + kUnit + "\n1 2", ":4: '': wanted 'NPTS= n");
  for (const std::string count : {"0", "1", "-3", "2.5", "two", "99999999999999999999999999"}) {
    check_fault(kHead + kUnit + "NPTS= " + count + ", DT= .01 SEC\n1 2",
                ":4: NPTS = '" + count.substr(0, 40) + "' is no count of values; allowed:");
  }
  check_fault(kHead + kUnit + "NPTS= 2 SEC\n1 2", ":4: DT = '' is no time step; allowed:");
  for (const std::string step : {"0", "-.01", "nan", "inf", ".01s", "x"}) {
    check_fault(kHead + kUnit + "NPTS= 2, DT= " + step + "\n1 2", ":4: DT = '" + step + "' is no time step; allowed:");
  }
}

TEST_CASE("AT2: faults of the values, with their line") {
  const std::string head = kHead + kUnit + "NPTS= 3, DT= .01 SEC\n";
  check_fault(head + " .1 .2\n", ":5: the file ends after 2 values, the header says NPTS = 3");
  check_fault(head, ":4: the file ends after 0 values, the header says NPTS = 3");
  check_fault(head + " .1 .2\n .3 .4\n", ":6: more values than NPTS = 3 of the header");
  check_fault(head + " .1\n .2-.3145E-02\n", ":6: '.2-.3145E-02' is not one finite number");
  check_fault(head + " .1 nan .2\n", ":5: 'nan' is not one finite number");
  check_fault(head + " .1 -inf .2\n", ":5: '-inf' is not one finite number");
  check_fault(head + " .1 1e308 .2\n", ":5: '1e308' is not one finite number");  // in m/s2 it is not
  check_fault(head + " .1 1e999 .2\n", ":5: '1e999' is not one finite number");
  check_fault(head + " .1 ******* .2\n", ":5: '*******' is not one finite number");
  check_fault(head + " .1 +-2 .2\n", ":5: '+-2' is not one finite number");
  check_fault(head + " .1 " + std::string(100, 'x') + "\n", ":5: '" + std::string(40, 'x') + "...' is not one finite number");
}

TEST_CASE("AT2: a header that promises 10^12 values asks for no memory") {
  check_fault(kHead + kUnit + "NPTS= 1000000000000, DT= .01 SEC\n .1 .2\n",
              ":5: the file ends after 2 values, the header says NPTS = 1000000000000");
}

TEST_CASE("AT2: binary junk is an error, not a crash") {
  std::string junk;
  unsigned state = 7;
  for (int i = 0; i < 20000; ++i) {
    state = state * 1103515245u + 12345u;
    junk += static_cast<char>(state >> 16);
  }
  const TempFolder folder;
  CHECK_THROWS_AS(read_at2(folder.write("a.AT2", junk)), FileError);
  CHECK_THROWS_AS(read_at2(folder.write("b.AT2", std::string(1000, '\0'))), FileError);
  CHECK_THROWS_AS(read_accelerogram(folder.write("c.csv", junk), "g"), FileError);
  CHECK_THROWS_AS(read_accelerogram(folder.write("d.bin", junk), {}), FileError);
  const std::string path = folder.write("e.AT2", kHead + kUnit + "NPTS= 9, DT= .01 SEC\n" + junk);
  CHECK_THROWS_WITH_AS(read_at2(path), doctest::Contains("is not one finite number"), FileError);
}
