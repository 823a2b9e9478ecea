// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/motion/spectra/spectra.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/case.h"
#include "io/input/motion/spectra/figures.h"
#include "io/input/motion/synthetic/bam_like.h"

using namespace voussoir;
using namespace voussoir::io;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

cases::Accelerogram times(const cases::Accelerogram& a, double factor) {
  cases::Accelerogram out = a;
  for (double& x : out.acceleration) x *= factor;
  return out;
}

/// The record turned by an angle, as an instrument that stood so would have written it.
cases::Accelerogram turned(const cases::Accelerogram& a, const cases::Accelerogram& b, double angle) {
  cases::Accelerogram out = a;
  for (std::size_t i = 0; i < a.acceleration.size(); ++i) {
    out.acceleration[i] = std::cos(angle) * a.acceleration[i] + std::sin(angle) * b.acceleration[i];
  }
  return out;
}

}  // namespace

TEST_CASE("combined spectra: a motion along one direction") {
  const cases::Accelerogram along = bam_like_1()[0];
  for (const double direction : {0.0, 30.0, 117.0}) {
    const cases::Accelerogram a = times(along, std::cos(direction * kDegree)), b = times(along, std::sin(direction * kDegree));
    for (const double f : {0.5, 3.0, 11.0}) {
      const double peak = spectral_displacement(along, f, 0.05);
      const CombinedDisplacement c = combined_displacement(a, b, f, 0.05);
      CHECK(c.rotd100 == doctest::Approx(peak).epsilon(1e-12));
      CHECK(c.rotd50 == doctest::Approx(peak * std::cos(45.0 * kDegree)).epsilon(1e-12));  // the median of |cos k|
      CHECK(c.geometric_mean ==
            doctest::Approx(peak * std::sqrt(std::abs(std::cos(direction * kDegree) * std::sin(direction * kDegree)))).epsilon(1e-9));
    }
  }
}

TEST_CASE("combined spectra: a motion that goes round is the same in all directions") {
  cases::Accelerogram a{"x", 0.005, {}}, b{"y", 0.005, {}};
  for (int i = 0; i < 8000; ++i) {  // a swell so slow that the responses stay circles
    const double t = i * 0.005, size = std::sin(std::numbers::pi * t / 40.0);
    a.acceleration.push_back(size * size * std::cos(12.0 * t));
    b.acceleration.push_back(size * size * std::sin(12.0 * t));
  }
  const CombinedDisplacement c = combined_displacement(a, b, 4.0, 0.2);
  CHECK(c.rotd50 == doctest::Approx(c.rotd100).epsilon(2e-3));
  CHECK(c.geometric_mean == doctest::Approx(c.rotd100).epsilon(2e-3));
}

TEST_CASE("combined spectra: against turned records, one spectrum for each of 180 directions") {
  const auto record = bam_like_1();
  for (const double f : {0.4, 2.0, 9.0}) {
    std::vector<double> peaks;
    for (int k = 0; k < 180; ++k) peaks.push_back(spectral_displacement(turned(record[0], record[1], k * kDegree), f, 0.02));
    std::sort(peaks.begin(), peaks.end());
    const CombinedDisplacement c = combined_displacement(record[0], record[1], f, 0.02);
    CHECK(c.rotd50 == doctest::Approx(0.5 * (peaks[89] + peaks[90])).epsilon(1e-9));
    CHECK(c.rotd100 == doctest::Approx(peaks.back()).epsilon(1e-9));
    CHECK(c.rotd50 < 0.98 * c.rotd100);
  }
}

TEST_CASE("combined spectra: the shorter component is zero after its end; steps must be the same") {
  const auto record = bam_like_1();
  cases::Accelerogram cut = record[1], padded = record[1];
  cut.acceleration.resize(900);
  std::fill(padded.acceleration.begin() + 900, padded.acceleration.end(), 0.0);
  CHECK(combined_displacement(record[0], cut, 1.0, 0.05).rotd100 == combined_displacement(record[0], padded, 1.0, 0.05).rotd100);
  cut.dt = 0.01;
  CHECK_THROWS_WITH_AS(combined_displacement(record[0], cut, 1.0, 0.05), doctest::Contains("different steps"), cases::InputError);
}

