// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/laws/crushing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernels/side.h"

using namespace voussoir;

namespace {

constexpr double kStrength = 4e6, kResidual = 5e5, kSpring = 2e10;  // Pa, Pa, Pa/m
constexpr double kEnergy = 3500.0;                                  // J/m2, above the residual
constexpr double kFall = kStrength - kResidual, kSlope = 0.5 * kFall * kFall / kEnergy;
constexpr kernels::Crushing kSoftens{.strength = kStrength, .residual = kResidual, .slope = kSlope, .depth = 0.01};
constexpr kernels::Crushing kPlastic{.strength = kStrength, .depth = 0.01};

/// A contact point led along a path: its spring, and what it has lost.
struct Point {
  const kernels::Crushing& law;
  double u = 0.0, crushed = 0.0, lost = 0.0;
  [[nodiscard]] double pressure() const { return std::max(0.0, -kSpring * (u + crushed)); }
  [[nodiscard]] double stored() const { return 0.5 * pressure() * pressure() / kSpring; }
  void lead(double to, int steps) {
    for (const double step = (to - u) / steps; steps > 0; --steps) {
      u += step;
      const double xn = u + crushed, by = kernels::crushed_further(xn, crushed, kSpring, law);
      lost += by > 0.0 ? kernels::lost_by_crushing(xn, by, step, kSpring) : 0.0;
      crushed += by;
    }
  }
};

constexpr double kDepth = 0.3, kWide = 0.2;  // m, of the joint: along the bending, across it

/// Force and its moment about the toe of pressures that grow linearly from p0 at x0 to p1 at x1 behind the toe.
std::pair<double, double> trapezium(double x0, double p0, double x1, double p1) {
  const double l = x1 - x0, force = 0.5 * (p0 + p1) * l;
  return {kWide * force, kWide * (force * x0 + l * l * (p0 / 6.0 + p1 / 3.0))};
}

/// Force and moment about the toe of a joint of rigid faces, turned by `turn`, that sinks in by `toe` there; no tension.
std::pair<double, double> stress_block(const kernels::Crushing& a, double toe, double turn) {
  // Corners of the curve of pressure over penetration: what is crushed lies on top of what the spring has given.
  std::vector<std::pair<double, double>> curve{{0.0, 0.0}, {a.strength / kSpring, a.strength}};
  if (a.slope > 0.0) curve.emplace_back(a.residual / kSpring + (a.strength - a.residual) / a.slope, a.residual);
  curve.emplace_back(1.0, curve.back().second);
  double force = 0.0, moment = 0.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const auto [w0, p0] = curve[i];
    const auto [w1, p1] = curve[i + 1];
    const double high = std::min(toe, w1);
    if (high <= w0) break;
    const double at_high = p0 + (p1 - p0) * (high - w0) / (w1 - w0);
    const auto [f, m] = trapezium((toe - high) / turn, at_high, (toe - w0) / turn, p0);
    force += f, moment += m;
  }
  return {force, moment};
}

/// The same of a side of the kernels without bonds, led there by a turn that grows under constant force.
class Joint {
 public:
  Joint(int rows, const kernels::Crushing& law) : law_(law) {
    const auto n = static_cast<std::size_t>(rows);
    const std::size_t padded = (n + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes;
    s_.assign(padded, 0.0), t_.assign(padded, 0.0), area_.assign(padded, 0.0), crushed_.assign(padded, 0.0);
    bond_.assign(padded, kernels::Bond::contact), mode_.assign(padded, kernels::Mode::none), time_.assign(padded, 0.0);
    springs_.assign(padded / kernels::kWidth, {});
    for (std::size_t i = 0; i < n; ++i) s_[i] = kDepth * (static_cast<double>(i) + 0.5) / rows, area_[i] = kDepth * kWide / rows;
    points_ = {s_.data(), t_.data(), area_.data(), rows};
  }
  /// Force, and its moment about the toe at s = 0, where it sinks in by `toe`.
  std::pair<double, double> at(double toe, double turn, bool keep) {
    const std::vector<double> crushed = crushed_;
    const std::vector<kernels::SegmentSprings> springs = springs_;
    const kernels::SegmentsView q{bond_.data(), mode_.data(), time_.data(), springs_.data()};
    kernels::crush_segments({.d = -toe, .ds = turn, .dt = 0, .v = 0, .vs = 0, .vt = 0}, kSpring, 1.0, points_, q, 0.0, law_,
                            crushed_.data());
    double force = 0.0, moment = 0.0;
    for (int i = 0; i < points_.n; ++i) {
      const double f = area_[static_cast<std::size_t>(i)] * kSpring * std::max(0.0, toe - turn * points_.s[i] + q.closure(i));
      force += f, moment += f * points_.s[i];
    }
    if (!keep) crushed_ = crushed, springs_ = springs;
    return {force, moment};
  }

 private:
  const kernels::Crushing& law_;
  std::vector<double> s_, t_, area_, crushed_, time_;
  std::vector<kernels::Bond> bond_;
  std::vector<kernels::Mode> mode_;
  std::vector<kernels::SegmentSprings> springs_;
  kernels::PointsView points_;
};

/// The penetration of the toe at which `force_at` (rising) is `force`.
template <class Force>
double toe_for(double force, const Force& force_at) {
  double low = 0.0, high = 0.05;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (force_at(middle) < force ? low : high) = middle;
  }
  return high;
}

}  // namespace

