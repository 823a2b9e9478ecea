// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

TEST_CASE("the bounds of damping rates are the same bit by bit, however many threads set up the model") {
  const cases::Case c = testing::small_wall(6, 6);
  const cases::Model model = cases::build_model(c);
  const auto bounds_of = [&](int threads) {
    solver::Options options;
    options.threads = threads;
    const std::unique_ptr<solver::World> world = solver::build_world(c, model, options);
    std::vector<double> bounds;
    for (const kernels::BodyConstants& b : world->elements.body) bounds.push_back(b.beta);
    return bounds;
  };
  const std::vector<double> one = bounds_of(1);
  CHECK(one.front() > 0.0);
  for (const int threads : {2, 3, 7}) CHECK(bounds_of(threads) == one);
}
