// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/push_shape.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "cases/case.h"
#include "cases/input_error.h"
#include "cases/model.h"
#include "solver/analysis/drive.h"
#include "solver/setup/setup.h"

// Distributions of a push over three blocks, by hand.

using namespace voussoir;

namespace {

/// Relative to the value itself, however small it is.
doctest::Approx about(double value) { return doctest::Approx(value).scale(0.0).epsilon(2e-6); }

/// Blocks in a row along y, of 1, 2 and 1 t: centroids at y = 0.5, 2.5, 5.5 m and z = 0.5, 1, 0.5 m. The plan is 6 m wide.
cases::Case three_blocks() {
  cases::Case c;
  c.materials["stone"] = {1000.0, 1e9, 0.2};
  c.base = cases::Base{};
  const auto add = [&](const char* name, Vec3 low, Vec3 high) {
    cases::BlockSpec b;
    b.name = name, b.material = "stone", b.box = {{low, high}};
    c.blocks.push_back(b);
  };
  add("a", {0, 0, 0}, {1, 1, 1}), add("b", {0, 2, 0}, {1, 3, 2}), add("c", {0, 5, 0}, {1, 6, 1});
  c.analysis.kind = cases::AnalysisKind::pushover;
  return c;
}

struct Built {
  cases::Case c = three_blocks();
  cases::Model model = cases::build_model(c);
  std::unique_ptr<solver::World> world = solver::build_world(c, model, {});
};

constexpr Vec3 kX{1.0, 0.0, 0.0};

void check(const std::vector<Vec3>& shape, double a, double b, double c) {
  REQUIRE(shape.size() == 3);
  CHECK(shape[0].x == about(a));
  CHECK(shape[1].x == about(b));
  CHECK(shape[2].x == about(c));
  for (const Vec3& v : shape) CHECK(norm(Vec3{0.0, v.y, v.z}) < 1e-12);
}

}  // namespace

TEST_CASE("push shape: a triangle grows with the height of centroids, and its mean by mass is 1") {
  const Built b;
  check(solver::triangular_shape(*b.world, kX), 2.0 / 3.0, 4.0 / 3.0, 2.0 / 3.0);
}

TEST_CASE("push shape: eccentricity shifts the resultant to the left of the push by its share of the width, and leaves it as large") {
  const Built b;
  // Middle 2.75 m, mean square of the distances 3.1875 m2: slope 0.05 · 6 / 3.1875 per m.
  std::vector<Vec3> shape = solver::mass_shape(*b.world, kX);
  solver::shift_shape(shape, *b.world, kX, 0.05);
  check(shape, 0.7882352941, 0.9764705882, 1.2588235294);
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += (i == 1 ? 2.0 : 1.0) * shape[i].x, moment += (i == 1 ? 2.0 : 1.0) * shape[i].x * (i == 0 ? 0.5 : i == 1 ? 2.5 : 5.5);
  CHECK(sum == about(4.0));
  CHECK(moment / sum == about(2.75 + 0.3));
  // Backwards the left is the other side.
  std::vector<Vec3> back = solver::mass_shape(*b.world, -kX);
  solver::shift_shape(back, *b.world, -kX, -0.05);
  check(back, -0.7882352941, -0.9764705882, -1.2588235294);
}

TEST_CASE("push shape: what has no width, or would be pushed back, is refused") {
  const Built b;
  std::vector<Vec3> shape = solver::mass_shape(*b.world, {0.0, 1.0, 0.0});
  CHECK_THROWS_WITH_AS(solver::shift_shape(shape, *b.world, {0.0, 1.0, 0.0}, 0.05),
                       "analysis.eccentricity: all elements lie in one line along the push: nothing can be pushed beside it",
                       cases::InputError);
  shape = solver::mass_shape(*b.world, kX);
  CHECK_THROWS_AS(solver::shift_shape(shape, *b.world, kX, 0.3), cases::InputError);
}

TEST_CASE("push shape: the drive of a run has the pattern that its case asks for") {
  Built b;
  b.c.analysis.pattern = cases::LoadPattern::triangular, b.c.analysis.eccentricity = 0.05;
  solver::Simulation shaped(b.c, b.model, {}, {});
  CHECK_NOTHROW(solver::choose_drive(shaped, b.c));
  CHECK(norm(shaped.program().acceleration()) == 0.0);  // forces of its own, no body acceleration
  CHECK(shaped.program().drive().weight == about(4000.0 * norm(b.c.gravity.acceleration)));
}