TEST_CASE("a contact that crushes follows its curve, unloads with its spring, and loses its energy") {
  Point p{kSoftens};
  p.lead(-kStrength / kSpring, 100);
  CHECK(p.pressure() == doctest::Approx(kStrength).epsilon(1e-12));
  CHECK(p.crushed == 0.0);
  const double half = 0.5 * kFall / kSlope;  // crushed by so much, half of the fall is over
  p.lead(-(half + (kStrength - 0.5 * kFall) / kSpring), 200);
  CHECK(p.crushed == doctest::Approx(half).epsilon(1e-9));
  CHECK(p.pressure() == doctest::Approx(kStrength - 0.5 * kFall).epsilon(1e-9));
  const double far = p.u, most = p.pressure(), lost = p.lost;
  p.lead(far + 1e-5, 3);
  CHECK(p.pressure() == doctest::Approx(most - 1e-5 * kSpring).epsilon(1e-9));
  p.lead(0.0, 10);
  CHECK(p.pressure() == 0.0);
  CHECK(p.lost == lost);
  p.lead(far, 10);
  CHECK(p.pressure() == doctest::Approx(most).epsilon(1e-9));
  CHECK(p.lost == lost);
  const double end = kFall / kSlope + 2e-3;
  p.lead(-(end + kResidual / kSpring), 2000);
  CHECK(p.pressure() == doctest::Approx(kResidual).epsilon(1e-9));
  CHECK(p.crushed == doctest::Approx(end).epsilon(1e-9));
  CHECK(p.lost == doctest::Approx(kEnergy + kResidual * end).epsilon(1e-4));
}

TEST_CASE("a contact that crushes bears any pressure once it has been crushed by its depth") {
  for (const kernels::Crushing& law : {kSoftens, kPlastic}) {
    Point p{law};
    p.lead(-0.011, 5000);
    CHECK(p.crushed == law.depth);
    CHECK(p.pressure() == doctest::Approx(kSpring * 1e-3).epsilon(1e-9));
    // Work by the trapezoid rule is stored or lost, to and fro, to the depth and beyond.
    Point q{law};
    q.lead(-5e-5, 1);
    double work = q.stored();
    for (int i = 0; i < 3500; ++i) {
      const double before = q.pressure(), step = 8e-6 * std::sin(0.9 * i) - 4e-6;
      q.lead(q.u + step, 1);
      work -= 0.5 * (before + q.pressure()) * step;
    }
    CHECK(q.crushed == law.depth);
    CHECK(work == doctest::Approx(q.stored() + q.lost).epsilon(1e-9));
  }
}

TEST_CASE("a block pressed on its toe: the stress block of a joint that crushes") {
  kernels::Crushing deep = kSoftens;
  deep.depth = 0.1;
  for (const kernels::Crushing& law : {kPlastic, deep}) {
    const double force = (law.slope > 0.0 ? 0.06 : 0.25) * kStrength * kDepth * kWide;
    Joint joint(400, law);
    double most = 0.0, expected_most = 0.0, last = 0.0, expected_last = 0.0;
    for (int i = 2; i <= 80; ++i) {  // at 1 the heel is still pressed
      const double turn = i * (law.slope > 0.0 ? 1e-3 : 2.5e-4);
      const double toe = toe_for(force, [&](double w) { return joint.at(w, turn, false).first; });
      last = 0.5 * force * kDepth - joint.at(toe, turn, true).second;
      const double exact = toe_for(force, [&](double w) { return stress_block(law, w, turn).first; });
      expected_last = 0.5 * force * kDepth - stress_block(law, exact, turn).second;
      most = std::max(most, last), expected_most = std::max(expected_most, expected_last);
      CHECK(last == doctest::Approx(expected_last).epsilon(5e-3));
    }
    CHECK(most == doctest::Approx(expected_most).epsilon(2e-3));
    if (law.slope == 0.0) {
      // Far turned, the pressure is one rectangle: N (b − a)/2, a = N/(f w).
      CHECK(last == doctest::Approx(0.5 * force * (kDepth - force / (kStrength * kWide))).epsilon(3e-3));
    } else {
      CHECK(last < 0.9 * most);
    }
  }
}
