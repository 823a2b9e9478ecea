// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/structures/arch.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/verification/collapse.h"
#include "tests/verification/limit_analysis.h"

// V6: a semicircular dry arch of plane-faced voussoirs on rigid springings (Milankovitch 1907, Heyman 1969).
namespace voussoir::testing {
namespace {

constexpr int kPoints = Arch{}.points;
constexpr double kRadius = Arch{}.radius;  // m, centre line

/// Limit analysis of the arch: a line of thrust that stays between the rows of contact points on every joint (Heyman's safe theorem).
class LimitAnalysis {
 public:
  LimitAnalysis(const Arch& arch, double lateral) : arch_(arch), lateral_(lateral) {
    for (int i = 0; i < arch.voussoirs; ++i) laminas_.push_back(arch.lamina(i));
    for (const Lamina& l : laminas_) weight_ += l.area;
  }
  [[nodiscard]] bool stands() const {
    const auto best = [&](double thrust) { return least([&](double vertical) { return miss(thrust, vertical); }); };
    return least(best) <= 1e-9 * weight_ * arch_.radius;
  }

 private:
  /// By how much the bounds on the springing's moment miss each other at a thrust and a vertical force there (per unit weight): moments
  /// about a point q of each joint of all that acts on the voussoirs before it, which are the springing's force and moment, weights and
  /// inertia.
  [[nodiscard]] double miss(double thrust, double vertical) const {
    double low = -1e300, high = 1e300;
    Lamina before;
    for (int i = 0; i <= arch_.voussoirs; ++i) {
      const auto bound = [&](Point q) {
        const double weights = -(before.moment_y - q.y * before.area) - lateral_ * (before.moment_z - q.z * before.area);
        return -((arch_.radius - q.y) * vertical - q.z * thrust + weights);
      };
      high = std::min(high, bound(arch_.outer(i)));
      low = std::max(low, bound(arch_.inner(i)));
      if (i == arch_.voussoirs) break;
      const Lamina& l = laminas_[static_cast<std::size_t>(i)];
      before = {before.area + l.area, before.moment_y + l.moment_y, before.moment_z + l.moment_z};
    }
    return low - high;
  }
  /// Least value of a convex function of a force between none and the whole weight.
  template <class F>
  [[nodiscard]] double least(const F& f) const {
    double a = 0.0, b = weight_;
    for (int i = 0; i < 50; ++i) {
      const double left = a + (b - a) / 3.0, right = b - (b - a) / 3.0;
      if (f(left) < f(right)) {
        b = right;
      } else {
        a = left;
      }
    }
    return f(0.5 * (a + b));
  }
  Arch arch_;
  double lateral_, weight_ = 0.0;  // lateral over vertical acceleration; weight over that of unit area
  std::vector<Lamina> laminas_;
};

/// The case with another arch.
cases::Case shaped(const Arch& arch) {
  cases::Case c = load("arch_stands").value;
  arch.shape(c);
  return c;
}

/// Least thickness over radius, with n contact points across the thickness, between 5 % below and above Milankovitch's for their lever.
struct LeastThickness {
  int points = kPoints;
  bool rim = false;

  [[nodiscard]] double continuum() const { return rim ? 0.107 : 0.107 / (1.0 - 1.0 / points); }
  [[nodiscard]] Arch arch(double ratio) const { return {.thickness = ratio * kRadius, .points = points, .rim = rim}; }
  [[nodiscard]] double by_limit_analysis() const {
    return bisect(0.05, 0.4, 1e-9, [this](double ratio) { return LimitAnalysis(arch(ratio), 0.0).stands(); });
  }
  [[nodiscard]] double found() const {
    return bisect(0.95 * continuum(), 1.05 * continuum(), 0.005 * continuum(),
                  [this](double ratio) { return movement(shaped(arch(ratio))) < kFalls; });
  }
};

}  // namespace

TEST_CASE("V6: the cases stand and fall as they say") {
  expect_below("V6 movement in 2 s, thickness 3 % above the limit [m]", movement(load("arch_stands").value), 1e-3);
  CHECK(movement(load("arch_falls").value) >= kFalls);
}

TEST_CASE("V6: the line of thrust and the linear programme agree on the least thickness" *
          doctest::skip(!solver::has_linear_programmes())) {
  const LeastThickness least;
  const double ratio = least.by_limit_analysis();
  const auto pushed = [&](double share) { return collapse_factors(shaped(least.arch(share * ratio)), 60.0, {0.0, 1.0, 0.0}); };
  CHECK_THROWS_AS(pushed(0.998), cases::InputError);
  CHECK(pushed(1.002).associated > 0.0);
  CHECK(pushed(1.002).associated < 5e-3);
}

TEST_CASE("V6: least thickness of a semicircular dry arch" * doctest::skip()) {
  const LeastThickness least;
  const double found = least.found();
  expect_near("V6 least t/R", found, least.continuum(), 3e-2);
  expect_near("V6 least t/R against limit analysis of the same voussoirs and contact points", found, least.by_limit_analysis(), 1e-2);
}

TEST_CASE("V6: least thickness of a dry arch, points to the rim" * doctest::skip()) {
  const LeastThickness least{4, true};
  expect_near("V6 rim: least t/R, n = 4, against limit analysis of the same voussoirs", least.found(), least.by_limit_analysis(), 1e-2);
}

TEST_CASE("V6: least thickness of a dry arch, convergence with the size of segments" * doctest::skip()) {
  Series got{"computed", "o", {}, {}}, exact{"1/n", "--", {}, {}};
  for (const int n : {3, 4, 6}) {
    const LeastThickness least{n};
    const double found = least.found();
    expect_near("V6 least t/R, n = " + std::to_string(n), found, least.by_limit_analysis(), 1e-2);
    got.x.push_back(n), got.y.push_back(1.0 - 0.107 / found);
    exact.x.push_back(n), exact.y.push_back(1.0 / n);
  }
  write(Curve{"v6_convergence",
              "V6: least thickness of a semicircular dry arch",
              "contact points across the thickness n",
              "1 less the continuum's over it",
              true,
              {got, exact}});
}

TEST_CASE("arch under horizontal acceleration" * doctest::skip()) {
  // t/R = 0.15 between the outer rows of contact points: 0.147 g without sliding (Oppenheim 1992 and others).
  const Arch arch{.thickness = 0.15 / (1.0 - 1.0 / kPoints) * kRadius};
  const double continuum = 0.147;
  const double discrete = bisect(0.0, 0.5, 1e-9, [&](double lateral) { return !LimitAnalysis(arch, lateral).stands(); });
  const double found = bisect(0.95 * continuum, 1.05 * continuum, 0.005 * continuum, [&](double lateral) {
    cases::Case c = shaped(arch);
    c.gravity.acceleration.y = lateral * kGravity;
    return movement(c) >= kFalls;
  });
  expect_near("arch, t_e/R = 0.15: horizontal acceleration at which it falls [g]", found, continuum, 3e-2);
  expect_near("arch, t_e/R = 0.15: the same against limit analysis of the same voussoirs and contact points [g]", found, discrete, 1e-2);
  const CollapseFactors programmes = collapse_factors(shaped(arch), 60.0, {0.0, 1.0, 0.0});
  expect_near("arch, t_e/R = 0.15: line of thrust against linear programme [g]", programmes.associated, discrete, 1e-6);
}

}  // namespace voussoir::testing
