// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/progress.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace voussoir::io {
namespace {

ProgressState state(double time, std::int64_t step) {
  ProgressState s;
  s.time = time;
  s.end_time = 10;
  s.step = step;
  s.broken = 1234;
  s.residual = 1.23e-6;
  return s;
}

std::int64_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

}  // namespace

TEST_CASE("counts and durations") {
  CHECK(format_count(0) == "0");
  CHECK(format_count(999) == "999");
  CHECK(format_count(1000) == "1,000");
  CHECK(format_count(1234567) == "1,234,567");
  CHECK(format_count(-123456) == "-123,456");
  CHECK(format_duration(-1) == "0 s");
  CHECK(format_duration(0.4) == "0 s");
  CHECK(format_duration(59.4) == "59 s");
  CHECK(format_duration(59.6) == "1 min 00 s");
  CHECK(format_duration(200) == "3 min 20 s");
  CHECK(format_duration(7500) == "2 h 05 min");
  CHECK(format_duration(3 * 86400 + 4 * 3600) == "3 d 04 h");
  CHECK(format_duration(1e300) == "ages");
}

TEST_CASE("the line") {
  CHECK(format_progress(state(3.2144, 1), 12345.2, 130.0) ==
        "3.214 of 10 s  12,345 steps/s  2 min 10 s left  1,234 broken  energy error 1.2e-06");
  ProgressState s = state(-0.53, 1);
  s.settling = true;
  ProgressState at_rest = state(3.2144, 1);
  at_rest.states = 12, at_rest.factor = 0.25, at_rest.unbalanced = 3e-4;
  CHECK(format_progress(at_rest, 12345.2, 130.0) ==
        "12 states of rest, load factor 0.2500, unbalanced 3.0e-04  12,345 steps/s  1,234 broken  energy error 1.2e-06");
  at_rest.headway = "supports moved by 12.0 of 30.0 mm, 4 of 10 s of their histories";
  CHECK(format_progress(at_rest, 12345.2, 130.0) ==
        "12 states of rest, supports moved by 12.0 of 30.0 mm, 4 of 10 s of their histories, unbalanced 3.0e-04  12,345 steps/s  "
        "1,234 broken  energy error 1.2e-06");
  CHECK(format_progress(s, 3.14, std::nullopt) == "settling, -0.530 s  3.1 steps/s  time left unknown  1,234 broken  energy error 1.2e-06");
}

TEST_CASE("time left follows the recent speed") {
  RateEstimate rate(10.0);
  CHECK_FALSE(rate.seconds_left(10).has_value());
  rate.update(0.0, 0, 100.0);
  CHECK_FALSE(rate.seconds_left(10).has_value());
  rate.update(0.1, 1000, 101.0);
  CHECK(rate.steps_per_second() == doctest::Approx(1000));
  CHECK(*rate.seconds_left(10) == doctest::Approx(99));
  rate.update(0.1, 1000, 101.0);  // no time has passed
  CHECK(rate.steps_per_second() == doctest::Approx(1000));
  // Ten times slower after a while: after three memories little of the old speed is left.
  double wall = 101.0, time = 0.1;
  std::int64_t step = 1000;
  for (int i = 0; i < 40; ++i) rate.update(time += 0.1, step += 1000, wall += 1);
  CHECK(rate.steps_per_second() == doctest::Approx(1000));
  for (int i = 0; i < 30; ++i) rate.update(time += 0.01, step += 100, wall += 1);
  CHECK(rate.steps_per_second() == doctest::Approx(100 + 900 * std::exp(-3.0)).epsilon(0.02));
  CHECK(*rate.seconds_left(time + 1) == doctest::Approx(100 / (1 + 9 * std::exp(-3.0))).epsilon(0.02));
  CHECK(*rate.seconds_left(0) == 0);
}

TEST_CASE("no speed, no estimate") {
  RateEstimate rate;
  rate.update(1.0, 5, 0);
  rate.update(1.0, 5, 60);
  CHECK_FALSE(rate.seconds_left(10).has_value());
  CHECK(rate.steps_per_second() == 0);
}

TEST_CASE("a log gets a line every so often, and the last state") {
  std::ostringstream out;
  Progress p(out, Progress::Mode::log, 10.0);
  for (int i = 0; i <= 255; ++i) p.update(state(0.01 * i, 100 * i), 0.1 * i);
  CHECK(lines(out.str()) == 2);
  CHECK(out.str().find('\r') == std::string::npos);
  CHECK(out.str().find("1.000 of 10 s  1,000 steps/s  1 min 30 s left") == 0);
  p.finish();
  p.finish();
  CHECK(lines(out.str()) == 3);
  CHECK(out.str().find("\n2.550 of 10 s") != std::string::npos);
}

TEST_CASE("a log that ends on a line does not repeat it") {
  std::ostringstream out;
  Progress p(out, Progress::Mode::log, 1.0);
  p.update(state(0, 0), 0);
  p.update(state(1, 100), 1);
  p.finish();
  CHECK(lines(out.str()) == 1);
}

TEST_CASE("a terminal gets one line, written over and ended once") {
  std::ostringstream out;
  Progress p(out, Progress::Mode::terminal);
  for (int i = 0; i <= 20; ++i) p.update(state(0.01 * i, 100 * i), 0.125 * i);
  CHECK(lines(out.str()) == 0);
  CHECK(std::ranges::count(out.str(), '\r') == 10);
  p.finish();
  CHECK(lines(out.str()) == 1);
  CHECK(out.str().back() == '\n');
}

TEST_CASE("quiet is quiet, and so is a run without a step") {
  std::ostringstream out;
  Progress quiet(out, Progress::Mode::quiet, 0.0);
  quiet.update(state(0, 0), 0);
  quiet.update(state(1, 1), 100);
  quiet.finish();
  Progress idle(out, Progress::Mode::log);
  idle.finish();
  CHECK(out.str().empty());
  CHECK(Progress::mode_for(2, true) == Progress::Mode::quiet);
}

}  // namespace voussoir::io
