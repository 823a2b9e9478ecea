// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/motion_files.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "cases/input_error.h"
#include "cases/model.h"
#include "cases/tables/motion.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/motion/support_motion.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
using io::FileError;
using io::load_motion;

namespace {

/// A record folder "quake" whose components are constant: L = 1, T = 2, V = 3 m/s2.
void write_quake(const TempFolder& folder) {
  folder.write("quake/record.toml", "name = \"Quake\"\nL = \"l.csv\"\nT = \"t.csv\"\nV = \"v.csv\"\nunit = \"m/s2\"\n");
  folder.write("quake/l.csv", "0,1\n0.1,1\n");
  folder.write("quake/t.csv", "0,2\n0.2,2\n0.4,2\n");
  folder.write("quake/v.csv", "t [s], a [cm/s2]\n0,300\n0.3,300\n");
}

cases::Motion of_record(const std::string& record, const std::string& direction = "LTV") {
  cases::Motion m;
  m.record = record;
  m.direction = direction;
  return m;
}

Vec3 at_start(const cases::GroundMotion& m) { return acceleration_at(m, 0.0); }

/// Expects an InputError at the key, with this in its message.
void check_input_fault(const cases::Motion& m, const std::string& folder, const std::string& key, const std::string& message) {
  CAPTURE(message);
  try {
    load_motion(m, folder);
    FAIL("no error");
  } catch (const cases::InputError& e) {
    CHECK(e.key() == key);
    CHECK(e.problem().find(message) != std::string::npos);
  }
}

void check_record_fault(const std::string& text, const std::string& message) {
  const TempFolder folder;
  folder.write("quake/v.csv", "t [s], a [m/s2]\n0,1\n0.1,1\n");
  const std::string path = folder.write("quake/record.toml", text);
  CAPTURE(message);
  try {
    load_motion(of_record("quake"), folder.path());
    FAIL("no error");
  } catch (const FileError& e) {
    const std::string what = e.what();
    CHECK(what.substr(0, path.size() + message.size()) == path + message);
  }
}

}  // namespace

TEST_CASE("the built-in record by name") {
  const cases::GroundMotion m = load_motion(of_record("bam-like"), "/nowhere");
  const auto r = io::bam_like_1();
  for (std::size_t i = 0; i < 3; ++i) CHECK(m.axis[i].acceleration == r[i].acceleration);
}

TEST_CASE("realisations of the built-in record by number") {
  for (const int n : {1, 7}) {
    const cases::GroundMotion m = load_motion(of_record("bam-like#" + std::to_string(n)), "/nowhere");
    CHECK(m.axis[0].acceleration == io::bam_like(n)[0].acceleration);
  }
  CHECK(load_motion(of_record("bam-like-1"), "/nowhere").axis[0].acceleration == io::bam_like_1()[0].acceleration);
  for (const char* wrong : {"bam-like#", "bam-like#0", "bam-like#1000", "bam-like#-1", "bam-like#07", "bam-like#7.5", "bam-like#x"}) {
    check_input_fault(of_record(wrong), "/nowhere", "motion.record",
                      "\"" + std::string(wrong) + "\" names no realisation; allowed: \"bam-like\", \"bam-like#N\" with N from 1 to 999");
  }
}

TEST_CASE("a record folder, every direction") {
  const TempFolder folder;
  write_quake(folder);
  CHECK(at_start(load_motion(of_record("quake", "LTV"), folder.path())) == Vec3{1, 2, 3});
  CHECK(at_start(load_motion(of_record("quake", "TLV"), folder.path())) == Vec3{2, 1, 3});
  CHECK(at_start(load_motion(of_record("quake", "LVT"), folder.path())) == Vec3{1, 3, 2});
  CHECK(at_start(load_motion(of_record("quake", "TVL"), folder.path())) == Vec3{2, 3, 1});
  CHECK(at_start(load_motion(of_record("quake", "VLT"), folder.path())) == Vec3{3, 1, 2});
  CHECK(at_start(load_motion(of_record("quake", "VTL"), folder.path())) == Vec3{3, 2, 1});
}

