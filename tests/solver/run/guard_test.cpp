// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "solver/run/simulation.h"
#include "solver/world/errors.h"
#include "tests/solver/small_wall.h"

// What moves or turns too fast for the step ends the run with a message.
using namespace voussoir;
using namespace voussoir::testing;

TEST_CASE("a step far too large stops with the element, the speed and what to try") {
  cases::Case c = small_wall(3, 4, 1e9);
  c.time.step = 5e-3;
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation s(c, m, g, {});
  try {
    for (int i = 0; i < 4000; ++i) s.step({});
    FAIL("it went on");
  } catch (const solver::NumericalError& e) {
    const std::string what = e.what();
    CHECK(what.find("element") != std::string::npos);
    CHECK(what.find("--dt") != std::string::npos);
  }
}

TEST_CASE("what turns too far in a step stops the run, though it does not move away") {
  cases::Case c = small_wall(3, 4);
  cases::BlockSpec b = brick(0, 9, 5.0, 5.2);
  b.name = "top", b.free = true;
  c.blocks.push_back(b);
  const auto spun = [&](double rate) {
    c.blocks.back().angular_velocity = {0.0, 0.0, rate};
    const cases::Model m = cases::build_model(c);
    solver::Simulation s(c, m, {}, {});
    for (int i = 0; i < 40; ++i) s.step({});
    return s.dt();
  };
  const double largest = 0.5 / spun(100.0);
  CHECK_NOTHROW(spun(0.9 * largest));
  try {
    spun(1.1 * largest);
    FAIL("it went on");
  } catch (const solver::NumericalError& e) {
    const std::string what = e.what();
    INFO(what);
    CHECK(what.starts_with("block \"top\" (element "));
    CHECK(what.find(" and turns at ") != std::string::npos);
  }
}
