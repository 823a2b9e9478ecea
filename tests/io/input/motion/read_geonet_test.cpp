// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_geonet;

namespace {

const std::vector<double> kA{0.0, -0.0, 1.5, -6454.0, -10565.6, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, -9.0}, kSmall(12, -0.00001);

std::string component(const std::string& direction, const std::string& axis) {
  std::string text =
      "Corrected accelerogram 20010203_120000_ABC_20 GNS Science\nSite ABC      39 56 38S  176 35 04E     Basalt file: x\nTown Hall\n"
      "Instrument\nResolution\nAccelerogram\n6 km south of Town\n2001 February 3         12:00:00 UT\nEpicentre\n"
      "Number of points    12    Duration 0.22 sec\nInstrument corrected data at 0.020 sec intervals\nFilter\nComponent " +
      direction + "  " + axis +
      " Accelerometer Axis\nAcceleration:  peak -10565.6 mm/s/s at   5.08 sec     rms      2.2 mm/s/s\nVelocity:\nDisplacement:\n";
  for (int i = 0; i < 10; ++i) text += "       0       0\n";
  return text + columns(kA, 10, "%8.1f") + columns(kSmall, 10, "%8.5f") + columns(kSmall, 10, "%8.5f");
}

const std::string kFile = component("S16W", "Longitudinal") + component("S74E", "Transverse") + component("Up", "  Vertical");

}  // namespace

TEST_CASE("GeoNet V2A: three components in mm/s2, glued where they are large, LF or CRLF") {
  for (const std::string& text : {kFile, with_crlf(kFile)}) {
    const auto channels = read_text(read_geonet, text);
    REQUIRE(channels.size() == 3);
    const std::string order = "LTV";
    for (std::size_t i = 0; i < 3; ++i) CHECK(channels[i].axis == order[i]);
    const Channel& c = channels[0];
    CHECK(c.component == "S16W");
    CHECK(c.motion.name == "ABC, 2001 February 3         12:00:00 UT, S16W");
    CHECK(c.motion.dt == 0.02);
    REQUIRE(c.motion.acceleration.size() == 12);
    CHECK(c.motion.acceleration[3] == doctest::Approx(-6.454).epsilon(1e-14));
    CHECK(c.motion.acceleration[4] == doctest::Approx(-10.5656).epsilon(1e-14));
    CHECK(c.motion.acceleration[11] == doctest::Approx(-0.009).epsilon(1e-14));
    CHECK(c.stated_peak == doctest::Approx(10.5656).epsilon(1e-14));
  }
}

TEST_CASE("GeoNet V2A: down is not V") { CHECK(read_text(read_geonet, component("Down", "Vertical"))[0].axis == 0); }

TEST_CASE("GeoNet V2A: faults, with their line") {
  const auto spoilt = [](const std::string& from, const std::string& to) { return with(kFile, from, to); };
  check_fault(read_geonet, "", ":0: the file holds no acceleration");
  check_fault(read_geonet, "hello\n", ":1: 'hello': wanted 'Corrected accelerogram', the head of a component");
  check_fault(read_geonet, spoilt("Number of points    12", "Number of points     x"), ":10: Number of points is missing or no number");
  check_fault(read_geonet, spoilt("Number of points", "Points"), ":16: no line 'Number of points n' in the component's 16 lines of text");
  check_fault(read_geonet, spoilt("at 0.020 sec", "at 20.00 sec"), ":11: the interval is 20; allowed: from 1e-6 to 10 s");
  check_fault(read_geonet, spoilt("sec intervals", "steps"),
              ":16: no line '... data at s sec intervals' in the component's 16 lines of text");
  check_fault(read_geonet, spoilt("Component S16W", "Part S16W"), ":16: no line 'Component ...' in the component's 16 lines of text");
  check_fault(read_geonet, spoilt("Acceleration:  peak", "Peak"),
              ":16: no line 'Acceleration: peak a mm/s/s at ...' in the component's 16 lines");
  check_fault(read_geonet, spoilt("mm/s/s at", "mm/s at"),
              ":14: unit of acceleration 'mm/s' is not known; allowed: g, m/s2, cm/s2 (gal), mm/s2");
  check_fault(read_geonet, spoilt("points    12", "points    11"), ":28: more than the 1 values wanted on this line");
  check_fault(read_geonet, spoilt("points    12", "points    13"), ":28: value 3 of 3 is missing; wanted in columns 17 to 24");
  check_fault(read_geonet, spoilt("     1.5", "     nan"), ":27: 'nan' is not one finite number");
  check_fault(read_geonet, spoilt("     1.5", "     1,5"), ":27: '1,5' is not one finite number");
  check_fault(read_geonet, before(component("N", "x"), "-0.00001"), ":28: the file ends before the values of velocity");
  check_fault(read_geonet, kFile + "1.0\n", ":97: '1.0': wanted 'Corrected accelerogram', the head of a component");
}

TEST_CASE("GeoNet V2A: a file cut anywhere") { check_cuts(read_geonet, component("N", "Longitudinal")); }