TEST_CASE("components keep their own step and length") {
  const TempFolder folder;
  write_quake(folder);
  const cases::GroundMotion m = load_motion(of_record("quake"), folder.path());
  CHECK(m.axis[0].dt == doctest::Approx(0.1));
  CHECK(m.axis[1].dt == doctest::Approx(0.2));
  CHECK(m.axis[1].acceleration.size() == 3);
  CHECK(acceleration_at(m, 0.25) == Vec3{0, 2, 3});
}

TEST_CASE("scales belong to L, T, V before the turn, to x, y, z where files are given so") {
  const TempFolder folder;
  write_quake(folder);
  cases::Motion m = of_record("quake", "TLV");
  m.scale = {10.0, 100.0, -1000.0};
  CHECK(at_start(load_motion(m, folder.path())) == Vec3{200, 10, -3000});
  cases::Motion axes;
  axes.xyz = {"quake/t.csv", "quake/l.csv", std::nullopt};
  axes.unit = "m/s2";
  axes.direction = "VTL";  // says nothing here
  axes.scale = {10.0, 100.0, 1000.0};
  CHECK(at_start(load_motion(axes, folder.path())) == Vec3{20, 100, 0});
}

TEST_CASE("files for L, T, V in the case; an absent axis stays at rest; the unit of the case") {
  const TempFolder folder;
  write_quake(folder);
  cases::Motion m;
  m.ltv = {"quake/l.csv", std::nullopt, folder.path("quake/v.csv")};
  m.direction = "VLT";
  m.unit = "g";
  const cases::GroundMotion got = load_motion(m, folder.path());
  CHECK(at_start(got) == Vec3{3, 9.80665, 0});
  CHECK(got.axis[2].acceleration.empty());
}

TEST_CASE("the unit in record.toml wins over the case's, the unit in the file over both") {
  const TempFolder folder;
  write_quake(folder);
  cases::Motion m = of_record("quake");
  m.unit = "g";
  CHECK(at_start(load_motion(m, folder.path())) == Vec3{1, 2, 3});
}

TEST_CASE("a record of one component") {
  const TempFolder folder;
  folder.write("up/record.toml", "V = \"v.csv\"\n");
  folder.write("up/v.csv", "t [s], a [m/s2]\n0,5\n1,5\n");
  const io::Record r = io::read_record_folder(folder.path("up"), {});
  CHECK(r.name == "up");
  CHECK(io::read_record_folder(folder.path("up/"), {}).name == "up");
  CHECK(r.ltv[0].acceleration.empty());
  CHECK(at_start(load_motion(of_record("up"), folder.path())) == Vec3{0, 0, 5});
}

TEST_CASE("faults of the case name the key and what is allowed") {
  const TempFolder folder;
  const std::string f = folder.path();
  check_input_fault(of_record("kobe"), f, "motion.record", "\"kobe\" is neither a record of the program nor a folder or file");
  check_input_fault(
      of_record("kobe"), f, "motion.record",
      "allowed: \"bam-like\", \"bam-like#N\" with N from 1 to 999, a folder that holds record.toml, or a file that holds L, T and V");
  check_input_fault(of_record(""), f, "motion.record", "\"\" is neither");
  for (const std::string direction : {"LLV", "LT", "LTVV", "ltv", "", "XYZ"}) {
    check_input_fault(of_record("bam-like", direction), f, "motion.direction",
                      "\"" + direction + "\" is no order of L, T and V; allowed: LTV");
  }
  cases::Motion m = of_record("bam-like");
  m.scale.fill(1e308);
  check_input_fault(m, f, "motion.scale", "makes accelerations that are no finite numbers");
  m.scale.fill(1.0);
  m.unit = "furlongs";
  check_input_fault(m, f, "motion.unit", "\"furlongs\" is no unit of acceleration; allowed: \"g\", \"m/s2\" or \"cm/s2\"");
  m = of_record("bam-like");
  m.scale[1] = std::numeric_limits<double>::quiet_NaN();
  check_input_fault(m, f, "motion.scale", "is nan; allowed: finite numbers");
  check_input_fault(cases::Motion{}, f, "motion", "names no ground motion; allowed: record, or files for x, y, z, or files for L, T, V");
  m = of_record("bam-like");
  m.xyz[0] = "a.AT2";
  check_input_fault(m, f, "motion", "more than one way");
  m = cases::Motion{};
  m.xyz[0] = "a.AT2";
  m.ltv[1] = "b.AT2";
  check_input_fault(m, f, "motion", "more than one way");
}

