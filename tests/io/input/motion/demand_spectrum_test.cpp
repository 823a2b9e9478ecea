// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/demand_spectrum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "cases/input_error.h"
#include "io/input/motion/spectra/target_file.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
using namespace voussoir::io;

namespace {

/// Relative to the value itself, however small it is.
doctest::Approx about(double value) { return doctest::Approx(value).scale(0.0).epsilon(2e-6); }

}  // namespace

TEST_CASE("demand: EN 1998-1 with its corner period, at other damping by its own factor") {
  const DemandSpectrum d = read_demand("ec8:1:B:0.1g", 0.05, {}, {}, "--demand");
  CHECK(d.corner == 0.5);
  CHECK(acceleration_at(d, 0.2).value() == about(2.5 * 1.2 * 0.980665));
  CHECK(acceleration_at(d, 0.2, 0.1).value() == about(2.5 * 1.2 * 0.980665 * std::sqrt(10.0 / 15.0)));
  CHECK(displacement_at(d, 0.2, 0.05).value() == about(2.941995 * std::pow(0.1 / std::numbers::pi, 2)));
  CHECK_FALSE(acceleration_at(d, 4.1));
  CHECK_THROWS_WITH_AS(read_demand("ec8:1:B:0.1g", 0.05, 0.4, {}, "--demand"),
                       "--corner-period: does not go with a spectrum of EN 1998-1, which states it; leave it out", cases::InputError);
  CHECK_THROWS_AS(read_demand("ec8:1:Z:0.1g", 0.05, {}, {}, "--demand"), cases::InputError);
  CHECK(eurocode8_fault("ec8:1:B:0.1g").empty());
  CHECK(eurocode8_fault("ec8:3:B:0.1g").starts_with("'ec8:3:B:0.1g': no type '3'; allowed: ec8:TYPE:GROUND:AG"));
}

TEST_CASE("demand: a table holds for its own damping; at another it is multiplied by the ratio of the factors") {
  const TempFolder folder;
  folder.write("s.csv", "T [s], Sa [m/s2]\n0.1, 4\n1.0, 2\n");
  const DemandSpectrum d = read_demand(folder.path("s.csv"), 0.02, 0.4, {}, "--demand");
  CHECK(d.corner == 0.4);
  CHECK(d.name == "s.csv");
  CHECK(acceleration_at(d, 0.55).value() == about(3.0));
  CHECK(acceleration_at(d, 0.55, 0.1).value() == about(3.0 * std::sqrt(7.0 / 15.0)));
  CHECK_FALSE(acceleration_at(d, 0.05));
  CHECK(std::isnan(read_demand(folder.path("s.csv"), 0.02, {}, {}, "--demand").corner));
}

TEST_CASE("demand: a record's spectrum is computed at each damping") {
  const TempFolder folder;
  std::string text = "t [s],a [m/s2]\n";
  for (int i = 0; i <= 3000; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(std::sin(2.0 * std::numbers::pi * 0.01 * i)) + "\n";
  folder.write("sine.csv", text);
  const DemandSpectrum d = read_demand("record:" + folder.path("sine.csv"), 0.05, {}, {}, "--demand");
  CHECK(d.name == "record:sine.csv");
  // A sine of 1 m/s2 at resonance, thirty periods: the steady amplitude is 1/(2ξ), reached but for exp(−2π·30·ξ).
  CHECK(acceleration_at(d, 1.0, 0.05).value() == about(10.0).epsilon(0.01));
  CHECK(acceleration_at(d, 1.0, 0.1).value() == about(5.0).epsilon(0.01));
  CHECK_FALSE(acceleration_at(d, 0.02));
}
