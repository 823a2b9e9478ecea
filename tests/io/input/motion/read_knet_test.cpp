// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_knet;

namespace {

// Twenty counts about an offset of -12000, whose deviations add up to zero; one count is 2000 gal / 8,000,000.
const std::string kFile =
    "Origin Time       2001/02/03 12:00:00\nLat.              41.0\nLong.             142.5\nDepth. (km)       30\nMag.              6.2\n"
    "Station Code      ABC001\nStation Lat.      41.5\nStation Long.     140.9\nStation Height(m) 39\n"
    "Record Time       2001/02/03 12:00:15\nSampling Freq(Hz) 10Hz\nDuration Time(s)  2\nDir.              E-W\n"
    "Scale Factor      2000(gal)/8000000\nMax. Acc. (gal)   0.250\nLast Correction   2001/02/03 12:00:00\nMemo.             \n"
    "  -12000   -12000   -11000   -13000   -12000   -12000   -12000   -12000 \n"
    "  -12000   -12000   -12000   -12000   -12000   -12000   -12000   -12000 \n"
    "  -11500   -12500   -12000   -12000 \n";

}  // namespace

TEST_CASE("K-NET: counts about their mean, scaled") {
  for (const std::string& text : {kFile, with_crlf(kFile)}) {
    const auto channels = read_text(read_knet, text);
    REQUIRE(channels.size() == 1);
    const Channel& c = channels[0];
    CHECK(c.component == "E-W");
    CHECK(c.motion.name == "ABC001, 2001/02/03 12:00:00, E-W");
    CHECK(c.motion.dt == 0.1);
    REQUIRE(c.motion.acceleration.size() == 20);
    CHECK(c.motion.acceleration[0] == 0.0);
    CHECK(c.motion.acceleration[2] == doctest::Approx(1000.0 * 0.01 * 2000.0 / 8.0e6).epsilon(1e-14));
    CHECK(c.motion.acceleration[17] == doctest::Approx(-500.0 * 0.01 * 2000.0 / 8.0e6).epsilon(1e-14));
    REQUIRE(c.stated_peak);
    CHECK(*c.stated_peak == doctest::Approx(c.motion.acceleration[2]).epsilon(1e-12));
  }
}

TEST_CASE("K-NET: faults, with their line") {
  check_fault(read_knet, "", ":0: the file ends before the end of the header, which has 17 lines");
  check_fault(read_knet, with(kFile, "Scale Factor ", "Scale Doctor "), ":17: the header does not state 'Scale Factor'");
  check_fault(read_knet, with(kFile, "2000(gal)", "2000"), ":14: Scale Factor '2000/8000000'; wanted as in '3920(gal)/6182761'");
  check_fault(read_knet, with(kFile, "8000000", "0"), ":14: Scale Factor '2000(gal)/0'; wanted");
  check_fault(read_knet, with(kFile, "2000(gal)", "2000(kine)"), ":14: unit of acceleration 'kine' is not known; allowed: g, m/s2");
  check_fault(read_knet, with(kFile, "10Hz", "0Hz"), ":11: 1 / Sampling Freq(Hz) is inf; allowed: from 1e-6 to 10 s");
  check_fault(read_knet, with(kFile, "10Hz", "-Hz"), ":11: 1 / Sampling Freq(Hz) is missing or no number");
  check_fault(read_knet, with(kFile, "(s)  2", "(s)  0"), ":12: Duration Time(s) * Sampling Freq(Hz) is 0; allowed: a whole number");
  check_fault(read_knet, with(kFile, "(s)  2", "(s)  x"), ":12: Duration Time(s) * Sampling Freq(Hz) is missing or no number");
  check_fault(read_knet, with(kFile, "(s)  2", "(s)  3"), ":20: value 5 of 8 is missing; wanted in columns 37 to 45");
  check_fault(read_knet, with(kFile, "(s)  2", "(s)  1.6"),
              ":20: '  -11500   -12500   -12000   -12000 ' after the 16 values of the header");
  check_fault(read_knet, with(kFile, "  -11000", "  -110.5"), ":20: the values hold -110.5; allowed: whole numbers of 32 bits");
  check_fault(read_knet, with(kFile, "  -11000", "    9E99"), ":20: the values hold 9e+99; allowed: whole numbers of 32 bits");
  check_fault(read_knet, with(kFile, "  -11000", "     nan"), ":18: 'nan' is not one finite number");
  check_fault(read_knet, with(kFile, "2000(gal)/8000000", "1e300(gal)/1e-300"), ":20: the scale factor is out of range");
}

TEST_CASE("K-NET: a file cut anywhere") {
  // A number that had lost digits would shift the mean of all.
  int read = 0;
  for (std::size_t size = 0; size < kFile.size(); ++size) {
    try {
      const auto channels = read_text(read_knet, kFile.substr(0, size));
      REQUIRE(channels[0].motion.acceleration.size() == 20);
      ++read;
    } catch (const voussoir::io::FileError&) {
    }
  }
  CHECK(read == 1);  // all but the end of the last line
}