TEST_CASE("a missing file of the case is named with its path") {
  const TempFolder folder;
  cases::Motion m;
  m.xyz[1] = "gone.AT2";
  CHECK_THROWS_WITH_AS(load_motion(m, folder.path()), (folder.path("gone.AT2") + ": no such file").c_str(), FileError);
}

TEST_CASE("faults of record.toml, with their line") {
  check_record_fault("", ": names no component; allowed: L, T, V");
  check_record_fault("name = \"x\"\n", ": names no component");
  check_record_fault("V = \"v.csv\"\nW = \"w.csv\"\n", ":2: key 'W' is not known; allowed: L, T, V, name, unit");
  check_record_fault("V = 3\n", ":1: V is no text; allowed: a string in quotes");
  check_record_fault("V = \"v.csv\"\nname = \"\"\n", ":2: name is no text");
  check_record_fault("V = \"v.csv\"\n\nunit = \"ft\"\n", ":3: unit 'ft' is not known; allowed: \"g\"");
  check_record_fault("V = \"v.csv\nL = 1", ":1: ");
  check_record_fault(std::string(3000, '['), ":1: ");
  const TempFolder folder;
  std::filesystem::create_directories(folder.path("empty"));
  CHECK_THROWS_WITH_AS(load_motion(of_record("empty"), folder.path()), doctest::Contains("record.toml: no such file"), FileError);
  folder.write("empty/record.toml", "\nV = \"v.csv\"\n");
  CHECK_THROWS_WITH_AS(load_motion(of_record("empty"), folder.path()), doctest::Contains("record.toml:2: V cannot be used: "), FileError);
}

TEST_CASE("a record written is the record read") {
  const TempFolder folder;
  const io::Record record{"bam-like \"copy\"", io::bam_like_1()};
  io::write_record_folder(record, folder.path("out/copy"), false);
  const io::Record back = io::read_record_folder(folder.path("out/copy"), {});
  CHECK(back.name == record.name);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(back.ltv[i].acceleration == record.ltv[i].acceleration);
    CHECK(back.ltv[i].dt == doctest::Approx(record.ltv[i].dt).epsilon(1e-12));
  }
  CHECK_THROWS_WITH_AS(io::write_record_folder(record, folder.path("out/copy"), true), doctest::Contains("is an input"), FileError);
  io::start_command();
  CHECK_THROWS_WITH_AS(io::write_record_folder(record, folder.path("out/copy"), false),
                       doctest::Contains("exists; --overwrite replaces it"), FileError);
  io::write_record_folder({"other", {}}, folder.path("out/copy"), true);
  folder.write("file", "x");
  CHECK_THROWS_AS(io::write_record_folder(record, folder.path("file/below"), false), FileError);
}

TEST_CASE("the motion of a support: a header may come first, a damaged row may not") {
  const TempFolder folder;
  const auto load = [&](const std::string& text) {
    folder.write("s.csv", text);
    cases::Model m;
    m.support_motions.emplace_back().file = "s.csv";
    io::load_support_motions(m, folder.path());
    return m.support_motions[0].time.size();
  };
  CHECK(load("t,x,y,z\n0,0,0,0\n1,0.1,0,0\n") == 2);
  CHECK(load("0,0,0,0\n1,0.1,0,0\n") == 2);
  CHECK_THROWS_WITH_AS(load("O.0, 0, 0, 0\n1,0.1,0,0\n2,0.1,0,0\n"), doctest::Contains("is no row of four finite numbers"), FileError);
  CHECK_THROWS_WITH_AS(load("0.0, 0, 0, O\n1,0.1,0,0\n2,0.1,0,0\n"), doctest::Contains("is no row of four finite numbers"), FileError);
}

