// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cases/motion.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/synthetic/bam_like.h"
#include "tests/io/input/motion/record_checks.h"

using namespace voussoir;
using namespace voussoir::io;
using voussoir::testing::check_ends_at_rest;
using voussoir::testing::peak_between;

// The targets are those of catalogue/bam-like.md: figures published for the main shock that the record stands in for.
namespace {

constexpr double kDamping = 0.02;

std::vector<double> frequencies(double low, double high, int count) {
  std::vector<double> f;
  for (int i = 0; i < count; ++i) f.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return f;
}

/// Smallest and largest of Sd(L) / Sd(T) between two frequencies.
struct Range {
  double low = 1e300, high = 0.0;
};
Range l_over_t(double from, double to, double t_end) {
  const auto r = bam_like_1();
  Range range;
  for (const double f : frequencies(from, to, 400)) {
    const double ratio = spectral_displacement(r[0], f, kDamping, t_end) / spectral_displacement(r[1], f, kDamping, t_end);
    range.low = std::min(range.low, ratio);
    range.high = std::max(range.high, ratio);
  }
  return range;
}

}  // namespace

TEST_CASE("bam-like-1: peaks of acceleration within 1 %, of velocity within 10 %") {
  const auto r = bam_like_1();
  const double acceleration[] = {7.7828, 6.2344, 9.7995}, velocity[] = {1.242, 0.602, 0.401};
  const char* names[] = {"bam-like L", "bam-like T", "bam-like V"};
  for (int i = 0; i < 3; ++i) {
    const MotionFigures f = figures(r[static_cast<std::size_t>(i)]);
    CHECK(r[static_cast<std::size_t>(i)].name == names[i]);
    CHECK(r[static_cast<std::size_t>(i)].dt == 0.005);
    CHECK(f.duration == doctest::Approx(21.0));
    CHECK(f.peak_acceleration == doctest::Approx(acceleration[i]).epsilon(0.01));
    CHECK(f.peak_velocity == doctest::Approx(velocity[i]).epsilon(0.10));
  }
}

TEST_CASE("bam-like-1: Arias intensity and significant durations of L, the strongest component") {
  const auto r = bam_like_1();
  const MotionFigures l = figures(r[0]), t = figures(r[1]), v = figures(r[2]);
  CHECK(l.arias == doctest::Approx(8.0).epsilon(0.15));
  CHECK(l.arias > t.arias);
  CHECK(l.arias > v.arias);
  CHECK(l.d5_75 == doctest::Approx(5.6).epsilon(0.15));
  CHECK(l.d5_95 == doctest::Approx(9.6).epsilon(0.15));
  CHECK(t.d5_75 == doctest::Approx(5.6).epsilon(0.15));
  CHECK(t.d5_95 == doctest::Approx(9.6).epsilon(0.15));
}

TEST_CASE("bam-like-1: L is dominant over the first 3.5 s") {
  CHECK(l_over_t(1.5, 6.0, 3.5).low > 1.2);
  CHECK(l_over_t(0.2, 30.0, 3.5).low > 1.0);
}

TEST_CASE("bam-like-1: over 10 s T exceeds L from 1.5 to 6 Hz, and L exceeds T above and at the lowest frequencies") {
  CHECK(l_over_t(1.5, 6.0, 10.0).high < 1.0 / 1.05);
  CHECK(l_over_t(6.6, 30.0, 10.0).low > 1.05);
  CHECK(l_over_t(0.2, 0.9, 10.0).low > 1.05);
}

TEST_CASE("bam-like-1: starts quietly, then L peaks before 3.5 s and T between 3.5 and 8 s") {
  const auto r = bam_like_1();
  CHECK(peak_between(r[0], 0.0, 0.4) < 0.3);
  CHECK(peak_between(r[1], 0.0, 0.4) < 0.3);
  CHECK(peak_between(r[2], 0.0, 0.4) < 0.5);
  for (const auto& a : r) {
    CHECK(a.acceleration.front() == 0.0);
    CHECK(peak_between(a, 0.5, 1.2) > 0.25);
    CHECK(peak_between(a, 0.0, 1.2) < 1.6);
    CHECK(peak_between(a, 1.2, 2.0) > peak_between(a, 0.0, 1.2));
    CHECK(peak_between(a, 2.0, 3.5) > peak_between(a, 1.2, 2.0));
  }
  const double l = figures(r[0]).peak_time, t = figures(r[1]).peak_time;
  CHECK((l > 2.0 && l < 3.5));
  CHECK((t > 3.5 && t < 8.0));
}

TEST_CASE("bam-like-1: ends at rest where it began, without a correction") {
  for (const cases::Accelerogram& a : bam_like_1()) {
    check_ends_at_rest(a);
  }
}

TEST_CASE("bam-like-1: two calls give the same bits") {
  const auto a = bam_like_1(), b = bam_like_1();
  for (std::size_t i = 0; i < 3; ++i) CHECK(a[i].acceleration == b[i].acceleration);
}
