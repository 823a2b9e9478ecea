// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/motion/motion_files.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "io/input/motion/treatment.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;

namespace {

cases::Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return io::read_case({"test.toml", text}, overrides).value;
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const cases::InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("motion keys: window, baseline, taper and step are read, written back and used") {
  const std::string text =
      "[motion]\nrecord = \"bam-like\"\nfrom = 2.0\nto = 6.0\nbaseline = \"parabolic\"\ntaper = [0.5, 0.25]\ndt = 0.01\n";
  const cases::Case c = read(text);
  CHECK(c.motion->treatment.from == 2.0);
  CHECK(c.motion->treatment.to == 6.0);
  CHECK(c.motion->treatment.baseline == cases::Baseline::parabolic);
  CHECK(c.motion->treatment.taper == std::array{0.5, 0.25});
  CHECK(c.motion->dt == 0.01);
  CHECK(read("[motion]\nrecord = \"r\"\ntaper = 2").motion->treatment.taper == std::array{2.0, 2.0});
  const std::string resolved = io::resolved_toml(c);
  CHECK(io::resolved_toml(read(resolved)) == resolved);
  const cases::GroundMotion motion = io::load_motion(*c.motion, "");
  std::array<cases::Accelerogram, 3> expected = io::bam_like_1();
  io::treat(expected, c.motion->treatment, "motion.");
  CHECK(motion.axis[1].acceleration == expected[1].acceleration);
  CHECK(motion.axis[1].acceleration.size() == 801);
  CHECK(io::load_motion(*read("[motion]\nrecord = \"bam-like\"").motion, "").axis[1].acceleration == io::bam_like_1()[1].acceleration);
}

TEST_CASE("motion keys: what is out of range") {
  const std::string m = "[motion]\nrecord = \"bam-like\"\n";
  CHECK(refusal(m + "from = -1").starts_with("test.toml:3: motion.from = -1 s: must be >= 0"));
  CHECK(refusal(m + "to = 0").starts_with("test.toml:3: motion.to = 0 s: must be > 0"));
  CHECK(refusal(m + "from = 3\nto = 2").starts_with("test.toml:4: motion.to = 2 s: must be above motion.from"));
  CHECK(refusal(m + "baseline = \"flat\"").find("must be \"none\" | \"mean\" | \"linear\" | \"parabolic\"") != std::string::npos);
  CHECK(refusal(m + "taper = \"long\"").find("wanted a number or an array [start, end]") != std::string::npos);
  CHECK(refusal(m + "taper = -0.1").find("must be >= 0") != std::string::npos);
  CHECK(refusal(m + "dt = 0").find("must be in [1e-06, 10]") != std::string::npos);
  CHECK_THROWS_WITH_AS(io::load_motion(*read(m + "from = 30").motion, ""), doctest::Contains("motion.from: 30 s; allowed: from 0"),
                       cases::InputError);
}

TEST_CASE("motion keys: window and step are of the record, and go with it; taper and baseline stay") {
  const TempFolder folder;
  const std::string base =
      folder.write("base.toml", "[motion]\nrecord = \"bam-like\"\nfrom = 2\nto = 6\ndt = 0.01\ntaper = 0.5\nbaseline = \"mean\"\n");
  const cases::Case c = read("include = \"" + base + "\"\n[motion]\nL = \"a.AT2\"\n");
  CHECK(!c.motion->treatment.from);
  CHECK(!c.motion->treatment.to);
  CHECK(!c.motion->dt);
  CHECK(c.motion->treatment.taper == std::array{0.5, 0.5});
  CHECK(c.motion->treatment.baseline == cases::Baseline::mean);
  CHECK(read("include = \"" + base + "\"\n[motion]\nscale = 2\n").motion->treatment.from == 2.0);
}

TEST_CASE("one column: step and unit stated beside it") {
  const TempFolder folder;
  const std::string path = folder.write("one.csv", "# a column\n1\n2\n\n-3e0\n");
  const cases::Accelerogram a = io::read_motion_csv(path, {"g", 0.005});
  CHECK(a.dt == 0.005);
  CHECK(a.acceleration == std::vector{9.80665, 2 * 9.80665, -3 * 9.80665});
  CHECK(io::read_motion_csv(folder.write("h.csv", "a [cm/s2]\n100\n200\n"), {std::nullopt, 0.1}).acceleration == std::vector{1.0, 2.0});
  // Where the times are in the file, they hold.
  CHECK(io::read_motion_csv(folder.write("two.csv", "0,1\n0.5,2\n"), {"g", 0.005}).dt == 0.5);
  const auto fault = [&](const std::string& text, const io::Unstated& u, const char* message) {
    CHECK_THROWS_WITH_AS(io::read_motion_csv(folder.write("f.csv", text), u), doctest::Contains(message), io::FileError);
  };
  fault("1\n2\n", {"g"}, ":1: one column, and its step is not stated; wanted two columns: time [s], acceleration, or dt beside it");
  fault("1\n2\n", {std::nullopt, 0.1}, "give the file a header line 'a [m/s2]'");
  fault("1\n2,3\n", {"g", 0.1}, ":2: more than one column, and the rows before have one");
  fault("1\nx\n", {"g", 0.1}, ":2: acceleration 'x' is no finite number");
  fault("1\n", {"g", 0.1}, "holds one number; allowed: 2 or more");
}

TEST_CASE("one column: in a folder with record.toml, and in a case") {
  const TempFolder folder;
  folder.write("site/record.toml", "unit = \"g\"\ndt = 0.02\nT = \"t.txt\"\n");
  folder.write("site/t.txt", "1\n2\n3\n");
  const io::Record r = io::read_record_folder(folder.path("site"), {});
  CHECK(r.ltv[1].dt == 0.02);
  CHECK(r.ltv[1].acceleration[2] == 3 * 9.80665);
  cases::Motion m;
  m.xyz[0] = "t.txt";
  m.unit = "cm/s2";
  m.dt = 0.5;
  CHECK(io::load_motion(m, folder.path("site")).axis[0].dt == 0.5);
  for (const char* dt : {"0", "-1", "\"0.02\"", "11"}) {
    folder.write("site/record.toml", std::string("unit = \"g\"\ndt = ") + dt + "\nT = \"t.txt\"\n");
    CHECK_THROWS_WITH_AS(io::read_record_folder(folder.path("site"), {}),
                         doctest::Contains(":2: dt is no step; allowed: a number from 1e-6 to 10, in s"), io::FileError);
  }
}
