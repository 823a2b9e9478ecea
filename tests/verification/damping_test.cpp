// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/fixture.h"

// V8: mass damping.
namespace voussoir::testing {

TEST_CASE("V8: decay of the first axial mode") {
  const int elements = 10;
  const double a = 0.2, alpha = 8.0;
  const double omega = 2.0 * Adobe::speed() / a * std::sin(kPi / (4.0 * elements)), ratio = alpha / (2.0 * omega);
  Run run("column_free", {"damping.alpha=8.0", "time.step=1e-4"});
  // The top of every cycle, by the parabola through the three highest samples.
  std::vector<double> tops;
  double before = 0.0, last = 0.0;
  run.until(0.7, {}, [&] {
    double share = 0.0;
    for (int i = 0; i < elements; ++i) {
      share += std::sin(kPi * (i + 0.5) / (2.0 * elements)) * run.displacement(static_cast<std::size_t>(i)).z;
    }
    if (last > before && last >= share) {
      const double slope = 0.5 * (share - before), bend = share - 2.0 * last + before;
      tops.push_back(last - 0.5 * slope * slope / bend);
    }
    before = last, last = share;
  });
  REQUIRE(tops.size() > 11);
  const double got = std::log(tops[0] / tops[10]) / 10.0;
  expect_near("V8 logarithmic decrement of V1", got, 2.0 * kPi * ratio / std::sqrt(1.0 - ratio * ratio), 1e-3);
}

TEST_CASE("V8: fall with drag") {
  const double alpha = 2.0, t = 1.0;
  Run run("fall_drag");
  run.until(t);
  expect_near("V8 fall with drag [m]", -run.displacement(0).z, kGravity / alpha * (t - (1.0 - std::exp(-alpha * t)) / alpha), 1e-3);
}

TEST_CASE("V8: fall with drag, the scheme's own closed form") {
  // v₊ = [(1 − a) v₋ + g Δt]/(1 + a), a = αΔt/2, from rest: v_k = (g/α)(1 − qᵏ), q = (1 − a)/(1 + a). A step so large that a scheme that is
  // not centred is off by 1 %.
  const double alpha = 2.0, dt = 1e-2, a = 0.5 * alpha * dt, q = (1.0 - a) / (1.0 + a);
  const int steps = 100;
  Run run("fall_drag", {"time.step=0.01"});
  run.until(steps * dt);
  const double sum = steps - q * (1.0 - std::pow(q, steps)) / (1.0 - q);  // Σ (1 − qᵏ), k = 1 ... steps
  expect_near("V8 fall with drag in 100 steps of 0.01 s [m]", -run.displacement(0).z, kGravity / alpha * dt * sum, 1e-9);
}

}  // namespace voussoir::testing
