// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/performance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/capacity/equivalent_system.h"
#include "io/output/measures/capacity/performance_file.h"

// N2 and the capacity spectrum against numbers worked out apart from the program (a script of twenty lines), and what must not change them.

using namespace voussoir;
using namespace voussoir::io;

namespace {

/// Relative to the value itself, however small it is.
doctest::Approx about(double value) { return doctest::Approx(value).scale(0.0).epsilon(2e-6); }

constexpr double kG = 9.80665;  // m/s2

/// Elastic up to 1 mm and 10 kN, level up to 5 mm, then falling by 3 kN a millimetre, up to `until`. \param force, length  factors
CapacityCurve trilinear(double until, double force = 1.0, double length = 1.0) {
  CapacityCurve c;
  for (int i = 0; i <= std::lround(until * 1e5); ++i) {
    const double mm = 1e-2 * i;
    const double f = 1e4 * (mm < 1.0 ? mm : mm < 5.0 ? 1.0 : 1.0 - 0.3 * (mm - 5.0));
    c.time.push_back(mm), c.displacement.push_back(length * 1e-3 * mm), c.moved.push_back(length * 1e-3 * mm);
    c.drift.push_back(length * 1e-3 * mm / 2.0), c.base_shear.push_back(force * f), c.factor.push_back(f / 1e5);
    for (auto* zero : {&c.support_moved, &c.over, &c.input, &c.kinetic, &c.damping, &c.losses, &c.stored}) zero->push_back(0.0);
    c.unbalanced.push_back(1e-5);
  }
  return c;
}

Capacity capacity(CapacityCurve curve) { return capacity_of(cases::AnalysisKind::pushover, 0.2, 2.0, 1e5, 0.0, std::move(curve)); }

/// Two masses of 4 t, of which the lower goes half as far as the control point: Γ = 1.2, m* = 6 t.
EquivalentSystem two_masses(double mass = 4000.0) { return equivalent_system({mass, mass}, {0.5e-3, 1e-3}, 1e-3); }

/// EN 1998-1, type 1, ground B: T_B 0.15, T_C 0.5 s, S 1.2.
DemandSpectrum ground_b(double ag) {
  DemandSpectrum d;
  d.target.code = Eurocode8{1, 'B', ag};
  d.corner = 0.5;
  return d;
}

const PerformancePoint& point(const Capacity& c, std::size_t i) { return c.performance->points[i]; }

Capacity compared(CapacityCurve curve, const EquivalentSystem& system, const DemandSpectrum& d) {
  Capacity c = capacity(std::move(curve));
  look_at_demand(system, d, c);
  return c;
}

bool says(const PerformancePoint& p, const std::string& words) {
  for (const std::string& s : p.open)
    if (s.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("performance: participation and mass of two masses, whatever unit the shape has") {
  const EquivalentSystem s = two_masses();
  CHECK(s.participation == about(1.2));
  CHECK(s.mass == about(6000.0));
  CHECK(s.all_mass == about(8000.0));
  const EquivalentSystem back = equivalent_system({4000.0, 4000.0}, {-5.0, -10.0}, -10.0);
  CHECK(back.participation == about(1.2));
  CHECK(back.mass == about(6000.0));
  CHECK(s.effective_share() == about(0.9));
  const EquivalentSystem loose = equivalent_system({4000.0, 4000.0}, {1e-3, 9e-3}, 1e-3);  // (1 + 9)² / (2 · 82) of the mass
  CHECK(loose.effective_share() == about(100.0 / 164.0));
  const EquivalentSystem looser = equivalent_system({6000.0, 2000.0}, {1e-3, 9e-3}, 1e-3);
  CHECK(looser.effective_share() == about(24.0 * 24.0 / (8.0 * 168.0)));
  CHECK(says(point(compared(trilinear(7e-3), looser, ground_b(0.2)), 0), "parts move by themselves"));
  CHECK_FALSE(says(point(compared(trilinear(7e-3), loose, ground_b(0.2)), 0), "parts move by themselves"));
  CHECK(std::isnan(equivalent_system({4000.0}, {0.0}, 0.0).mass));
  CHECK(std::isnan(equivalent_system({4000.0}, {-1.0}, 1.0).mass));
}

TEST_CASE("performance: N2 of a short period moves farther than an elastic structure") {
  const Capacity c = compared(trilinear(7e-3), two_masses(), ground_b(0.1 * kG));
  const PerformancePoint& p = point(c, 0);
  CHECK(p.force == about(8333.3333333));
  CHECK(p.yield == about(8.3333333e-4));
  CHECK(p.period == about(0.1539059796));
  CHECK(p.spectral == about(2.941995));
  CHECK(p.ratio == about(2.1182364));
  CHECK(p.elastic == about(1.765197e-3));
  CHECK(p.target_star == about(3.860713e-3));
  CHECK(p.target == about(4.6328556e-3));
  const double near_collapse = 5e-3 + 0.2 / 0.3 * 1e-3;
  CHECK(c.near_collapse == about(near_collapse));
  CHECK(p.demand == about(4.6328556e-3 / near_collapse));
  CHECK_FALSE(p.at_most);
  CHECK(point(c, 1).force == about(8214.46737));
  CHECK(point(c, 1).ratio == about(2.1488880));
  CHECK(point(c, 1).target == about(4.6649314e-3));
}

TEST_CASE("performance: N2 in its other branches: elastic, equal displacements, and three times the elastic displacement at most") {
  const Capacity weak = compared(trilinear(7e-3), two_masses(), ground_b(0.2));
  CHECK(point(weak, 0).ratio < 1.0);
  CHECK(point(weak, 0).target == about(1.2 * 3.6e-4));  // S_e is on the plateau: 2.5 · 1.2 · 0.2 m/s2, times 6e-4 s2
  Bilinear soft;
  soft.force = 1e4, soft.yield = 3e-2;
  const PerformancePoint p = n2_point("", "", soft, two_masses(), ground_b(0.1 * kG), 4.0);
  CHECK(p.period == about(0.8429777677));
  CHECK(p.ratio == about(1.2564011));
  CHECK(p.target_star == about(0.0314100277));
  CHECK(p.target == about(0.0376920332));
  const Capacity strong = compared(trilinear(7e-3), two_masses(), ground_b(1.5 * kG));
  CHECK(point(strong, 0).target_star == about(3.0 * point(strong, 0).elastic));
  CHECK(point(strong, 0).target == about(0.0953206380));
  CHECK(point(strong, 1).ratio > 4.0);
  CHECK(says(point(strong, 1), "is above 4, up to which the method is allowed"));
}

TEST_CASE("performance: the capacity spectrum meets the plateau where its damping lets it, and the elastic branch where that bears it") {
  const Capacity c = compared(trilinear(7e-3), two_masses(), ground_b(0.55));
  const PerformancePoint& p = point(c, 2);
  CHECK(p.damping == about(0.0911344).epsilon(1e-4));
  CHECK(p.target == about(1.24347067e-3).epsilon(1e-4));
  CHECK(p.period == about(0.1716221216).epsilon(1e-4));
  const Capacity weak = compared(trilinear(7e-3), two_masses(), ground_b(0.2));
  CHECK(point(weak, 2).target == about(4.32e-4).epsilon(1e-6));
  CHECK(point(weak, 2).damping == about(0.05));
  const Capacity strong = compared(trilinear(7e-3), two_masses(), ground_b(1.5 * kG));
  CHECK(std::isnan(point(strong, 2).target));
  CHECK(says(point(strong, 2), "does not meet the curve"));
}

TEST_CASE("performance: a curve that begins with noise is followed from where it has a force") {
  CapacityCurve noisy = trilinear(7e-3);
  noisy.displacement[0] = 1e-9, noisy.base_shear[0] = -3.0;
  const Capacity c = compared(std::move(noisy), two_masses(), ground_b(0.55));
  CHECK(point(c, 2).target == about(1.24347067e-3).epsilon(1e-4));
}

TEST_CASE("performance: the spectrum in the diagram is that of the demand, as far as it is shown") {
  const Capacity c = compared(trilinear(7e-3), two_masses(), ground_b(0.1 * kG));
  const SpectrumCurve& s = c.performance->curve;
  REQUIRE(s.displacement.size() > 50);
  CHECK(s.displacement.back() <= 2.0 * 7e-3 / 1.2);
  for (std::size_t i = 0; i < s.displacement.size(); ++i) {
    const double period = 2.0 * 3.14159265358979 * std::sqrt(s.displacement[i] / s.acceleration[i]);
    CHECK(s.acceleration[i] == about(eurocode8({1, 'B', 0.1 * kG}, period, 0.05)).epsilon(1e-6));
  }
}

TEST_CASE("performance: other units of force and length, and twice all of it, change what they must and nothing else") {
  const Capacity c = compared(trilinear(7e-3), two_masses(), ground_b(0.55));
  const Capacity doubled = compared(trilinear(7e-3, 2.0), two_masses(8000.0), ground_b(0.55));   // two houses side by side
  const Capacity longer = compared(trilinear(7e-3, 1.0, 4.0), two_masses(), ground_b(0.55));     // as stiff as a quarter
  const Capacity stronger = compared(trilinear(7e-3, 3.0), two_masses(), ground_b(3.0 * 0.55));  // all accelerations three times
  const Capacity faster = compared(trilinear(7e-3, 3.0), two_masses(12000.0), ground_b(0.55));   // the same twice
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(point(doubled, i).target == about(point(c, i).target).epsilon(1e-9));
    CHECK(point(doubled, i).period == about(point(c, i).period).epsilon(1e-9));
    CHECK(point(faster, i).target == about(point(c, i).target).epsilon(1e-9));
    CHECK(point(longer, i).period == about(2.0 * point(c, i).period).epsilon(0.05));
    CHECK(point(stronger, i).demand < 3.0 * point(c, i).demand);
  }
}

TEST_CASE("performance: what the curve does not show is said, not guessed") {
  SUBCASE("the curve ends before near collapse: an upper bound") {
    const Capacity c = compared(trilinear(4.9e-3), two_masses(), ground_b(0.05 * kG));
    CHECK(std::isnan(c.near_collapse));
    const PerformancePoint& p = point(c, 0);
    CHECK(p.at_most);
    CHECK(p.demand == about(1.1920595e-3 / 4.9e-3));
    CHECK(says(p, "near collapse lies beyond the end of the curve at 4.90 mm"));
    CHECK(capacity_text(c).find("demand over capacity at most 0.243 (near collapse beyond 4.90 mm)") != std::string::npos);
  }
  SUBCASE("the curve ends before the target") {
    const Capacity c = compared(trilinear(2e-3), two_masses(), ground_b(0.1 * kG));
    CHECK(std::isnan(point(c, 0).demand));
    CHECK(says(point(c, 0), "the curve ends at 2.00 mm, before the target displacement"));
    CHECK(capacity_text(c).find("demand over capacity not known") != std::string::npos);
  }
  SUBCASE("a target that is borne, on a curve that does not go half as far again") {
    const Capacity c = compared(trilinear(6.0e-3), two_masses(), ground_b(0.1 * kG));
    CHECK(says(point(c, 0), "up to 1.5 times the target; this one ends at 1.30 times"));
  }
  SUBCASE("a control point that springs back") {
    CapacityCurve curve = trilinear(7e-3);
    for (std::size_t i = 501; i < curve.displacement.size(); ++i) curve.displacement[i] = 5e-3 - (curve.displacement[i] - 5e-3) * 7.0;
    const Capacity c = compared(std::move(curve), two_masses(), ground_b(0.05 * kG));
    CHECK(std::isnan(point(c, 0).demand));
    CHECK(says(point(c, 0), "set analysis.control"));
  }
  SUBCASE("no spectrum at the period") {
    DemandSpectrum d;
    d.target.period = {0.3, 1.0}, d.target.acceleration = {2.0, 1.0}, d.corner = 0.5;
    const Capacity c = compared(trilinear(7e-3), two_masses(), d);
    CHECK(says(point(c, 0), "the spectrum has no value at T* = 0.154 s"));
    CHECK(says(point(c, 2), "no values at some of the periods"));
  }
  SUBCASE("a corner period that is not stated is needed only by what yields") {
    DemandSpectrum d;
    d.target.period = {0.05, 1.0}, d.target.acceleration = {2.0, 2.0}, d.corner = Bilinear::kNone;
    CHECK(says(point(compared(trilinear(7e-3), two_masses(), d), 0), "T_C of the spectrum is not stated"));
    d.target.acceleration = {0.5, 0.5};
    CHECK(point(compared(trilinear(7e-3), two_masses(), d), 0).open.empty());
  }
}

TEST_CASE("performance: its figures stand among those of the capacity") {
  const Capacity c = compared(trilinear(7e-3), two_masses(), ground_b(0.1 * kG));
  const auto json = nlohmann::json::parse(capacity_json(c, false));
  CHECK(json["n2_ec8_target"].get<double>() == about(4.6328556e-3));
  CHECK(json["participation"].get<double>() == about(1.2));
  CHECK(json["performance"]["points"].size() == 3);
  CHECK(json["near_collapse"].get<double>() == about(c.near_collapse));
  const std::string text = capacity_text(c);
  CHECK(text.find("participation 1.200, m* 6.00 t of 8.00 t, effective 90.0 %") != std::string::npos);
  CHECK(text.find("participation below 1") == std::string::npos);
  Performance less = *c.performance;
  less.system.participation = 0.82;
  CHECK(
      performance_text(less).find("participation below 1: the control point moves less than other parts do, so F* is larger than the base "
                                  "shear") != std::string::npos);
  CHECK(text.find("target displacement 4.63 mm (d*_t 3.86 mm); demand over capacity 0.818 (near collapse 5.67 mm)") != std::string::npos);
  CHECK(text.find("F*_y 8.33 kN, d*_y 0.833 mm, T* 0.1539 s, S_e 2.942 m/s2, q_u 2.118, d*_et 1.765 mm") != std::string::npos);
}
