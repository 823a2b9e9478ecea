// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/treatment.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "cases/input_error.h"
#include "cases/tables/motion.h"

using namespace voussoir;
using namespace voussoir::io;

namespace {

using Components = std::array<cases::Accelerogram, 3>;

cases::Accelerogram sampled(double dt, std::size_t samples, const std::function<double(double)>& a) {
  cases::Accelerogram out{"test", dt, {}};
  for (std::size_t i = 0; i < samples; ++i) out.acceleration.push_back(a(static_cast<double>(i) * dt));
  return out;
}

Components only(cases::Accelerogram a) { return {std::move(a), {}, {}}; }

cases::MotionTreatment window(std::optional<double> from, std::optional<double> to) {
  cases::MotionTreatment t;
  t.from = from, t.to = to;
  return t;
}
cases::MotionTreatment corrected(cases::Baseline baseline) {
  cases::MotionTreatment t;
  t.baseline = baseline;
  return t;
}

double mean_square_velocity(const cases::Accelerogram& a) {
  double v = 0.0, sum = 0.0;
  for (std::size_t i = 1; i < a.acceleration.size(); ++i) {
    v += 0.5 * a.dt * (a.acceleration[i - 1] + a.acceleration[i]);
    sum += v * v;
  }
  return sum / static_cast<double>(a.acceleration.size());
}

void check_fault(Components components, const cases::MotionTreatment& t, const char* key, const char* message) {
  CAPTURE(message);
  try {
    treat(components, t, "motion.");
    FAIL("no error");
  } catch (const cases::InputError& e) {
    CHECK(e.key() == std::string("motion.") + key);
    CHECK(e.problem().find(message) != std::string::npos);
  }
}

double uneven(double t) { return std::sin(9.0 * t * t) + 0.3 * std::cos(31.0 * t) + 0.2; }

}  // namespace

TEST_CASE("treatment: none changes no bit") {
  Components c = only(sampled(0.01, 500, uneven));
  const auto before = c[0].acceleration;
  treat(c, {}, "motion.");
  CHECK(c[0].acceleration == before);
  CHECK(described({}).empty());
  Components none;
  treat(none, window(1.0, 2.0), "motion.");  // nothing moves: nothing to cut
  CHECK(none[0].acceleration.empty());
}

TEST_CASE("treatment: a window keeps the samples nearest to its ends, and all between, bit for bit") {
  const cases::Accelerogram whole = sampled(0.01, 501, uneven);
  for (const double off : {0.0, 0.004, -0.004}) {
    Components c = only(whole);
    treat(c, window(2.7 + off, 4.2 - off), "motion.");
    REQUIRE(c[0].acceleration.size() == 151);
    CHECK(std::equal(c[0].acceleration.begin(), c[0].acceleration.end(), whole.acceleration.begin() + 270));
  }
  Components tail = only(whole);
  treat(tail, window(4.0, {}), "motion.");
  CHECK(tail[0].acceleration.size() == 101);
  CHECK(tail[0].acceleration.back() == whole.acceleration.back());
  // The end of the longest component may be named; a shorter one then ends where it did. An absent one stays absent.
  Components two{sampled(0.01, 301, uneven), {}, whole};
  treat(two, window(1.0, 5.0), "motion.");
  CHECK(two[0].acceleration.size() == 201);
  CHECK(two[1].acceleration.empty());
  CHECK(two[2].acceleration.size() == 401);
}

TEST_CASE("treatment: windows that are none") {
  const Components c{sampled(0.01, 301, uneven), {}, sampled(0.01, 501, uneven)};
  check_fault(c, window(5.0, {}), "from", "5 s; allowed: from 0 to below 5, where the motion ends");
  check_fault(c, window(-1.0, {}), "from", "-1 s; allowed: from 0");
  check_fault(c, window(2.0, 2.0), "to", "2 s; allowed: above 2, where the window begins");
  check_fault(c, window({}, 5.01), "to", "5.01 s; allowed: up to 5, where the motion ends");
  check_fault(c, window({}, 0.004), "to", "leaves fewer than 2 samples of \"test\"");
  check_fault(c, window(4.0, {}), "from", "leaves fewer than 2 samples of \"test\", which ends at 3 s");  // the first component
}

