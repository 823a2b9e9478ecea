// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/modes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "cases/model.h"
#include "geometry/segments/torsion.h"
#include "solver/analysis/impulse.h"
#include "solver/setup/setup.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;

namespace {

constexpr double kSide = 0.2, kHeight = 0.2;  // m, of an element

/// A column of adobe cubes on the base.
cases::Case column(int elements) { return testing::stack_of_blocks(elements, {kSide, kSide, kHeight}); }

std::vector<solver::Mode> modes_of(const cases::Case& c, int count, solver::DryJoints dry = solver::DryJoints::open) {
  const cases::Model model = cases::build_model(c);
  return solver::natural_modes(*solver::build_world(c, model, {}), count, dry);
}

}  // namespace

TEST_CASE("axial modes of a column are those of the chain of springs") {
  constexpr int n = 10;
  const double c_long = std::sqrt(9.8e7 / (1.0 - 0.25 * 0.25) / 1800.0);
  int found = 0;
  for (const solver::Mode& m : modes_of(column(n), 6 * n - 1)) {
    if (m.mass_share.z < 1e-6) continue;
    ++found;
    const double expected = c_long / (std::numbers::pi * kHeight) * std::sin((2 * found - 1) * std::numbers::pi / (4 * n));
    CHECK(m.frequency == doctest::Approx(expected).epsilon(1e-9));
  }
  CHECK(found >= n - 1);
}

TEST_CASE("torsional modes of a column whose faces twist as solids do are those of Saint-Venant's constant") {
  constexpr int n = 6;
  cases::Case c = column(n);
  c.segment_torsion = geometry::Torsion::solid;
  const double polar = std::pow(kSide, 4) / 6.0, speed = std::sqrt(9.8e7 / 2.5 / 1800.0);
  const double share = std::sqrt(geometry::torsion_constant(kSide, kSide) / polar);
  const std::vector<solver::Mode> modes = modes_of(c, 6 * n - 1);
  const double expected = share * speed / (std::numbers::pi * kHeight) * std::sin(std::numbers::pi / (4 * n));
  CHECK(std::ranges::count_if(modes, [&](const solver::Mode& m) { return m.frequency == doctest::Approx(expected).epsilon(1e-9); }) == 1);
}

TEST_CASE("joints without a bond: left out, or held as if bonded, with the stiffness of the blocks") {
  constexpr int n = 4;
  cases::Case c = column(n);
  c.joints.default_law = "dry";
  for (const solver::Mode& m : modes_of(c, 6 * n - 1)) CHECK(m.frequency < 1e-6);
  const double c_long = std::sqrt(9.8e7 / (1.0 - 0.25 * 0.25) / 1800.0);
  const double first = c_long / (std::numbers::pi * kHeight) * std::sin(std::numbers::pi / (4 * n));
  double axial = 0.0, most = 0.0;
  for (const solver::Mode& m : modes_of(c, 6 * n - 1, solver::DryJoints::closed)) {
    if (m.mass_share.z > most) axial = m.frequency, most = m.mass_share.z;
  }
  CHECK(most > 0.8);
  CHECK(axial == doctest::Approx(first).epsilon(1e-9));
}

TEST_CASE("ties count in modes if they bear compression or are under pretension") {
  cases::Case c = column(1);
  const double joint = 9.8e7 / (1.0 - 0.25 * 0.25) * kSide * kSide / (0.5 * kHeight), mass = 1800.0 * kSide * kSide * kHeight;
  const auto vertical = [&] {
    double frequency = 0.0;
    for (const solver::Mode& m : modes_of(c, 5))
      if (m.mass_share.z > 0.5) frequency = m.frequency;
    return frequency;
  };
  const auto expected = [&](double stiffness) {
    return doctest::Approx(std::sqrt(stiffness / mass) / (2.0 * std::numbers::pi)).epsilon(1e-9);
  };
  c.ties.push_back({.name = "strap", .from = {0.1, 0.1, 0.0}, .to = {0.1, 0.1, 0.2}, .area = 1e-4, .young = 1e10});
  CHECK(vertical() == expected(joint));
  c.ties[0].compression = true;
  CHECK(vertical() == expected(joint + 1e10 * 1e-4 / 0.2));
  c.ties[0].compression = false, c.ties[0].pretension = 1.0;
  CHECK(vertical() == expected(joint + 1e10 * 1e-4 / 0.2));
}

