// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Walls along no axis have the figures that they have along the axes.
namespace {

using Json = nlohmann::json;

/// An L of two walls with a door, on ground that leans so that they crack and tip, all turned about z. \param angle  rad
std::string corner(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](double x, double y) {
    char text[80];
    std::snprintf(text, sizeof text, "[%.17g, %.17g", c * x - s * y, s * x + c * y);
    return std::string(text);
  };
  return "title = \"a corner\"\n[gravity]\nsettle = false\nacceleration = " + turned(1.5, -4.0) +
         ", -9.81]\n[time]\nduration = 0.4\nstep = 5e-5\n[damping]\nfrequency = 10.0\nratio = 0.02\n"
         "[materials.stone]\ndensity = 2000.0\nyoung = 1e8\npoisson = 0.2\n"
         "[joint_laws.weak]\ntension = 1e3\ncohesion = 1e3\nfriction = 32.0\ncompression = 1e6\nthickness = 0.01\nyoung = 1e8\npoisson = "
         "0.2\n"
         "[joints]\ndefault = \"weak\"\n[contact]\nfriction = 32.0\n[segments]\nsize = 0.1\n[base]\nz = 0.0\n"
         "[output]\nframe_interval = 0.05\nhistory_interval = 0.05\n"
         "[[wall]]\nname = \"street\"\nline = \"right\"\nthickness = 0.2\nheight = 1.2\nbrick = [0.4, 0.2, 0.2]\nmaterial = \"stone\"\n"
         "points = [" +
         turned(0.0, 0.0) + "], " + turned(3.2, 0.0) + "], " + turned(3.2, 2.4) +
         "]]\n[[wall.opening]]\nfrom = 1.1\nwidth = 0.9\nheight = 0.8\nlintel = { bearing = 0.2, height = 0.2, material = \"stone\" }\n";
}

struct Told {
  Json summary, assessment;
  std::size_t maps = 0;
};

Told told(double angle) {
  const TempFolder folder;
  folder.write("corner.toml", corner(angle));
  const auto words = [&](const std::string& w) {
    const shell::Outcome o = shell::run("cd " + shell::quoted(folder.path()) + " && " + shell::kProgram + " " + w);
    REQUIRE_MESSAGE(o.code == 0, o.text);
    return o.text;
  };
  words("run corner.toml -o out --quiet -j 1");
  Told t{Json::parse(words("summary out --format json")), Json::parse(words("assess out --format json")), 0};
  words("assess out --maps maps 2>&1");
  for (const auto& file : std::filesystem::directory_iterator(folder.path() + "/maps")) t.maps += file.path().extension() == ".svg" ? 1 : 0;
  return t;
}

/// Numbers that are the same, within a share of them and a tenth of what a crack is at least.
void check_same(const Json& a, const Json& b, const std::string& where) {
  REQUIRE_MESSAGE(a.type() == b.type(), where);
  if (a.is_number_float()) {
    CHECK_MESSAGE(std::abs(a.get<double>() - b.get<double>()) <= 1e-5 + 1e-3 * std::abs(a.get<double>()), where);
  } else if (a.is_object() || a.is_array()) {
    REQUIRE_MESSAGE(a.size() == b.size(), where);
    for (const auto& [key, value] : a.items())
      if (key != "name" && key != "wall") check_same(value, a.is_object() ? b[key] : b[std::stoul(key)], where + "." + key);
  } else if (a.is_number()) {
    CHECK_MESSAGE(a == b, where);
  }
}

}  // namespace

TEST_CASE("walls in any direction have the drifts, cracks and crack maps of the same along the axes") {
  const Told straight = told(0.0);
  REQUIRE(straight.summary["walls"].size() == 2);
  CHECK(straight.summary["walls"][0]["name"] == "street 1 wall");
  CHECK(std::abs(straight.summary["peak_drift"].get<double>()) > 0.01);
  CHECK(straight.assessment["cracks"].size() > 0);
  CHECK(straight.assessment["corners"].size() >= 2);  // of the door
  CHECK(straight.maps == 2);
  for (const double angle : {0.6, -1.2, 2.5}) {
    const Told turned = told(angle);
    CHECK(turned.summary["walls"][0]["name"] == "street 1 walling");
    CHECK(turned.maps == 2);
    for (const char* key : {"peak_drift", "peak_storey_drift", "damage_grade"}) check_same(straight.summary[key], turned.summary[key], key);
    check_same(straight.assessment["walls"], turned.assessment["walls"], "walls");
    check_same(straight.assessment["cracks"], turned.assessment["cracks"], "cracks");
    for (std::size_t w = 0; w < 2; ++w) {  // x of the model and of a turned wall may go different ways along it
      const Json &from = straight.summary["walls"][w], &to = turned.summary["walls"][w];
      CHECK(std::abs(to["peak_in_plane_drift"].get<double>()) ==
            doctest::Approx(std::abs(from["peak_in_plane_drift"].get<double>())).epsilon(1e-3));
      for (const char* key : {"peak_drift", "residual_drift", "fallen_mass_fraction", "crack_extent"}) check_same(from[key], to[key], key);
    }
    REQUIRE(turned.assessment["corners"].size() == straight.assessment["corners"].size());
  }
}
