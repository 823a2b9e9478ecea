// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "cases/input_error.h"
#include "io/app/session/prepared_case.h"
#include "io/input/case_file/case_file.h"
#include "solver/analysis/modes.h"
#include "solver/setup/setup.h"
#include "tests/cases/house/random_house.h"

// damping.frequency = "auto" and the modes of the building: for every ready case that is small, and for houses drawn at random. Set
// VOUSSOIR_RANDOM_HOUSES for more of these.
namespace voussoir {
namespace {

constexpr double kLowest = 0.3, kHighest = 400.0;  // Hz, of masonry from a soft house of two storeys to a low stiff box

/// The frequency that "auto" chooses [Hz]. \throw InputError where it finds none
double own_frequency(cases::Case c) {
  c.damping.own_frequency = true, c.damping.frequency.reset(), c.damping.alpha.reset();
  io::fill_own_frequency(c, 1);
  return *c.damping.frequency;
}

/// The frequency of the mode that moves most of the mass along y, of all modes [Hz].
double of_most_mass(const cases::Case& c, solver::DryJoints dry) {
  const cases::Model model = cases::build_model(c);
  const auto world = solver::build_world(c, model, {});
  std::vector<solver::Mode> modes = solver::natural_modes(*world, 12, dry);
  for (const solver::Mode& m : solver::modes_along(*world, 1, 1, dry)) modes.push_back(m);
  return std::ranges::max_element(modes, {}, [](const solver::Mode& m) { return m.mass_share.y; })->frequency;
}

/// Checks that modes of the building are found along x and y, whatever lies below them.
void check_modes(const cases::Case& c) {
  const cases::Model model = cases::build_model(c);
  const auto world = solver::build_world(c, model, {});
  const std::vector<solver::Mode> lowest = solver::natural_modes(*world, 6, solver::DryJoints::closed);
  REQUIRE(!lowest.empty());
  for (std::size_t i = 1; i < lowest.size(); ++i) CHECK(lowest[i].frequency >= lowest[i - 1].frequency);
  for (const int axis : {0, 1}) {
    const std::vector<solver::Mode> main = solver::modes_along(*world, axis, 1, solver::DryJoints::closed);
    REQUIRE(main.size() == 1);
    CHECK(main.front().frequency > kLowest);
    CHECK(main.front().frequency < kHighest);
    CHECK((axis == 0 ? main.front().mass_share.x : main.front().mass_share.y) > 0.1);
  }
}

}  // namespace

TEST_CASE("own frequency: \"auto\" and modes work for ready cases") {
  for (const char* name : {"arch", "gable-wall", "stone-house", "flat20n", "flat20r", "vault20n"}) {
    CAPTURE(name);
    const cases::Case c = io::load_case(name).value;
    double frequency = 0.0;
    CHECK_NOTHROW(frequency = own_frequency(c));
    CHECK(frequency > kLowest);
    CHECK(frequency < kHighest);
  }
  check_modes(io::load_case("stone-house").value);
}

TEST_CASE("own frequency: \"auto\" is the mode with most of the mass, also where a weaker one is among the lowest") {
  const cases::Case c = io::load_case("stone-house").value;  // its rafters fill the lowest twelve
  const double chosen = own_frequency(c);
  const double open = of_most_mass(c, solver::DryJoints::open), closed = of_most_mass(c, solver::DryJoints::closed);
  CAPTURE(chosen);
  CAPTURE(open);
  CAPTURE(closed);
  CHECK(std::min(std::abs(chosen - open), std::abs(chosen - closed)) < 1e-3 * chosen);
}

TEST_CASE("own frequency: \"auto\" and modes work for houses drawn at random") {
  const char* wanted = std::getenv("VOUSSOIR_RANDOM_HOUSES");
  const int houses = wanted == nullptr ? 80 : std::atoi(wanted);
  testing::Dice dice(20261129);
  int built = 0;
  for (int i = 0; i < houses; ++i) {
    CAPTURE(i);
    cases::Case c = testing::random_case(dice);
    c.output.history.clear();  // points of the paper's house
    try {
      cases::build_model(c);
    } catch (const cases::InputError&) {
      continue;  // refused, as random_house_test expects
    }
    ++built;
    double frequency = 0.0;
    CHECK_NOTHROW(frequency = own_frequency(c));
    CHECK(frequency > kLowest);
    CHECK(frequency < kHighest);
    if (built % 5 == 0) check_modes(c);
  }
  CHECK(built > houses / 4);
}

}  // namespace voussoir
