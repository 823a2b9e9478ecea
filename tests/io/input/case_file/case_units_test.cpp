// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "io/input/case_file/case_file.h"

using namespace voussoir;

namespace {

/// The message with which a text is refused; "accepted" if it is not.
std::string refusal(const std::string& text) {
  try {
    io::read_case({"test.toml", text}, {});
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("faults: a number with a unit comes with the number to write") {
  const auto remedy = [](const std::string& text) {
    const std::string all = refusal(text);
    const std::size_t at = all.rfind("; ");
    return at == std::string::npos ? all : all.substr(at + 2);
  };
  CHECK(remedy("[time]\nduration = \"5 s\"") == "a number has no unit here: write 5");
  CHECK(remedy("[time]\nduration = \"2 Minutes\"") == "a number has no unit here: write 120");
  CHECK(remedy("[time]\nstep = \"0.1ms\"") == "a number has no unit here: write 0.0001");
  CHECK(remedy("[time]\nduration = \"5\"") == "write 5 without quotes");
  CHECK(remedy("[time]\nduration = \"5 m\"") == "a number has no unit here: it is in s");
  CHECK(remedy("[time]\nduration = \"5 furlongs\"") == "a number has no unit here: it is in s");
  CHECK(remedy("[house]\nheight = \"9 feet\"") == "a number has no unit here: write 2.7432");
  CHECK(remedy("[house]\nheight = \"2400 millimetres\"") == "a number has no unit here: write 2.4");
  CHECK(remedy("[materials.m]\nyoung = \"2.5e2 N/mm²\"") == "a number has no unit here: write 250000000");
  CHECK(remedy("[materials.m]\ndensity = \"1.8 t / m^3\"") == "a number has no unit here: write 1800");
  CHECK(remedy("[motion]\nrecord = \"bam-like\"\nintensity = {measure = \"PGA\", level = \"0.25 g\"}") ==
        "a number has no unit here: this is 2.4516625 m/s2");
  CHECK(remedy("[time]\nduration = \"inf\"").ends_with("wanted a number (s, in [0, 1e+06])"));
  const std::string bare = "a number has no unit in a case file: lengths are in m, times in s, angles in degrees, stresses in Pa";
  CHECK(refusal("[time]\nduration = 5 s") == "test.toml:2:14: " + bare);
  CHECK(refusal("[house]\ninner_size = [3.0m, 4.0]") == "test.toml:2:18: " + bare);
  CHECK(refusal("[time]\nduration = 5 5").find(bare) == std::string::npos);
  CHECK(refusal("[[stones]]\nfile = \"a.obj\"\nunit = \"Millimeters\"").ends_with("; did you mean \"mm\"?"));
  CHECK(refusal("[motion]\nrecord = \"r\"\nunit = \"m/s^2\"").ends_with("; did you mean \"m/s2\"?"));
}

TEST_CASE("faults: a key under the name that engineers give it comes with the key") {
  const auto meant = [](const std::string& text) {
    const std::string all = refusal(text);
    const std::size_t at = all.find("did you mean \"");
    return at == std::string::npos ? all : all.substr(at + 14, all.find('"', at + 14) - at - 14);
  };
  CHECK(meant("[materials.m]\nE = 1e9") == "young");
  CHECK(meant("[materials.m]\nelastic_modulus = 1e9") == "young");
  CHECK(meant("[materials.m]\nunit_weight = 18000.0") == "density");
  CHECK(meant("[joint_laws.m]\nphi = 30.0") == "friction");
  CHECK(meant("[joint_laws.m]\ntensile_strength = 1e5") == "tension");
  CHECK(meant("[[load]]\nmagnitude = 5.0") == "force");
  CHECK(meant("[time]\ndt = 1e-5") == "step");
  CHECK(meant("[house]\nthickness = 0.3") == "bearing_wall");
  CHECK(meant("[joint_laws.m]\nE = 1e9") == "young");
  CHECK(meant("[gravity]\nphi = 3").find("unknown key; Keys of [gravity]") != std::string::npos);  // a table that has no such key
}
