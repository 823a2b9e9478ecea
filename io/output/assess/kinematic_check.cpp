// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/kinematic_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/message.h"

namespace voussoir::io {
namespace {

using solver::KinematicCurve;

constexpr double kFrom = 0.8, kTo = 1.1;  // a, b of (C7.2.6): the peak of the spectrum at a height, of T_1
constexpr double kPi = std::numbers::pi;
constexpr int kRecordPeriods = 60;  // of a record's spectrum, up to the secant period

/// A limit state of the non-linear verification: share of d_0 (C8.7.1.2.1.6), factor of the secant period (C8.7.1.10, 11), damping
/// (C8.7.1.2.1.8).
struct LimitStateRule {
  const char *name, *words;
  double share, period, damping;
};
constexpr LimitStateRule kStates[] = {{"slv", "non-linear, SLV", 0.4, 1.68, 0.08}, {"slc", "non-linear, SLC", 0.6, 1.56, 0.10}};

std::optional<double> spectral_at(const KinematicQuestion& asked, double period, double damping) {
  return asked.around ? floor_spectrum(*asked.demand, *asked.around, period, damping) : acceleration_at(*asked.demand, period, damping);
}

std::optional<double> displacement_demand(const KinematicQuestion& asked, double period, double damping) {
  const auto moved = [&](double t) -> std::optional<double> {
    const std::optional<double> a = spectral_at(asked, t, damping);
    return a ? std::optional<double>(*a * t * t / (4.0 * kPi * kPi)) : std::nullopt;
  };
  std::optional<double> most = moved(period);
  if (!most) return most;
  if (asked.demand->record) {  // no displacement spectrum that only rises: C8.7.1.2.1.8
    for (int i = 1; i < kRecordPeriods; ++i)
      if (const std::optional<double> d = moved(period * i / kRecordPeriods)) most = std::max(*most, *d);
  }
  if (asked.around && period > kTo * asked.around->period) {
    const std::optional<double> peak = spectral_at(asked, asked.around->period, damping);
    if (!peak) return peak;
    most = std::max(*most, *peak * std::pow(kTo * asked.around->period / (2.0 * kPi), 2));
  }
  return most;
}

/// The acceleration with which the ground, or the floor, meets a structure that does not move in itself.
std::optional<double> rigid_demand(const KinematicQuestion& asked) {
  if (asked.around) return floor_acceleration(*asked.demand, *asked.around);
  if (!asked.demand->record) return acceleration_at(*asked.demand, 0.0);
  double most = 0.0;
  for (const double a : asked.demand->record->acceleration) most = std::max(most, std::abs(a));
  return most;
}

KinematicLine linear(const char* name, const std::string& words, const KinematicQuestion& asked, double behaviour, double activation) {
  KinematicLine line{name, words};
  line.capacity = activation;
  if (const std::optional<double> a = rigid_demand(asked))
    line.demand = *a / behaviour;
  else
    line.open = asked.around ? "the spectrum has no value at T_1" : "the spectrum has no value at a period of 0";
  return line;
}

}  // namespace

std::optional<double> floor_acceleration(const DemandSpectrum& d, const BuildingAround& b) {
  const std::optional<double> at = acceleration_at(d, b.period, b.damping);
  if (!at) return at;
  const double mode = *at * b.participation() * (b.height / b.top) * std::sqrt(1.0 + 0.0004 * std::pow(100.0 * b.damping, 2));
  return std::max(mode, acceleration_at(d, 0.0).value_or(0.0));
}

std::optional<double> floor_spectrum(const DemandSpectrum& d, const BuildingAround& b, double period, double damping) {
  const std::optional<double> at = acceleration_at(d, b.period, b.damping);
  if (!at) return at;
  const double floor = *at * b.participation() * (b.height / b.top) * std::sqrt(1.0 + 0.0004 * std::pow(100.0 * b.damping, 2));
  const double peak = 1.1 / std::sqrt(b.damping) * damping_factor(damping);
  const double off = period < kFrom * b.period ? std::pow(1.0 - period / (kFrom * b.period), 1.6)
                     : period < kTo * b.period ? 0.0
                                               : std::pow(period / (kTo * b.period) - 1.0, 1.2);
  const double mode = peak * floor / (1.0 + (peak - 1.0) * off);
  if (period <= b.period) return mode;
  const std::optional<double> ground = acceleration_at(d, period, damping);
  if (!ground) return ground;
  return std::max(mode, *ground);
}

KinematicCheck check_kinematics(const KinematicCurve& curve, const KinematicQuestion& asked, double gravity) {
  KinematicCheck out;
  if (curve.points.empty()) return out;
  const double factor = gravity / (curve.participation * asked.confidence);
  out.activation = curve.points.front().multiplier * factor;
  out.zero = curve.zero * curve.spectral;
  if (!asked.demand) return out;
  out.lines.push_back(linear("linear_sld", "linear, SLD", asked, 1.0, out.activation));
  out.lines.push_back(
      linear("linear_slv", geometry::printed("linear, SLV, q = %g", asked.behaviour), asked, asked.behaviour, out.activation));
  for (const LimitStateRule& s : kStates) {
    KinematicLine line{std::string("nonlinear_") + s.name, s.words};
    if (std::isnan(out.zero)) {
      line.open = curve.none;
    } else {
      line.capacity = s.share * out.zero;
      line.period = s.period * kPi * std::sqrt(line.capacity / (factor * curve.at(s.share * curve.zero)));
      if (const std::optional<double> d = displacement_demand(asked, line.period, s.damping))
        line.demand = *d;
      else
        line.open = geometry::printed("the spectrum has no value at %.3f s", line.period);
    }
    out.lines.push_back(line);
  }
  return out;
}

}  // namespace voussoir::io
