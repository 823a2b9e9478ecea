// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/point_accelerations.h"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "cases/case.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/measures.h"
#include "io/output/results/base_motion.h"
#include "tests/io/results_fixture.h"

using namespace voussoir;
using namespace voussoir::io;
using namespace voussoir::io::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Amplitude that is left of a sine of this frequency [Hz], long after its start.
double gain(double corner, double rate, double frequency) {
  LowPass filter(corner, rate);
  std::complex<double> sum = 0.0;
  const int cycles = 40, samples = static_cast<int>(cycles * rate / frequency);
  for (int i = 0; i < 2 * samples; ++i) {
    const double phase = 2.0 * kPi * frequency * i / rate, out = filter(std::sin(phase));
    if (i >= samples) sum += out * std::polar(1.0, -phase);
  }
  return 2.0 * std::abs(sum) / samples;
}

/// Of Butterworth's filter, with the frequency axis of the bilinear transform.
double by_hand_gain(double corner, double rate, double frequency) {
  const double ratio = std::tan(kPi * frequency / rate) / std::tan(kPi * corner / rate);
  return 1.0 / std::sqrt(1.0 + std::pow(ratio, 8));
}

}  // namespace

TEST_CASE("the low-pass is Butterworth's, of fourth order") {
  for (const double f : {5.0, 25.0, 40.0, 50.0, 100.0, 200.0}) {
    CAPTURE(f);
    CHECK(gain(50.0, 1000.0, f) == doctest::Approx(by_hand_gain(50.0, 1000.0, f)).epsilon(1e-3));
  }
  CHECK(gain(50.0, 1000.0, 50.0) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-3));
  LowPass filter(50.0, 1000.0);
  double last = 0.0;
  for (int i = 0; i < 1000; ++i) last = filter(3.0);
  CHECK(last == doctest::Approx(3.0).epsilon(1e-12));
}

TEST_CASE("a followed point on a shaken base: what an accelerometer there would write, in run.h5 and of the whole motion") {
  // The base accelerates by 2 sin(w t) along x; the point moves against it by a third of that, and shivers at 400 Hz along y.
  const double w = 2.0 * kPi * 3.0, interval = 1e-3;
  cases::Case c;
  c.motion.emplace();
  c.time.duration = 2.0;
  cases::GroundMotion motion;
  motion.axis[0] = {"x", interval, {}};
  for (int i = 0; i <= 2000; ++i) motion.axis[0].acceleration.push_back(2.0 * std::sin(w * i * interval));
  ResultsOptions options = by_hand();
  options.motion = motion_datasets(c, motion, 1e-4, 1);
  const TempFolder folder;
  {
    ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, options);
    for (int i = 0; i <= 2000; ++i) {
      const double t = i * interval;
      solver::HistorySample moving, still;
      moving.velocity = {-(2.0 / 3.0) / w * (1.0 - std::cos(w * t)), 0.02 * std::sin(2.0 * kPi * 400.0 * t), 0.0};
      results.history(t, std::array{still, moving});
    }
    results.measure();
    results.flush();
  }
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  const PointAccelerations a = point_accelerations(run);
  REQUIRE(a.points.size() == 2);
  const PointAcceleration &top = a.points[0].name == "top" ? a.points[0] : a.points[1],
                          &other = &top == &a.points[0] ? a.points[1] : a.points[0];
  CHECK(top.peak_horizontal == doctest::Approx(2.0).epsilon(0.01));   // it does not move: the base's
  const double delay = 0.5 * interval + 2.6131 / (2.0 * kPi * 50.0);  // half an interval, and the filter's for slow motion
  for (std::size_t i = 500; i < 2000; ++i) {
    CHECK(std::abs(top.acceleration[i].x - 2.0 * std::sin(w * (a.time[i] - delay))) < 0.01);
    CHECK(std::abs(other.acceleration[i].x - 4.0 / 3.0 * std::sin(w * (a.time[i] - delay))) < 0.01);
    CHECK(std::abs(other.acceleration[i].y) < 0.05);  // of 50 m/s2
  }
  CHECK(run.shape("/acceleration/top") == Shape{2001, 3});
  CHECK(point_accelerations(run, 2000).points.empty());
  CHECK(run.read<double>("/acceleration/time") == a.time);
  CHECK(run.read<double>("/acceleration/top")[3 * 700] == top.acceleration[700].x);
  CHECK(run.attribute_text("/acceleration/top", "description").find("fourth order, 50 Hz") != std::string::npos);
}

TEST_CASE("rows too far apart for the filter give no acceleration") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), two_cubes(), kCase, kNames, {}, by_hand());
  for (int i = 0; i < 100; ++i) results.history(i * 0.006, std::array<solver::HistorySample, 2>{});
  results.measure();
  results.flush();
  CHECK(point_accelerations(Hdf5File::open(folder.file("run.h5"))).points.empty());
}