TEST_CASE("Eurocode 8: values by hand") {
  // Type 1, ground B, 0.3 g: S = 1.2, corners at 0.15, 0.5 and 2 s; a_g S = 3.530394 m/s2.
  const Eurocode8 b{1, 'B', 0.3 * cases::kStandardGravity};
  const double ground = 0.3 * 9.80665 * 1.2;
  CHECK(eurocode8(b, 0.0, 0.05) == doctest::Approx(3.530394).epsilon(1e-6));
  CHECK(eurocode8(b, 0.075, 0.05) == doctest::Approx(ground * 1.75));  // half way up: 1 + 0.5 · 1.5
  CHECK(eurocode8(b, 0.15, 0.05) == doctest::Approx(8.825985).epsilon(1e-6));
  CHECK(eurocode8(b, 0.5, 0.05) == doctest::Approx(8.825985).epsilon(1e-6));
  CHECK(eurocode8(b, 1.0, 0.05) == doctest::Approx(4.4129925).epsilon(1e-6));
  CHECK(eurocode8(b, 2.0, 0.05) == doctest::Approx(2.20649625).epsilon(1e-6));
  CHECK(eurocode8(b, 4.0, 0.05) == doctest::Approx(0.5516240625).epsilon(1e-6));
  // eta = sqrt(10/7) at 2 %, and 0.55 from 28.06 % on.
  CHECK(eurocode8(b, 0.3, 0.02) == doctest::Approx(ground * 2.5 * 1.1952286).epsilon(1e-6));
  CHECK(eurocode8(b, 0.3, 0.40) == doctest::Approx(ground * 2.5 * 0.55));
}

TEST_CASE("Eurocode 8: soil factors and corners of Tables 3.2 and 3.3") {
  struct Row {
    int type;
    char ground;
    double s, tb, tc, td;
  };
  for (const Row& r : {Row{1, 'A', 1.0, 0.15, 0.4, 2.0}, Row{1, 'B', 1.2, 0.15, 0.5, 2.0}, Row{1, 'C', 1.15, 0.2, 0.6, 2.0},
                       Row{1, 'D', 1.35, 0.2, 0.8, 2.0}, Row{1, 'E', 1.4, 0.15, 0.5, 2.0}, Row{2, 'A', 1.0, 0.05, 0.25, 1.2},
                       Row{2, 'B', 1.35, 0.05, 0.25, 1.2}, Row{2, 'C', 1.5, 0.1, 0.25, 1.2}, Row{2, 'D', 1.8, 0.1, 0.3, 1.2},
                       Row{2, 'E', 1.6, 0.05, 0.25, 1.2}}) {
    CAPTURE(r.type);
    CAPTURE(r.ground);
    const Eurocode8 e{r.type, r.ground, 1.0};
    CHECK(eurocode8(e, 0.0, 0.05) == doctest::Approx(r.s));
    CHECK(eurocode8(e, 0.5 * r.tb, 0.05) == doctest::Approx(r.s * 1.75));
    CHECK(eurocode8(e, r.tb, 0.05) == doctest::Approx(r.s * 2.5));
    CHECK(eurocode8(e, r.tc, 0.05) == doctest::Approx(r.s * 2.5));
    CHECK(eurocode8(e, r.td, 0.05) == doctest::Approx(r.s * 2.5 * r.tc / r.td));
    CHECK(eurocode8(e, 4.0, 0.05) == doctest::Approx(r.s * 2.5 * r.tc * r.td / 16.0));
  }
}

TEST_CASE("targets: between the rows of a table linear, outside nothing") {
  const TargetSpectrum table{"t", {}, {0.1, 0.5, 1.0}, {2.0, 6.0, 1.0}};
  CHECK(value_at(table, 0.1, 0.05) == 2.0);
  CHECK(*value_at(table, 0.2, 0.05) == doctest::Approx(3.0));
  CHECK(*value_at(table, 0.75, 0.3) == doctest::Approx(3.5));
  CHECK(value_at(table, 1.0, 0.05) == 1.0);
  CHECK(!value_at(table, 0.099, 0.05));
  CHECK(!value_at(table, 1.001, 0.05));
  const TargetSpectrum code{"c", Eurocode8{2, 'A', 1.0}, {}, {}};
  CHECK(value_at(code, 4.0, 0.05));
  CHECK(!value_at(code, 4.01, 0.05));
}

TEST_CASE("the factor that fits is the least-squares one, in logarithms") {
  const std::vector<double> record{1.0, 2.0, 4.0}, same{3.0, 6.0, 12.0}, other{2.0, 2.0, 2.0};
  const SpectrumFit exact = fit(record, same);
  CHECK(exact.factor == doctest::Approx(3.0).epsilon(1e-12));
  CHECK(exact.misfit < 1e-12);
  CHECK(exact.lowest == doctest::Approx(1.0).epsilon(1e-12));
  const SpectrumFit f = fit(record, other);  // ln of 2, 1, 1/2: their mean is 0
  CHECK(f.factor == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(f.misfit == doctest::Approx(std::log(2.0) * std::sqrt(2.0 / 3.0)).epsilon(1e-12));
  CHECK(f.lowest == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(f.lowest_at == 0);
}
