// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/performance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/message.h"

namespace voussoir::io {
namespace {

using geometry::printed;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kMostElastic = 3.0;   // d*_t need not exceed so many d*_et: EN 1998-1, B.5
constexpr double kBeyond = 1.5;        // of the target, up to which EN 1998-1, 4.3.3.4.2.3 asks for the curve
constexpr double kDissipation = 0.33;  // k of low dissipation: Circolare 7/2019, C7.3.4.2, method B
constexpr double kElastic = 1e-9;      // of the displacement: less than this beyond the elastic one is none
constexpr double kMostDamping = 0.95;  // of critical
constexpr double kLeastShare = 0.6;    // of the mass in the shape: of masonry by NTC 2018, 7.8.1.5.4 (not read)
constexpr double kBegins = 0.01;       // of the largest base shear: from there on the curve is followed point by point
constexpr const char* kOutside = "the spectrum has no values at some of the periods of the curve, where it may meet it before";
constexpr int kHalvings = 60;

/// A point of the curve up to which it is followed: displacement, force, area below.
struct Reached {
  double d = 0.0, f = 0.0, area = 0.0;
};

/// What a structure of mass m* does that has gone as far as `at`.
struct Secant {
  double period = 0.0, damping = 0.0;
};

/// \param stiffness  of the elastic branch, N/m
Secant secant_at(const Reached& at, double stiffness, double mass, double damping) {
  Secant s{kTurn * std::sqrt(mass * at.d / at.f), damping};
  const double plastic = at.d - at.f / stiffness;
  if (plastic <= kElastic * at.d) return s;
  // Bilinear from the origin with the first stiffness to F_y, then straight to the point: twice its area is F_y d + F d − F F_y / k.
  const double yield = (2.0 * at.area - at.f * at.d) / plastic;
  const double lost = (yield * at.d - at.f * yield / stiffness) / (at.f * at.d);
  s.damping = std::min(kMostDamping, damping + std::max(0.0, 2.0 / std::numbers::pi * kDissipation * lost));
  return s;
}

/// Demand less displacement of the building [m]; nothing where the spectrum has no value.
std::optional<double> missing(const Reached& at, double stiffness, const EquivalentSystem& system, const DemandSpectrum& spectrum) {
  const Secant s = secant_at(at, stiffness, system.mass, spectrum.damping);
  const std::optional<double> d = displacement_at(spectrum, s.period, s.damping);
  if (!d) return {};
  return system.participation * *d - at.d;
}

Reached between(const Reached& a, const Reached& b, double share) {
  Reached r{a.d + share * (b.d - a.d), a.f + share * (b.f - a.f), 0.0};
  r.area = a.area + 0.5 * (a.f + r.f) * (r.d - a.d);
  return r;
}

}  // namespace

EquivalentSystem equivalent_system(const std::vector<double>& mass, const std::vector<double>& along, double control) {
  EquivalentSystem s;
  if (!(std::abs(control) > 0.0)) return s;
  double all = 0.0, first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double shape = along[i] / control;
    all += mass[i], first += mass[i] * shape, second += mass[i] * shape * shape;
  }
  if (!(first > 0.0)) return s;
  s.participation = first / second, s.mass = first, s.all_mass = all, s.shape_at = control;
  return s;
}

SpectrumCurve spectrum_curve(const DemandSpectrum& spectrum, double until) {
  SpectrumCurve s;
  constexpr int kPoints = 200;
  constexpr double kShortest = 0.01, kLongest = 10.0;  // s
  for (int i = 0; i < kPoints; ++i) {
    const double period = kShortest * std::pow(kLongest / kShortest, i / (kPoints - 1.0));
    const std::optional<double> a = acceleration_at(spectrum, period);
    if (!a) continue;
    const double d = *a * std::pow(period / kTurn, 2);
    if (d > until) break;
    s.displacement.push_back(d), s.acceleration.push_back(*a);
  }
  return s;
}

