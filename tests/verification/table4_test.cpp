// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "cases/census.h"
#include "io/input/case_file/case_file.h"
#include "io/input/case_file/catalogue.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"
#include "tests/verification/fixture.h"

using namespace voussoir;

/// V14: what the paper says of its ten models before any earthquake.
namespace {

/// First frequency along x and y, Hz: that of the mode with the largest share of mass.
std::array<double, 2> first_frequencies(const std::string& name, const std::string& bond) {
  testing::note_case(name);
  const cases::Case c = io::load_case(name, {"house.bond=" + bond}).value;
  const cases::Model model = cases::build_model(c);
  const std::vector<solver::Mode> modes = solver::natural_modes(*solver::build_world(c, model, {}), 4);
  const auto by = [](double Vec3::*axis) {
    return [axis](const solver::Mode& a, const solver::Mode& b) { return a.mass_share.*axis < b.mass_share.*axis; };
  };
  return {std::max_element(modes.begin(), modes.end(), by(&Vec3::x))->frequency,
          std::max_element(modes.begin(), modes.end(), by(&Vec3::y))->frequency};
}

struct Row {
  const char* name;
  std::array<double, 2> paper;             // Table 4, Hz; its Fourier transform has bins of 0.195 Hz
  std::array<double, 2> running, english;  // Hz: an independent eigenvalue analysis of the same geometry, to two decimals
};

constexpr std::array<Row, 6> kTable4{{{"flat20n", {6.64, 6.05}, {6.67, 6.01}, {6.38, 5.78}},
                                      {"flat40n", {7.03, 6.08}, {7.45, 6.30}, {7.13, 6.12}},
                                      {"flat20r", {6.84, 6.45}, {7.28, 6.58}, {6.92, 6.26}},
                                      {"vault20n", {3.91, 3.13}, {3.91, 3.03}, {3.76, 2.93}},
                                      {"vault40n", {4.49, 3.32}, {4.60, 3.40}, {4.43, 3.30}},
                                      {"vault20r", {4.29, 3.32}, {4.20, 3.25}, {4.03, 3.14}}}};

/// All models in one bond: against the paper, and closer against the other analysis, which tells the bonds apart.
void check_frequencies(const std::string& bond, std::array<double, 2> Row::*independent) {
  for (const Row& row : kTable4) {
    CAPTURE(row.name);
    const std::array<double, 2> found = first_frequencies(row.name, bond);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::string label = "V14 " + std::string(row.name) + ", first frequency in " + (axis == 0 ? "x" : "y") + ", " + bond + " bond";
      testing::expect_near(label + " [Hz]", found[axis], row.paper[axis], 0.08);
      testing::expect_near(label + ", another analysis [Hz]", found[axis], (row.*independent)[axis], 0.015);
    }
  }
}

}  // namespace

TEST_CASE("V14: Table 4 in English bond") { check_frequencies("english", &Row::english); }

TEST_CASE("V14: Table 4 in running bond") { check_frequencies("running", &Row::running); }

TEST_CASE("V14: section 3.6: the step bound is 5.03e-5 s in all ten models") {
  for (const char* roof : {"flat", "vault"}) {
    for (const char* kind : {"20w", "20n", "20s", "40n", "20r"}) {
      const std::string name = std::string(roof) + kind;
      CAPTURE(name);
      const cases::Census n = cases::census(cases::build_model(io::load_case(name).value));
      testing::note_case(name);
      testing::expect_near("V14 " + name + ", bound of the step [s]", n.step_bound, 5.03e-5, 1e-3);
    }
  }
}