TEST_CASE("effective masses of all modes are the mass, and shapes are scaled to one metre") {
  const std::vector<solver::Mode> modes = modes_of(column(10), 60);
  REQUIRE(modes.size() == 59);  // all but the highest, which has less than 1 % of the mass
  const double radius = 0.5 * std::sqrt(2 * kSide * kSide + kHeight * kHeight);
  Vec3 sum;
  for (const solver::Mode& m : modes) {
    sum += m.mass_share;
    double largest = 0.0;
    for (const Vec3 u : m.displacement) largest = std::max({largest, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    for (const Vec3 turn : m.rotation) {
      for (const double a : {turn.x, turn.y, turn.z}) largest = std::max(largest, radius * std::abs(a));
    }
    CHECK(largest == doctest::Approx(1.0));
  }
  for (const double share : {sum.x, sum.y, sum.z}) {
    CHECK(share <= 1.0 + 1e-9);
    CHECK(share > 0.99);
  }
}

TEST_CASE("what nothing holds has no frequency") {
  cases::Case c = column(1);
  c.base.reset();
  c.blocks[0].free = true;
  for (const solver::Mode& m : modes_of(c, 5)) CHECK(m.frequency < 1e-6);
}

TEST_CASE("the Fourier transform finds a cosine's bin") {
  std::vector<double> samples;
  for (int i = 0; i < solver::kImpulseSamples; ++i)
    samples.push_back(5.0 + std::cos(2.0 * std::numbers::pi * 34.0 * i / solver::kImpulseSamples));
  CHECK(solver::dominant_frequency(samples, solver::kImpulseInterval) == doctest::Approx(34.0 / 5.12).epsilon(1e-12));
}

TEST_CASE("impulse and eigenvalues agree within a bin") {
  cases::Case c = column(6);
  c.output.history = {{"top", {0.1, 0.1, 5.5 * kHeight}}};
  const cases::Model model = cases::build_model(c);
  const double first = modes_of(c, 4).front().frequency;
  for (int axis = 0; axis < 2; ++axis) {
    const solver::ImpulseResponse r = solver::impulse_response(c, model, {}, axis, [](double) {});
    CHECK(r.broken == 0);
    REQUIRE(r.displacement.size() == 1);
    REQUIRE(r.displacement[0].size() == solver::kImpulseSamples);
    CHECK(std::abs(solver::dominant_frequency(r.displacement[0], solver::kImpulseInterval) - first) < 1.0 / 5.12);
  }
}

TEST_CASE("samples of the impulse are a hundredth of a second apart whatever step the case gives, and nothing else moves") {
  cases::Case c = column(6);
  c.output.history = {{"top", {0.1, 0.1, 5.5 * kHeight}}};
  const auto response = [&c] { return solver::impulse_response(c, cases::build_model(c), {}, 0, [](double) {}).displacement[0]; };
  const std::vector<double> usual = response();
  c.time.step = 3e-4;  // 33 of them are 9.9 ms
  c.blocks.back().velocity = {0.3, 0.0, 0.0};
  const std::vector<double> given = response();
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    largest = std::max(largest, std::abs(usual[i]));
    apart = std::max(apart, std::abs(usual[i] - given[i]));
  }
  CHECK(apart < 0.1 * largest);
}

TEST_CASE("modes along an axis: that of the building is found however many local ones lie below it") {
  constexpr int n = 4;
  cases::Case c = column(n);
  const std::vector<solver::Mode> alone = modes_of(c, 6 * n - 1);
  const auto in_y = [](const solver::Mode& m) { return m.mass_share.y; };
  const double expected = std::ranges::max_element(alone, {}, in_y)->frequency;
  // Eight light, soft posts beside it: three lowest modes each along x and along y, none with a tenth of the mass.
  c.materials["soft"] = {200.0, 1.0e6, 0.25};
  for (int post = 0; post < 8; ++post) {
    for (int i = 0; i < 6; ++i) {
      const double x = 1.0 + 0.5 * post, z = 0.05 * i;
      cases::BlockSpec block;
      block.name = "post " + std::to_string(post) + "." + std::to_string(i), block.material = "soft";
      block.box = {Vec3{x, 0.0, z}, Vec3{x + 0.05, 0.05, z + 0.05}};
      c.blocks.push_back(block);
    }
  }
  for (const solver::Mode& m : modes_of(c, 12)) CHECK(m.mass_share.y < 0.1);
  const cases::Model model = cases::build_model(c);
  const std::vector<solver::Mode> found = solver::modes_along(*solver::build_world(c, model, {}), 1, 1);
  REQUIRE(found.size() == 1);
  CHECK(found.front().frequency == doctest::Approx(expected).epsilon(1e-7));
  CHECK(found.front().mass_share.y > 0.5);
}

TEST_CASE("modes along an axis have the shares and frequencies of the eigenvalues, and leave mechanisms out") {
  constexpr int n = 5;
  cases::Case c = column(n);
  std::vector<solver::Mode> all = modes_of(c, 6 * n - 1);
  std::ranges::sort(all, std::greater{}, [](const solver::Mode& m) { return m.mass_share.z; });
  const cases::Model model = cases::build_model(c);
  const std::vector<solver::Mode> found = solver::modes_along(*solver::build_world(c, model, {}), 2, 3);
  REQUIRE(found.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(found[i].frequency == doctest::Approx(all[i].frequency).epsilon(1e-7));
    CHECK(found[i].mass_share.z == doctest::Approx(all[i].mass_share.z).epsilon(1e-6));
  }
  c.joints.default_law = "dry";  // nothing holds the cubes
  const cases::Model loose = cases::build_model(c);
  CHECK(solver::modes_along(*solver::build_world(c, loose, {}), 2, 3).empty());
}