TEST_CASE("treatment: mean and line are taken off to round-off") {
  for (const cases::Baseline b : {cases::Baseline::mean, cases::Baseline::linear}) {
    const double slope = b == cases::Baseline::linear ? 0.7 : 0.0;
    Components c = only(sampled(0.02, 301, [&](double t) { return 1.3 + slope * t; }));
    treat(c, corrected(b), "motion.");
    for (const double a : c[0].acceleration) CHECK(std::abs(a) < 1e-12);
  }
  // A line is no mean.
  Components c = only(sampled(0.02, 301, [](double t) { return t; }));
  treat(c, corrected(cases::Baseline::mean), "motion.");
  CHECK(c[0].acceleration.front() == doctest::Approx(-3.0));
  CHECK(c[0].acceleration.back() == doctest::Approx(3.0));
}

TEST_CASE("treatment: the parabola leaves the least velocity") {
  // A parabola alone vanishes.
  Components alone = only(sampled(0.02, 301, [](double t) { return 0.4 - 0.3 * t + 0.05 * t * t; }));
  treat(alone, corrected(cases::Baseline::parabolic), "motion.");
  for (const double a : alone[0].acceleration) CHECK(std::abs(a) < 1e-10);
  // Of another motion, each small parabola more or less leaves more velocity.
  Components c = only(sampled(0.02, 301, uneven));
  const double before = mean_square_velocity(c[0]);
  treat(c, corrected(cases::Baseline::parabolic), "motion.");
  const double least = mean_square_velocity(c[0]);
  CHECK(least < 0.2 * before);
  for (const int power : {0, 1, 2}) {
    for (const double sign : {-1e-3, 1e-3}) {
      cases::Accelerogram other = c[0];
      for (std::size_t i = 0; i < other.acceleration.size(); ++i) {
        other.acceleration[i] += sign * std::pow(static_cast<double>(i) / 300.0, power);
      }
      CHECK(mean_square_velocity(other) > least);
    }
  }
  check_fault(only(sampled(0.02, 3, uneven)), corrected(cases::Baseline::parabolic), "baseline", "needs 4 samples or more");
}

TEST_CASE("treatment: tapers are half cosines, after cut and baseline") {
  cases::MotionTreatment t;
  t.taper = {1.0, 0.5};
  Components c = only(sampled(0.01, 501, [](double) { return 2.0; }));
  treat(c, t, "motion.");
  const auto& a = c[0].acceleration;
  CHECK(a[0] == 0.0);
  CHECK(a[25] == doctest::Approx(1.0 - std::sqrt(0.5)).epsilon(1e-12));  // 2 · 0.5 (1 - cos 45°)
  CHECK(a[50] == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(a[100] == 2.0);
  CHECK(a[450] == 2.0);
  CHECK(a[475] == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(a[500] == 0.0);
  check_fault(only(sampled(0.01, 101, uneven)), t, "taper", "takes 1.5 s together; allowed: at most the 1 s of \"test\"");
  t.taper = {-1.0, 0.0};
  check_fault(only(sampled(0.01, 101, uneven)), t, "taper", "-1 s; allowed: 0 or more");
  // The mean is of the window alone.
  cases::MotionTreatment all = window(3.0, {});
  all.baseline = cases::Baseline::mean;
  Components step = only(sampled(0.01, 501, [](double time) { return time < 2.995 ? 0.0 : 1.0; }));
  treat(step, all, "motion.");
  for (const double value : step[0].acceleration) CHECK(std::abs(value) < 1e-12);
}

TEST_CASE("treatment: is said") {
  cases::MotionTreatment t = window(27.0, 47.0);
  CHECK(described(t) == "from 27 to 47 s");
  t.to.reset();
  t.baseline = cases::Baseline::parabolic;
  t.taper = {0.5, 1.0};
  CHECK(described(t) == "from 27 s on, baseline parabolic, tapered over 0.5 and 1 s");
}
