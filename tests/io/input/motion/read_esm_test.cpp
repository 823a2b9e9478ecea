// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_esm;

namespace {

const std::string kHeader =
    "EVENT_NAME: TOWN\nEVENT_DATE_YYYYMMDD: 20010203\nEVENT_TIME_HHMMSS: 12:00:00.5\nMAGNITUDE_W: \nNETWORK: XX\nSTATION_CODE: ABC\n"
    "SAMPLING_INTERVAL_S: 0.005000\nNDATA: 4\nDURATION_S: \nSTREAM: HNE\nUNITS: cm/s^2\nPGA_CM/S^2: -12.500000\n"
    "DATA_TYPE: ACCELERATION\nDATA_CREATOR: a: b\nUSER1: \nUSER5: \n";
const std::string kFile = kHeader + "-0.000000\n1.250000\n-12.500000\n0.5\n";

}  // namespace

TEST_CASE("ESM ASC: one component; LF, CRLF, blank lines at the end") {
  for (const std::string& text : {kFile, with_crlf(kFile), kFile + "\n\n", with(kFile, "ACCELERATION", "Acceleration")}) {
    const auto channels = read_text(read_esm, text);
    REQUIRE(channels.size() == 1);
    const Channel& c = channels[0];
    CHECK(c.component == "HNE");
    CHECK(c.motion.name == "XX.ABC, 20010203 12:00:00.5, HNE");
    CHECK(c.motion.dt == 0.005);
    REQUIRE(c.motion.acceleration.size() == 4);
    CHECK(c.motion.acceleration[1] == doctest::Approx(0.0125).epsilon(1e-14));
    CHECK(c.motion.acceleration[2] == doctest::Approx(-0.125).epsilon(1e-14));
    REQUIRE(c.stated_peak);
    CHECK(*c.stated_peak == doctest::Approx(0.125).epsilon(1e-14));
  }
}

TEST_CASE("ESM ASC: a peak that is not stated; the unit of the header") {
  CHECK_FALSE(read_text(read_esm, with(kFile, "PGA_CM/S^2: -12.500000", "PGA_CM/S^2: "))[0].stated_peak);
  CHECK(read_text(read_esm, with(kFile, "cm/s^2", "g"))[0].motion.acceleration[1] == doctest::Approx(1.25 * kG).epsilon(1e-14));
}

TEST_CASE("ESM ASC: faults, with their line") {
  check_fault(read_esm, "", ":0: the file ends before the header's last key, USER5");
  check_fault(read_esm, with(kFile, "USER5: \n", ""), ":16: '-0.000000': wanted 'KEY: value'");
  check_fault(read_esm, with(kFile, "NDATA: 4\n", ""), ":15: the header does not state 'NDATA'");
  check_fault(read_esm, with(kFile, "UNITS: cm/s^2\n", ""), ":15: the header does not state 'UNITS'");
  check_fault(read_esm, with(kFile, "UNITS: cm/s^2", "UNITS: "),
              ":11: unit of acceleration '' is not known; allowed: g, m/s2, cm/s2 (gal)");
  check_fault(read_esm, with(kFile, "DATA_TYPE: ACCELERATION", "DATA_TYPE: VELOCITY"),
              ":13: the file holds 'VELOCITY', wanted ACCELERATION");
  check_fault(read_esm, with(kFile, "S: 0.005000", "S: 0"), ":7: SAMPLING_INTERVAL_S is 0; allowed: from 1e-6 to 10 s");
  check_fault(read_esm, with(kFile, "S: 0.005000", "S: fast"), ":7: SAMPLING_INTERVAL_S is missing or no number");
  check_fault(read_esm, with(kFile, "NDATA: 4", "NDATA: -4"), ":8: NDATA is -4; allowed: a whole number of values, at least 2");
  check_fault(read_esm, with(kFile, "NDATA: 4", "NDATA: 1000000000000"),
              ":20: the file ends after 4 values, the header says 1000000000000");
  check_fault(read_esm, with(kFile, "NDATA: 4", "NDATA: 3"), ":20: '0.5' after the 3 values of the header");
  check_fault(read_esm, with(kFile, "1.250000\n", "nan\n"), ":18: 'nan' is not one finite number");
  check_fault(read_esm, with(kFile, "1.250000\n", "1.25-3.5\n"), ":18: '1.25-3.5' is not one finite number");
  check_fault(read_esm, with(kFile, "1.250000\n", "1.25 3.5\n"), ":18: '1.25 3.5' is not one finite number");
  check_fault(read_esm, with(kFile, "1.250000\n", "\n"), ":18: value 1 of 1 is missing");
}

TEST_CASE("ESM ASC: a file cut anywhere") { check_cuts(read_esm, kFile); }
