// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "geometry/segments/rim_points.h"
#include "kernels/laws/softening.h"

// A bond wrench: a joint bent without a normal force until it parts. What it bears at most must not depend on the number of its points.
using namespace voussoir;

namespace {

constexpr double kDepth = 0.1, kWide = 0.2;              // m, of the joint: along the bending, across it
constexpr kernels::Stiffness kSprings{2e10, 8e9, 0, 0};  // Pa/m: a joint of 10 mm of a mortar of 200 MPa
constexpr kernels::Strength kBond{.tension = 2e5, .cohesion = 3e5, .tan_phi = 0.75, .compression = 1e7, .cap = 1.0, .friction = 0.6};
constexpr double kStep = 5e-5;  // s

struct Curve {
  double energy = 0.0;  // J/m2, mode I
  bool linear = false;
  [[nodiscard]] double elastic() const { return kBond.tension / kSprings.kn; }
  [[nodiscard]] double length() const { return energy / kBond.tension - 0.5 * elastic(); }
  /// Stress at an opening that has only grown.
  [[nodiscard]] double stress(double u) const {
    if (u <= elastic()) return kSprings.kn * u;
    const double wear = (u - elastic()) / length();
    return kBond.tension * (linear ? std::max(0.0, 1.0 - 0.5 * wear) : wear > std::log(1000.0) ? 0.0 : std::exp(-wear));
  }
  [[nodiscard]] kernels::Softening law() const { return {.opening = length() / elastic(), .linear = linear}; }
};

/// Rows of points across the bending.
struct Row {
  double s = 0.0, area = 0.0;  // m, m2
};

/// Where a rising function is zero.
template <class Function>
double zero_of(const Function& f, double low, double high) {
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Largest moment [N m] over all turns. `advance(middle, turn, keep)` returns normal force and moment of the joint.
template <class Advance>
double largest_moment(const Curve& c, const Advance& advance) {
  constexpr int kTurns = 300;
  double most = 0.0;
  for (int i = 1; i <= kTurns; ++i) {
    const double turn = i * (c.elastic() + 2.0 * c.length()) / kDepth / kTurns;
    const double middle = zero_of([&](double m) { return advance(m, turn, false).first; }, -turn * kDepth, turn * kDepth);
    most = std::max(most, advance(middle, turn, true).second);
  }
  return most;
}

/// By the curve alone, for whatever rows.
double by_curve(const Curve& c, const std::vector<Row>& rows) {
  return largest_moment(c, [&](double middle, double turn, bool) {
    double force = 0.0, moment = 0.0;
    for (const Row& r : rows) {
      const double f = c.stress(middle + turn * r.s) * r.area;
      force += f, moment += f * r.s;
    }
    return std::pair(force, moment);
  });
}

/// By segments that are led through all turns.
double by_segments(const Curve& c, const std::vector<Row>& rows) {
  struct State {
    kernels::SegmentState q;
    double wear = 0.0, u = 0.0;
  };
  std::vector<State> kept(rows.size());
  const kernels::Softening law = c.law();
  return largest_moment(c, [&](double middle, double turn, bool keep) {
    std::vector<State> now = kept;
    double force = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double u = middle + turn * rows[k].s, rate = (u - now[k].u) / kStep;
      now[k].u = u;
      const auto out = kernels::advance_soft_segment(now[k].q, now[k].wear, {u, 0, 0}, {rate, 0, 0}, kStep, kSprings, kBond, law, {});
      force += out.traction.n * rows[k].area, moment += out.traction.n * rows[k].area * rows[k].s;
    }
    if (keep) kept = now;
    return std::pair(force, moment);
  });
}

std::vector<Row> centres(int n) {
  std::vector<Row> rows;
  for (int i = 0; i < n; ++i) rows.push_back({kDepth * ((i + 0.5) / n - 0.5), kWide * kDepth / n});
  return rows;
}

/// Those of segments.rule = rim for so many cells along the bending.
std::vector<Row> rim(int cells) {
  std::vector<geometry::Segment> points;
  const double a = 0.5 * kDepth, b = 0.5 * kWide;
  geometry::append_rim_points({{-a, -b}, {a, -b}, {a, b}, {-a, b}}, kDepth / cells, points);
  std::vector<Row> rows;
  for (const geometry::Segment& p : points) {
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return std::abs(r.s - p.s) < 1e-9; });
    if (same == rows.end()) {
      rows.push_back({p.s, p.area});
    } else {
      same->area += p.area;
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("bond wrench: a joint that softens bears in bending what its curve says for its points, and from seven on no other") {
  for (const bool linear : {false, true}) {
    for (const double energy : {5.0, 12.0}) {
      const Curve c{energy, linear};
      const double continuum = by_curve(c, centres(1000)), elastic = kBond.tension * kWide * kDepth * kDepth / 6.0;
      CHECK(continuum > 1.05 * elastic);  // it has strength left behind the first crack
      CHECK(continuum < 3.0 * elastic);   // that of a joint that keeps f_t all over
      for (const int cells : {1, 4, 5, 6, 9}) {
        const std::vector<Row> rows = rim(cells);
        const double got = by_segments(c, rows);
        MESSAGE("rim, ", rows.size(), " points, ", std::string(linear ? "linear, " : "exponential, "), energy, " J/m2: ", got / continuum,
                " of the continuum's");
        CHECK(got == doctest::Approx(by_curve(c, rows)).epsilon(1e-3));
        if (rows.size() >= 7) CHECK(got == doctest::Approx(continuum).epsilon(0.05));
      }
      for (const int n : {4, 8}) {
        const double got = by_segments(c, centres(n));
        MESSAGE("centres, ", n, " points: ", got / continuum);
        CHECK(got == doctest::Approx(by_curve(c, centres(n))).epsilon(1e-3));
        CHECK(got == doctest::Approx(continuum).epsilon(0.05));
      }
    }
  }
}
