// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/io/input/motion/motion_fixture.h"

using namespace motion_fixture;
using voussoir::io::read_cosmos;

namespace {

struct Layout {
  int integers_per_line = 10, reals_per_line = 5;
  const char* integer = "%8.0f";
  const char* real = "%15.6f";
  const char* format_of_reals = "(5F15.6)";
};

/// One channel. The data stand below its line as given.
std::string channel(double azimuth, const std::string& data_line, const std::string& data, const Layout& l = {}) {
  std::string text =
      "Corrected acceleration    (Format v01.20 with 9 text lines)\nRecord of Town Earthquake\nHypocenter: 1 2\nOrigin: today\n";
  text +=
      "Statn No: 01-1  Code:XX-ABC  Town Hall\nCoords: 1 2\nRecorder: SSA-2\nStart: 0\nSta Cha:  1: North wall (Rcrdr Chan  1) Location:\n";
  std::vector<double> integers(100, -999.0), reals(100, -999.0);
  integers[54 - 1] = azimuth;
  reals[34 - 1] = 0.02;  // the raw record's step, s: not this one's
  reals[62 - 1] = 5.0;   // ms
  reals[64 - 1] = -142.963;
  text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" + columns(integers, l.integers_per_line, l.integer);
  text += " 100 Real-header values follow on  20 lines, Format= " + std::string(l.format_of_reals) + "\n" +
          columns(reals, l.reals_per_line, l.real);
  return text + "  2 Comment line(s) follow, each starting with a \"|\":\n | plain\n|<SCNL>ABC.HNZ.XX.--    <AUTH> today\n" + data_line +
         "\n" + data;
}

const std::string kGluedLine = "   10  acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(8F10.5)";
const std::string kGlued =
    "   -.00001    .00013  67.22464-142.96300-143.07690-125.54300 -10.00000    .00019\n    .50000   -.50000\n/&  ----------  End of data\n";
const std::string kFile = channel(340, kGluedLine, kGlued);

}  // namespace

TEST_CASE("COSMOS: glued columns, the step in milliseconds, LF or CRLF") {
  for (const std::string& text : {kFile, with_crlf(kFile)}) {
    const auto channels = read_text(read_cosmos, text);
    REQUIRE(channels.size() == 1);
    const Channel& c = channels[0];
    CHECK(c.component == "340 deg");
    CHECK(c.axis == 0);
    CHECK(c.motion.name == "XX-ABC  Town Hall, Record of Town Earthquake, 340 deg");
    CHECK(c.motion.dt == 0.005);
    REQUIRE(c.motion.acceleration.size() == 10);
    CHECK(c.motion.acceleration[3] == doctest::Approx(-1.42963).epsilon(1e-14));
    CHECK(c.motion.acceleration[4] == doctest::Approx(-1.430769).epsilon(1e-14));
    CHECK(c.motion.acceleration[9] == doctest::Approx(-0.005).epsilon(1e-14));
    CHECK(c.stated_peak == doctest::Approx(1.42963).epsilon(1e-14));
  }
}

TEST_CASE("COSMOS: other layouts of header and data, several channels, velocity passed over") {
  const std::string narrow_line = "  3 acceleration pts, approx  0 secs, units=g(02),Format=(1E15.6)";
  const std::string narrow = "   3.437285e-04\n  -5.000000e-01\n   1.000000e-01\nEnd-of-data for ChanHNZ acceleration\n";
  const Layout sixes{10, 6, "%8.0f", "%13.6f", "(6F13.6)"};
  std::string velocity_line = with(kGluedLine, "acceleration", "velocity");
  const std::string text =
      kFile + channel(400, narrow_line, narrow, sixes) + "\n" + channel(400, velocity_line, kGlued) + channel(0, kGluedLine, kGlued);
  const auto channels = read_text(read_cosmos, text);
  REQUIRE(channels.size() == 3);
  CHECK(channels[1].component == "UP");
  CHECK(channels[1].axis == 'V');
  CHECK(channels[1].motion.acceleration == std::vector<double>{3.437285e-04 * kG, -0.5 * kG, 0.1 * kG});
  CHECK(channels[2].component == "HNZ");  // no azimuth: the code of the channel
  CHECK(read_text(read_cosmos, with(channel(0, kGluedLine, kGlued), "<SCNL>", "<NONE>"))[0].component == "North wall");
  CHECK(read_text(read_cosmos, channel(401, kGluedLine, kGlued))[0].axis == 0);  // DOWN is not V
}

