// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/synthetic/bam_like.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cases/case.h"
#include "cases/motion.h"
#include "io/input/motion/spectra/figures.h"
#include "tests/io/input/motion/record_checks.h"

using namespace voussoir;
using namespace voussoir::io;
using voussoir::testing::check_ends_at_rest;
using voussoir::testing::peak_between;

// The family bam-like#N. The targets are those of catalogue/bam-like.md: figures published for the main shock that it stands in for.
namespace {

constexpr double kDamping = 0.02;

std::vector<std::array<cases::Accelerogram, 3>> realisations() { return {bam_like(1), bam_like(2), bam_like(7)}; }

/// The shares of 200 frequencies, equally spaced in their logarithm, at which Sd of `a` is greater than that of `b`.
double share_above(const cases::Accelerogram& a, const cases::Accelerogram& b, double from, double to, double t_end) {
  int above = 0;
  for (int i = 0; i < 200; ++i) {
    const double f = from * std::pow(to / from, (i + 0.5) / 200.0);
    above += spectral_displacement(a, f, kDamping, t_end) > spectral_displacement(b, f, kDamping, t_end) ? 1 : 0;
  }
  return above / 200.0;
}

/// Of the bits of all samples of L, T and V: FNV-1a.
std::uint64_t digest(const std::array<cases::Accelerogram, 3>& record) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const cases::Accelerogram& component : record) {
    for (const double sample : component.acceleration) {
      const auto bits = std::bit_cast<std::uint64_t>(sample);
      for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ (bits >> shift & 0xffu)) * 0x100000001b3u;
    }
  }
  return hash;
}

}  // namespace

TEST_CASE("the synthetic motions have the same bits from every compiled program") {
  CHECK(digest(bam_like_1()) == 0xee15a589f6f80173u);
  CHECK(digest(bam_like(1)) == 0x3cce0768b987240cu);
  CHECK(digest(bam_like(12)) == 0xf2d9bbc1bff4c637u);
}

TEST_CASE("bam-like#N: peaks, Arias intensity and durations are the published ones") {
  const double acceleration[] = {7.7828, 6.2344, 9.7995}, velocity[] = {1.242, 0.602, 0.401};
  for (const auto& r : realisations()) {
    std::array<MotionFigures, 3> f;
    for (std::size_t i = 0; i < 3; ++i) {
      f[i] = figures(r[i]);
      CHECK(r[i].dt == 0.005);
      CHECK(f[i].duration == doctest::Approx(21.0));
      CHECK(f[i].peak_acceleration == doctest::Approx(acceleration[i]).epsilon(0.01));
      CHECK(f[i].peak_velocity == doctest::Approx(velocity[i]).epsilon(0.05));
    }
    CHECK(f[0].peak_displacement == doctest::Approx(0.34).epsilon(0.10));
    CHECK(f[0].arias == doctest::Approx(8.0).epsilon(0.10));
    CHECK(f[0].arias > std::max(f[1].arias, f[2].arias));
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(f[i].d5_75 == doctest::Approx(5.6).epsilon(0.15));
      CHECK(f[i].d5_95 == doctest::Approx(9.6).epsilon(0.15));
    }
    CHECK((f[0].peak_time > 2.0 && f[0].peak_time < 3.5));
    CHECK((f[1].peak_time > 3.5 && f[1].peak_time < 8.0));
  }
}

TEST_CASE("bam-like#N: the long pulse of L has a period near 2.02 s") {
  // Half of the pulse lies between the zeros of the velocity on either side of its greatest one, once short waves are averaged away.
  for (const auto& r : realisations()) {
    std::vector<double> velocity(r[0].acceleration.size(), 0.0);
    for (std::size_t i = 1; i < velocity.size(); ++i)
      velocity[i] = velocity[i - 1] + 0.5 * r[0].dt * (r[0].acceleration[i - 1] + r[0].acceleration[i]);
    const auto greatest = std::max_element(velocity.begin(), velocity.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    const double sign = *greatest < 0.0 ? -1.0 : 1.0;
    auto begin = greatest, end = greatest;
    while (begin != velocity.begin() && sign * *begin > 0.0) --begin;
    while (end != velocity.end() && sign * *end > 0.0) ++end;
    CHECK(2.0 * static_cast<double>(end - begin) * r[0].dt == doctest::Approx(2.02).epsilon(0.20));
  }
}

TEST_CASE("bam-like#N: the order of the displacement spectra of L and T") {
  for (const auto& r : realisations()) {
    CHECK(share_above(r[0], r[1], 1.5, 6.0, 3.5) == 1.0);
    CHECK(share_above(r[0], r[1], 0.2, 30.0, 3.5) > 0.98);
    CHECK(share_above(r[1], r[0], 1.8, 5.7, 10.0) > 0.98);
    CHECK(share_above(r[0], r[1], 6.8, 30.0, 10.0) > 0.98);
    CHECK(share_above(r[0], r[1], 0.2, 0.8, 10.0) > 0.98);
  }
}

TEST_CASE("bam-like#N: starts quietly and ends at rest where it began") {
  for (const auto& r : realisations()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const cases::Accelerogram& a = r[i];
      CHECK(a.acceleration.front() == 0.0);
      CHECK(peak_between(a, 0.0, 0.4) < (i == 2 ? 0.5 : 0.3));
      CHECK(peak_between(a, 0.0, 1.2) < 1.6);
      CHECK(peak_between(a, 1.2, 2.0) > peak_between(a, 0.0, 1.2));
      CHECK(peak_between(a, 2.0, 3.5) > peak_between(a, 1.2, 2.0));
      check_ends_at_rest(a);
    }
  }
}

TEST_CASE("bam-like#N: a number gives the same bits each time, another number another motion") {
  const auto a = bam_like(1), b = bam_like(1), c = bam_like(2);
  CHECK(c[1].name == "bam-like#2 T");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(a[i].acceleration == b[i].acceleration);
    CHECK(a[i].acceleration != c[i].acceleration);
    // Unlike each other: the correlation of the short waves is near none. L keeps that of its pulse.
    double ac = 0.0, aa = 0.0, cc = 0.0;
    for (std::size_t k = 0; k < a[i].acceleration.size(); ++k) {
      ac += a[i].acceleration[k] * c[i].acceleration[k];
      aa += a[i].acceleration[k] * a[i].acceleration[k];
      cc += c[i].acceleration[k] * c[i].acceleration[k];
    }
    CHECK(ac / std::sqrt(aa * cc) < 0.6);
  }
}

TEST_CASE("bam-like#N: numbers outside the family are refused") {
  CHECK_THROWS_AS((void)bam_like(0), cases::InputError);
  CHECK_THROWS_AS((void)bam_like(kMostRealisations + 1), cases::InputError);
}