PerformancePoint n2_point(const std::string& name, const std::string& words, const Bilinear& bilinear, const EquivalentSystem& system,
                          const DemandSpectrum& spectrum, double most_ratio) {
  PerformancePoint p;
  p.name = name, p.words = words;
  p.damping = spectrum.damping;
  if (std::isnan(bilinear.force) || !(bilinear.yield > 0.0)) {
    p.open.emplace_back("the curve has no bilinear form of this kind: it has not come as far as that asks for");
    return p;
  }
  if (std::isnan(system.participation)) {
    p.open.emplace_back("the masses do not go where they are pushed: no equivalent system");
    return p;
  }
  p.force = bilinear.force / system.participation, p.yield = bilinear.yield / system.participation;
  p.period = kTurn * std::sqrt(system.mass * p.yield / p.force);
  const std::optional<double> spectral = acceleration_at(spectrum, p.period);
  if (!spectral) {
    p.open.push_back(printed("the spectrum has no value at T* = %.3f s", p.period));
    return p;
  }
  p.spectral = *spectral;
  p.ratio = *spectral * system.mass / p.force;
  if (std::isnan(spectrum.corner) && p.ratio > 1.0) {
    p.open.emplace_back("the corner period T_C of the spectrum is not stated (--corner-period)");
    return p;
  }
  p.elastic = *spectral * std::pow(p.period / kTurn, 2);
  p.target_star = p.elastic;
  if (p.period < spectrum.corner && p.ratio > 1.0) {
    const double inelastic = p.elastic / p.ratio * (1.0 + (p.ratio - 1.0) * spectrum.corner / p.period);
    p.target_star = std::min(std::max(inelastic, p.elastic), kMostElastic * p.elastic);
  }
  p.target = system.participation * p.target_star;
  if (p.ratio > most_ratio) p.open.push_back(printed("q* = %.2f is above %.0f, up to which the method is allowed", p.ratio, most_ratio));
  return p;
}

PerformancePoint capacity_spectrum_point(const CapacityCurve& curve, double stiffness, const EquivalentSystem& system,
                                         const DemandSpectrum& spectrum) {
  PerformancePoint p;
  p.name = "capacity_spectrum", p.words = "capacity spectrum";
  if (std::isnan(system.participation) || !(stiffness > 0.0)) {
    p.open.emplace_back("the masses do not go where they are pushed: no equivalent system");
    return p;
  }
  Reached before;  // the origin, from which the curve begins straight
  const double strongest = *std::ranges::max_element(curve.base_shear);
  bool outside = false;
  for (std::size_t i = 0; i < curve.displacement.size(); ++i) {
    const double d = curve.displacement[i], f = curve.base_shear[i];
    if (!(d > before.d)) continue;                             // what springs back is no farther state
    if (before.d == 0.0 && f < kBegins * strongest) continue;  // the curve begins straight: noise has no stiffness
    if (!(f > 0.0)) break;
    const Reached here{d, f, before.area + 0.5 * (f + before.f) * (d - before.d)};
    const std::optional<double> left = missing(here, stiffness, system, spectrum);
    outside = outside || !left;
    if (!left || *left > 0.0) {
      before = here;
      continue;
    }
    double low = 0.0, high = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
      const double half = 0.5 * (low + high);
      const std::optional<double> m = missing(between(before, here, half), stiffness, system, spectrum);
      (m && *m <= 0.0 ? high : low) = half;
    }
    const Reached at = between(before, here, high);
    const Secant s = secant_at(at, stiffness, system.mass, spectrum.damping);
    p.target = at.d, p.target_star = at.d / system.participation;
    p.period = s.period, p.damping = s.damping;
    p.force = at.f / system.participation;
    p.spectral = acceleration_at(spectrum, s.period, s.damping).value_or(Bilinear::kNone);
    if (outside) p.open.emplace_back(kOutside);
    return p;
  }
  p.open.push_back(outside ? std::string(kOutside)
                           : printed("the damped spectrum does not meet the curve, which ends at %.2f mm", 1e3 * before.d));
  return p;
}

void doubt_shape(PerformancePoint& p, const EquivalentSystem& system) {
  if (!(system.effective_share() < kLeastShare)) return;
  p.open.push_back(
      printed("parts move by themselves, not the building as one: the shape has %.0f %% of the mass", 1e2 * system.effective_share()));
}

void compare_with_capacity(PerformancePoint& p, double near_collapse, double peak, double end) {
  if (std::isnan(p.target)) return;
  if (near_collapse < peak) {
    p.open.emplace_back("the control point moves back after the peak, so its displacement measures no capacity: set analysis.control");
    return;
  }
  if (!std::isnan(near_collapse)) {
    p.demand = p.target / near_collapse;
  } else if (p.target <= end) {
    p.demand = p.target / end, p.at_most = true;
    p.open.push_back(printed("near collapse lies beyond the end of the curve at %.2f mm: demand over capacity is at most this", 1e3 * end));
  } else {
    p.open.push_back(printed("the curve ends at %.2f mm, before the target displacement: capacity is not known", 1e3 * end));
  }
  if (end < kBeyond * p.target && end >= p.target)
    p.open.push_back(
        printed("EN 1998-1, 4.3.3.4.2.3 asks for a curve up to 1.5 times the target; this one ends at %.2f times", end / p.target));
}

}  // namespace voussoir::io
