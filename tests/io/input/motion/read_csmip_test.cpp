// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_csmip;

namespace {

const std::vector<double> kX{1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0, -250.5};

/// One channel with the three lines of data as given (printf formats of the count) in the older words.
std::string channel(const std::string& direction, const std::vector<double>& a) {
  const std::string count = std::to_string(a.size());
  std::string text =
      "CORRECTED ACCELEROGRAM   1-S2-3.01       CHAN  1:  " + direction + "     FROM\nUNCORRECTED ACCELEROGRAM DATA\nTOWN EARTHQUAKE\n" +
      "MAY 2, 1983\n1-S2-3.01\nSTATION NO. 1\nTOWN HALL\nCHAN  1:  " + direction + "\n  " + count +
      " POINTS OF INSTRUMENT- AND BASELINE-CORRECTED ACCEL, VELOC AND DISPL DATA\n" +
      "PEAK ACCELERATION =  -250.500    CM/SEC/SEC  AT     .180   SEC.\n\n    1    1    1    9013043\n      .041      .630\n";
  for (const char* kind :
       {"ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)", "VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)",
        "DISPL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM)"}) {
    text += " " + count + " POINTS OF " + kind + "\n" + columns(a, 8, "%10.3f");
  }
  return text + "/&  ----------  END OF DATA FOR CHANNEL  1  ----------\n";
}

const std::string kFile = channel("90 DEG", kX) + channel("UP", {1.0, 2.0, 3.0}) + channel("DOWN", {0.1, 0.2});

}  // namespace

TEST_CASE("CSMIP V2: channels of different length, the older words, LF or CRLF, Ctrl-Z at the end") {
  for (const std::string& text : {kFile, with_crlf(kFile), kFile + "\n\x1A\x1A"}) {
    const auto channels = read_text(read_csmip, text);
    REQUIRE(channels.size() == 3);
    const Channel& c = channels[0];
    CHECK(c.component == "90 DEG");
    CHECK(c.axis == 0);
    CHECK(c.motion.name == "TOWN HALL, TOWN EARTHQUAKE, 90 DEG");
    CHECK(c.motion.dt == 0.02);
    REQUIRE(c.motion.acceleration.size() == 10);
    CHECK(c.motion.acceleration[9] == doctest::Approx(-2.505).epsilon(1e-14));
    CHECK(c.stated_peak == doctest::Approx(2.505).epsilon(1e-14));
    CHECK(channels[1].axis == 'V');
    CHECK(channels[1].motion.acceleration.size() == 3);
    CHECK(channels[2].axis == 0);
  }
}

TEST_CASE("CSMIP V2: the newer words, a printed format, glued columns") {
  const std::string newer = " 10 points of accel data equally spaced at  .005 sec, in cm/sec2. (5f10.6)\n";
  const std::string glued = "-10.000000-20.000000  1.000000  2.000000  3.000000\n  4.000000  5.000000  6.000000  7.000000-80.000000\n";
  std::string text = channel("90 DEG", kX);
  const std::size_t first = text.find(" 10 POINTS OF ACCEL DATA"), last = text.find(" 10 POINTS OF VELOC");
  text = text.substr(0, first) + newer + glued + text.substr(last);
  const auto channels = read_text(read_csmip, text);
  CHECK(channels[0].motion.dt == 0.005);
  REQUIRE(channels[0].motion.acceleration.size() == 10);
  CHECK(channels[0].motion.acceleration[1] == doctest::Approx(-0.2).epsilon(1e-14));
  CHECK(channels[0].motion.acceleration[9] == doctest::Approx(-0.8).epsilon(1e-14));
}

