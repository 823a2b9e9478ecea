// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/target_file.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "cases/case.h"
#include "io/input/files/errors.h"
#include "tests/io/temp_folder.h"

using namespace voussoir;
using io::read_target;

namespace {
using Faults = std::vector<std::pair<const char*, const char*>>;
}

TEST_CASE("target: Eurocode 8 by its name") {
  const auto in_g = read_target("ec8:1:B:0.3g", {}), plain = read_target("ec8:2:e:2.5", {});
  REQUIRE(in_g.code);
  CHECK(in_g.code->type == 1);
  CHECK(in_g.code->ground == 'B');
  CHECK(in_g.code->ag == 0.3 * 9.80665);
  CHECK(plain.code->type == 2);
  CHECK(plain.code->ground == 'E');
  CHECK(plain.code->ag == 2.5);
  for (const auto& [name, message] : Faults{{"ec8:1:B", "wanted four parts"},
                                            {"ec8:3:B:0.3g", "no type '3'"},
                                            {"ec8:1:F:0.3g", "no ground 'F'"},
                                            {"ec8:1:B:0", "no acceleration '0'"},
                                            {"ec8:1:B:1e300g", "no acceleration '1e300g'"},
                                            {"ec8:1:B:1e-300", "no acceleration '1e-300'"},
                                            {"ec8:1:B:fastg", "no acceleration 'fastg'"},
                                            {"ec8:1:B:", "no acceleration ''"},
                                            {"nowhere.csv", "no such file; allowed: ec8:TYPE:GROUND:AG"}}) {
    CHECK_THROWS_WITH_AS(read_target(name, {}), doctest::Contains(message), cases::InputError);
  }
}

TEST_CASE("target: a file of periods and accelerations") {
  const TempFolder folder;
  const auto t = read_target(folder.write("soil.csv", "# of the site\nT [s], Sa [g]\n0, 0.3\n0.1, 0.75\n"), {});
  CHECK(t.name == "soil.csv");
  CHECK(t.period == std::vector{0.0, 0.1});
  CHECK(t.acceleration == std::vector{0.3 * 9.80665, 0.75 * 9.80665});
  CHECK(read_target(folder.write("plain.txt", "0.1 1\n0.2   2\n"), "m/s2").acceleration == std::vector{1.0, 2.0});
}

TEST_CASE("target: faults of a file, with their line") {
  const TempFolder folder;
  for (const auto& [text, message] :
       Faults{{"0.1 1\n0.2 2\n", "the unit of acceleration is not stated"},
              {"T [s], Sa [g]\n0.1, 1\n", "holds 1 rows of numbers; allowed: 2 or more"},
              {"T [s], Sa [g]\n0.1, 1\n0.1, 2\n", ":3: period '0.1' does not rise"},
              {"T [s], Sa [g]\n0.1, 0\n", ":2: acceleration '0' is no number above 0"},
              {"T [s], Sa [g]\n-0.1, 1\n", ":2: period '-0.1' is no number; allowed: 0 to 1000 s"},
              {"T [s], Sa [g]\n0.1, 1\n1e300, 1\n", ":3: period '1e300' is no number; allowed: 0 to 1000 s"},
              {"T [s], Sa [g]\n0.1, 1\n0.2, 1e300\n", ":3: an acceleration of 9.80665e+300 m/s2; allowed: 1e-5 to 2e5"},
              {"T [s], Sa [g]\n0.1, 1\nx, 1\n", ":3: period 'x' is no number"},
              {"T [s], Sa [g]\n0.1, 1, 2\n", ":2: has 3 columns; wanted two"},
              {"T [ms], Sa [g]\n0.1, 1\n", ":1: unit of the period is 'ms'; allowed: s"},
              {"T [s], Sa [ft]\n0.1, 1\n", ":1: unit of acceleration is 'ft'; allowed: g"}}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(read_target(folder.write("t.csv", text), {}), doctest::Contains(message), io::FileError);
  }
}
