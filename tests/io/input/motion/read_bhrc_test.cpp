// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_bhrc;

namespace {

const std::vector<double> kL{0.01, -0.02, 0.5, 0, 0, 0, 0, 0, 0, -0.25, 1.0, 2.0}, kV{0.1, 0.2, -0.3};

const std::string kFile = bhrc_component('L', kL, 0.06) + bhrc_component('V', kV, 0.015) + bhrc_component('T', kL, 0.06);

}  // namespace

TEST_CASE("BHRC V1: three components, tenths of g, the step from the duration, LF or CRLF") {
  for (const std::string& text : {kFile, with_crlf(kFile)}) {
    const auto channels = read_text(read_bhrc, text);
    REQUIRE(channels.size() == 3);
    const std::string order = "LVT";
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(channels[i].component == std::string(1, order[i]));
      CHECK(channels[i].axis == order[i]);
      CHECK(channels[i].motion.dt == doctest::Approx(0.005).epsilon(1e-12));
      CHECK_FALSE(channels[i].stated_peak);
    }
    CHECK(channels[0].motion.name == "Town, 2001/02/03   12:00:00, L");
    REQUIRE(channels[0].motion.acceleration.size() == 12);
    CHECK(channels[0].motion.acceleration[0] == doctest::Approx(0.001 * kG).epsilon(1e-12));  // not moved by a baseline
    CHECK(channels[0].motion.acceleration[9] == doctest::Approx(-0.025 * kG).epsilon(1e-12));
    CHECK(channels[1].motion.acceleration[2] == doctest::Approx(-0.03 * kG).epsilon(1e-12));
  }
}

TEST_CASE("BHRC V1: glued columns part") {
  const std::string glued = with(kFile, " 1.000000E-02", "-1.234567E-02");
  const auto channels = read_text(read_bhrc, glued);
  CHECK(channels[0].motion.acceleration[0] == doctest::Approx(-0.001234567 * kG).epsilon(1e-12));
  CHECK(channels[0].motion.acceleration[1] == doctest::Approx(-0.002 * kG).epsilon(1e-12));
}

TEST_CASE("BHRC V1: faults, with their line") {
  const std::string mark = "UNITS ARE SECONDS AND G/10";
  check_fault(read_bhrc, "", ":0: the file holds no acceleration");
  check_fault(read_bhrc, "hello\n", ":1: 'hello': wanted '* VOL1DS FILE', the head of a component");
  check_fault(read_bhrc, with(kFile, "     12 ", "     13 "), ":29: value 3 of 3 is missing; wanted in columns 27 to 39");
  check_fault(read_bhrc, with(kFile, "     12 ", "     11 "), ":29: more than the 1 values wanted on this line");
  check_fault(read_bhrc, with(kFile, "     12 ", "     10 "),
              ":29: ' 1.000000E+00 2.000000E+00' after the 10 values of the header; wanted '/&'");
  check_fault(read_bhrc, with(kFile, "     12 ", "    two "), ":11: NO. OF POINTS is missing or no number; allowed: a whole number");
  check_fault(read_bhrc, with(kFile, "     12 ", "   12.5 "), ":11: NO. OF POINTS is 12.5; allowed: a whole number of values, at least 2");
  check_fault(read_bhrc, with(kFile, "  0.060", "  0.000"), ":11: DURATION / NO. OF POINTS is 0; allowed: from 1e-6 to 10 s");
  check_fault(read_bhrc, with(kFile, "DURATION", "TIME"), ":11: DURATION / NO. OF POINTS is missing or no number");
  check_fault(read_bhrc, with(kFile, mark, "UNITS ARE SECONDS AND MILES"),
              ":12: unit of acceleration 'MILES' is not known; allowed: g, m/s2");
  check_fault(read_bhrc, with(kFile, mark, "UNITS ARE TENS"), ":12: 'UNITS ARE TENS': wanted 'UNITS ARE SECONDS AND G/10'");
  check_fault(read_bhrc, with(kFile, mark, "UNITS ARE SECONDS AND G/0"), ":12: unit 'UNITS ARE SECONDS AND G/0' is divided by less than 1");
  check_fault(read_bhrc, with(kFile, mark, "VOLTS"), ":31: no line 'UNITS ARE SECONDS AND G/10' in the first 30 lines");
  check_fault(read_bhrc, with(kFile, "COMP L1", "PART L1"), ":12: no line 'COMP L', 'COMP T' or 'COMP V' before this one");
  check_fault(read_bhrc, with(kFile, "NO. OF POINTS", "HOW MANY"), ":12: no line 'NO. OF POINTS = n  DURATION = s' before this one");
  check_fault(read_bhrc, with(kFile, " 5.000000E-01", "          NaN"), ":28: 'NaN' is not one finite number");
  check_fault(read_bhrc, with(kFile, " 5.000000E-01", "*************"), ":28: '*************' is not one finite number");
  check_fault(read_bhrc, with(kFile, " 5.000000E-01", "5.000000E+999"), ":28: '5.000000E+999' is not one finite number");
  check_fault(read_bhrc, before(kFile, "/&"), ":29: the file ends before '/&', the end of the component");
  check_fault(read_bhrc, with(kFile, "     12 ", "   9999 "), ":29: value 3 of 10 is missing");
}

TEST_CASE("BHRC V1: a file cut anywhere") { check_cuts(read_bhrc, kFile); }