TEST_CASE("COSMOS: an unknown peak is not stated") {
  CHECK_FALSE(read_text(read_cosmos, with(kFile, "    -142.963000", "    -999.000000"))[0].stated_peak);
}

TEST_CASE("COSMOS: a gap in the data is no acceleration") {
  std::string gap = kGlued;
  gap.replace(gap.find(" -10.00000"), 10, "-999.00000");
  CHECK_THROWS_WITH_AS(read_text(read_cosmos, channel(340, kGluedLine, gap)),
                       doctest::Contains("value 7 of the data is -999, which stands for one that is not known"), voussoir::io::FileError);
}

TEST_CASE("COSMOS: faults, with their line") {
  check_fault(read_cosmos, "", ":0: the file holds no acceleration");
  check_fault(read_cosmos, "hello\n", ":1: 'hello': wanted the head of a channel, '... (Format v01.20 with 13 text lines)'");
  check_fault(read_cosmos, with(kFile, "with 9 text", "with nine text"), ":1: the number of text lines is missing or no number");
  check_fault(read_cosmos, with(kFile, "with 9 text", "with 8 text"),
              ":9: 'Sta Cha:  1: North wall (Rcrdr Chan  1) ...': wanted '100 Integer");
  check_fault(read_cosmos, with(kFile, "Format= (10I8)", "Format= free"),
              ":10: ' 100 Integer-header values follow on  10...' prints no Format");
  check_fault(read_cosmos, with(kFile, "Format= (10I8)", "Format= (0I8)"),
              ":10: ' 100 Integer-header values follow on  10...' prints no Format");
  check_fault(read_cosmos, with(kFile, " 100 Integer", " 200 Integer"), ":21: '100 Rea' is not one finite number");
  check_fault(read_cosmos, with(kFile, "       5.000000", "    -999.000000"),
              ":45: the step (ms / 1000, value 62 of the real header) is -0.999");
  check_fault(read_cosmos, with(kFile, "  2 Comment", "  3 Comment"),
              ":45: '   10  acceleration pts, approx    0 sec...': a comment must start");
  check_fault(read_cosmos, with(kFile, "  2 Comment", "two Comment"),
              ":42: 'two Comment line(s) follow, each startin...': wanted 'n Comment");
  check_fault(read_cosmos, with(kFile, "units=cm/sec2(04),", ""), ":45: unit of acceleration '' is not known");
  check_fault(read_cosmos, with(kFile, "units=cm/sec2(04)", "units=counts(50)"), ":45: unit of acceleration 'counts' is not known");
  check_fault(read_cosmos, with(kFile, ",Format=(8F10.5)", ""), ":45: '   10  acceleration pts, approx    0 sec...' prints no Format");
  check_fault(read_cosmos, with(kFile, "   10  acc", "   11  acc"), ":47: value 3 of 3 is missing");
  check_fault(read_cosmos, with(kFile, "   10  acc", "    9  acc"), ":47: more than the 1 values wanted on this line");
  check_fault(read_cosmos, with(kFile, "   10  acc", "    8  acc"), ":47: '    .50000   -.50000' after the values; wanted 'End-of-data");
  check_fault(read_cosmos, with(kFile, "  67.22464", "       NaN"), ":46: 'NaN' is not one finite number");
  check_fault(read_cosmos, with(kFile, "  67.22464", "   67.2x64"), ":46: '67.2x64' is not one finite number");
  check_fault(read_cosmos, channel(1, with(kGluedLine, "acceleration", "velocity"), kGlued), ":48: the file holds no acceleration");
}

TEST_CASE("COSMOS: a file cut anywhere") { check_cuts(read_cosmos, kFile); }