TEST_CASE("USC V2: COMP in place of CHAN, ACC for ACCEL, the unit without brackets, no end") {
  const auto usc = [](const std::string& accel, const std::string& unit, const std::string& end) {
    std::string text =
        "CORRECTED ACCELEROGRAM  XX000  COMP N00E   FILE   0\nFILE 0\nTOWN EARTHQUAKE\nJAN 1, 2000\nXX000\nSTATION\nTOWN HALL\n";
    text += "COMP N00E\nPEAK ACCELERATION =   250.50000  CMS/SEC/SEC AT    0.100   SEC.\n    1    1\n";
    for (const std::string& kind : {accel, std::string("VEL"), std::string("DIS")})
      text += "   10 POINTS OF " + kind + " DATA EQUALLY SPACED AT   .020 SEC.  " + unit + "\n" + columns(kX, 8, "%10.3f");
    return text + end;
  };
  for (const char* accel : {"ACC", "ACCEL"}) {
    for (const char* unit : {"IN UNITS CM/SEC/SEC", "IN UNITS OF CM/SEC/SEC", "(UNITS: CM/SEC/SEC)", "IN CM/SEC/SEC"}) {
      for (const char* end : {"/&\n", "", "\n\n"}) {
        const std::string one = usc(accel, unit, end);
        for (const std::string& text : {one, one + one}) {
          const auto channels = read_text(read_csmip, text);
          REQUIRE(channels.size() == text.size() / one.size());
          CHECK(channels[0].component == "N00E");
          CHECK(channels[0].motion.name == "TOWN HALL, TOWN EARTHQUAKE, N00E");
          CHECK(channels[0].motion.dt == 0.02);
          CHECK(channels[0].stated_peak == doctest::Approx(2.505).epsilon(1e-14));
          REQUIRE(channels.back().motion.acceleration.size() == 10);
          CHECK(channels.back().motion.acceleration[9] == doctest::Approx(-2.505).epsilon(1e-14));
        }
      }
    }
  }
}

TEST_CASE("CSMIP V2: faults, with their line") {
  check_fault(read_csmip, "", ":0: the file holds no acceleration");
  check_fault(read_csmip, "hello\n", ":1: the file ends before the line 'n POINTS OF ACCEL DATA EQUALLY SPACED AT s SEC. (UNITS: ...)'");
  std::string long_head = "CORRECTED ACCELEROGRAM\n";
  for (int i = 0; i < 100; ++i) long_head += "word\n";
  check_fault(read_csmip, long_head, ":81: no line 'n POINTS OF ACCEL DATA EQUALLY SPACED AT s SEC. (UNITS: ...)' in the first 80 lines");
  const auto spoilt = [](const std::string& from, const std::string& to) { return with(kFile, from, to); };
  check_fault(read_csmip, spoilt("(UNITS: CM/SEC/SEC)", ""), ":14: unit of acceleration '' is not known; allowed: g, m/s2, cm/s2 (gal)");
  check_fault(read_csmip, spoilt("(UNITS: CM/SEC/SEC)", "(UNITS: FT/SEC/SEC)"), ":14: unit of acceleration 'FT/SEC/SEC' is not known");
  check_fault(read_csmip, spoilt(" 10 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020", " 10 POINTS OF ACCEL DATA EQUALLY SPACED AT  zero"),
              ":14: EQUALLY SPACED AT is missing or no number; allowed: from 1e-6 to 10 s");
  check_fault(read_csmip, spoilt(" 10 POINTS OF ACCEL DATA", " ten POINTS OF ACCEL DATA"),
              ":14: the number of points is missing or no number");
  check_fault(read_csmip, spoilt(" 10 POINTS OF ACCEL DATA", " 11 POINTS OF ACCEL DATA"),
              ":16: value 3 of 3 is missing; wanted in columns 21 to 30");
  check_fault(read_csmip, spoilt(" 10 POINTS OF ACCEL DATA", " 8 POINTS OF ACCEL DATA"),
              ":16: '     9.000  -250.500' after the values; wanted");
  check_fault(read_csmip, spoilt(" 10 POINTS OF ACCEL DATA", " 999999999 POINTS OF ACCEL DATA"), ":16: value 3 of 8 is missing");
  check_fault(read_csmip, spoilt(" 10 POINTS OF VELOC DATA", " 99999 POINTS OF VELOC DATA"),
              ":63: the file ends before the values of velocity or displacement");
  check_fault(read_csmip, spoilt("    -4.000", "       NaN"), ":15: 'NaN' is not one finite number");
  check_fault(read_csmip, spoilt("    -4.000", "    -4.00x"), ":15: '-4.00x' is not one finite number");
  check_fault(read_csmip, before(kFile, "/&"), ":22: the file ends before '/&', the end of the channel");
  check_fault(read_csmip, spoilt(" 10 POINTS OF VELOC DATA", " 10 POINTS OF ACCEL DATA"),
              ":17: unit of acceleration 'CM/SEC' is not known");
  check_fault(
      read_csmip,
      spoilt("VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)", "ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)"),
      ":19: a second acceleration of one channel; wanted '/&' before the next channel");
  check_fault(read_csmip, with(spoilt("CHAN  1:  90 DEG\n", "PART\n"), "", ""),
              ":23: the head of the channel has no line 'CHAN n: direction'");
}

TEST_CASE("CSMIP V2: a file cut anywhere") { check_cuts(read_csmip, channel("90 DEG", kX)); }