TEST_CASE("the motion of a support that turns has three columns more, zero at first, and that of a load has not") {
  const TempFolder folder;
  const auto load = [&](const std::string& text, bool of_load = false) {
    folder.write("s.csv", text);
    cases::Model m;
    m.support_motions.emplace_back().file = "s.csv";
    if (of_load) m.load_history.push_back(0);
    io::load_support_motions(m, folder.path());
    return m.support_motions[0];
  };
  const cases::SupportHistory h = load("t [s], x [m], y [m], z [m], rx [rad], ry [rad], rz [rad]\n0,0.1,0,0,0,0,0\n1,0.1,0.2,0,0,0.5,-1\n");
  CHECK(h.displacement == std::vector<Vec3>{{0.1, 0.0, 0.0}, {0.1, 0.2, 0.0}});
  CHECK(h.rotation == std::vector<Vec3>{{}, {0.0, 0.5, -1.0}});
  CHECK(load("0,0,0,0\n1,0.1,0,0\n").rotation.empty());
  CHECK_THROWS_WITH_AS(load("0,0,0,0,0,0.1,0\n1,0,0,0,0,0,0\n"), doctest::Contains("s.csv:1: the first row turns the support"), FileError);
  CHECK_THROWS_WITH_AS(load("0,0,0,0,0,0,0\n1,0.1,0,0\n"), doctest::Contains("s.csv:2: '1,0.1,0,0' has another number of columns"),
                       FileError);
  CHECK_THROWS_WITH_AS(load("0,0,0,0,0,0\n1,0,0,0,0,0\n"), doctest::Contains("or of seven"), FileError);
  CHECK_THROWS_WITH_AS(load("0,0,0,0,0,0,0,0\n1,0,0,0,0,0,0,0\n"), doctest::Contains("or of seven"), FileError);
  CHECK_THROWS_WITH_AS(load("t,x,y,z,rx [degrees],ry,rz\n0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n"), doctest::Contains("allowed: rad"), FileError);
  CHECK_THROWS_AS(load("0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", true), FileError);
}

TEST_CASE("the way of a load does not turn; ways without a file end with the last file") {
  const TempFolder folder;
  folder.write("s.csv", "0,0,0,0,0,0,0\n10,0.1,0,0,0,0,0.1\n");
  cases::Model m;
  m.support_motions.emplace_back().file = "s.csv";
  m.load_path.push_back(0);
  CHECK_THROWS_AS(io::load_support_motions(m, folder.path()), FileError);
  m.load_path.clear();
  m.support_motions.push_back({{0.0, 1.0}, {{}, {0.0, 0.0, -0.01}}});
  m.support_motions.push_back({{0.0, 1.0}, {{}, {0.0, 0.0, 0.01}}, true});
  m.blocks.resize(3);
  for (int i = 0; i < 3; ++i) m.blocks[static_cast<std::size_t>(i)].support_motion = i;
  io::load_support_motions(m, folder.path());
  CHECK(m.support_motions[1].time.back() == 10.0);
  CHECK(m.support_motions[2].time.back() == 1.0);  // a velocity
}

TEST_CASE("the header of a motion of a support, or of a load, states no other units than s and m, or N") {
  const TempFolder folder;
  const auto load = [&](const std::string& header, bool of_load) {
    folder.write("s.csv", "# pushed\n" + header + "\n0,0,0,0\n1,0.1,0,0\n");
    cases::Model m;
    m.support_motions.emplace_back().file = "s.csv";
    if (of_load) m.load_history.push_back(0);
    io::load_support_motions(m, folder.path());
    return m.support_motions[0].time.size();
  };
  CHECK(load("t [s], x [m], y [ m ], z (m)", false) == 2);
  CHECK(load("t [s], x [N], y [N], z [N]", true) == 2);
  CHECK_THROWS_WITH_AS(load("t [s], x [mm], y [mm], z [mm]", false),
                       doctest::Contains("s.csv:2: unit of column 'x [mm]' is 'mm'; allowed: m"), FileError);
  CHECK_THROWS_WITH_AS(load("t [ms], x, y, z", false), doctest::Contains("unit of column 't [ms]' is 'ms'; allowed: s"), FileError);
  CHECK_THROWS_WITH_AS(load("t [s], x [N], y [N], z (kN)", true), doctest::Contains("unit of column 'z (kN)' is 'kN'; allowed: N"),
                       FileError);
  CHECK_THROWS_AS(load("t [s], x [N], y [N], z [N]", false), FileError);
}
