// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "tests/verification/structures/arch.h"
#include "tests/verification/collapse.h"

// A semicircular dry arch whose supports part (Ochsendorf 2006, The masonry arch on spreading supports): a crack opens at the crown and one
// in each haunch, and the arch sinks on its three hinges until no line of thrust is left in it.
namespace voussoir::testing {
namespace {

/// The right half of the arch on hinges at the crown's outermost and at a haunch's innermost row of contact points, in the shape that the
/// spread of the supports gives it. Below the hinge the half moves with its support, above it turns about the hinge.
class ThreeHinges {
 public:
  /// \param hinge  joint of the haunch \param spread  of the supports, by which the span has grown [m]
  ThreeHinges(const Arch& arch, int hinge, double spread) : arch_(arch), hinge_(hinge), spread_(spread) {
    const Point h = arch.inner(hinge), c = arch.outer(crown());
    const double length = std::hypot(c.y - h.y, c.z - h.z), across = h.y + 0.5 * spread;
    const double turned = std::atan2(std::sqrt(length * length - across * across), -across) - std::atan2(c.z - h.z, c.y - h.y);
    cos_ = std::cos(turned), sin_ = std::sin(turned);
    for (int i = 0; i < crown(); ++i) {
      const Lamina l = arch.lamina(i);
      weight_.push_back(l.area);
      centroid_.push_back(moved({l.moment_y / l.area, l.moment_z / l.area}, i >= hinge).y);
    }
    thrust_ = -moment(hinge, moved(h, true), 0.0) / (moved(c, true).z - moved(h, true).z);
  }

  /// By how much the centroids of the two voussoirs at the crown have sunk [m].
  [[nodiscard]] double sinking() const {
    const Lamina l = arch_.lamina(crown() - 1);
    const Point c{l.moment_y / l.area, l.moment_z / l.area};
    return c.z - moved(c, true).z;
  }
  struct Exit {
    double miss = -1e300;  // moment of what lies above about the row that the line of thrust passes outside of; <= 0: it stays inside
    int joint = 0;
    bool outer = false;
  };
  /// Where the line of thrust comes nearest to leaving the arch, or is farthest outside: hinges aside.
  [[nodiscard]] Exit exit() const {
    Exit worst;
    for (int j = 0; j <= crown(); ++j) {
      const double inside = moment(j, moved(arch_.inner(j), j >= hinge_), thrust_);
      const double outside = moment(j, moved(arch_.outer(j), j >= hinge_), thrust_);
      if (j != hinge_ && -inside > worst.miss) worst = {-inside, j, false};
      if (j != crown() && outside > worst.miss) worst = {outside, j, true};
    }
    return worst;
  }

 private:
  [[nodiscard]] int crown() const { return arch_.voussoirs / 2; }
  [[nodiscard]] Point moved(Point p, bool above) const {
    if (!above) return {p.y + 0.5 * spread_, p.z};
    const Point h = arch_.inner(hinge_);
    const double y = p.y - h.y, z = p.z - h.z;
    return {h.y + 0.5 * spread_ + cos_ * y - sin_ * z, h.z + sin_ * y + cos_ * z};
  }
  /// Of the thrust at the crown and the weights above joint j about a point of it; outwards is positive.
  [[nodiscard]] double moment(int j, Point about, double thrust) const {
    double sum = thrust * (moved(arch_.outer(crown()), true).z - about.z);
    for (std::size_t i = static_cast<std::size_t>(j); i < weight_.size(); ++i) sum -= weight_[i] * (about.y - centroid_[i]);
    return sum;
  }

  Arch arch_;
  int hinge_;
  double spread_, cos_ = 1.0, sin_ = 0.0, thrust_ = 0.0;  // thrust over the weight of unit area
  std::vector<double> weight_, centroid_;                 // y of the centroids, moved
};

/// What kinematics and statics expect of an arch.
struct Expected {
  int hinge = 0;        // joint of the haunch
  double spread = 0.0;  // at which it falls, m
};
/// The hinge of the first movement stays until the line of thrust leaves the arch somewhere else; at the outside of a springing that is the
/// end: with five hinges nothing holds it.
Expected expected(const Arch& arch) {
  Expected e;
  while (ThreeHinges(arch, e.hinge, 0.0).exit().miss > 0.0) REQUIRE(++e.hinge < arch.voussoirs / 2);
  const Point haunch = arch.inner(e.hinge), crown = arch.outer(arch.voussoirs / 2);
  const double flat = 2.0 * (std::hypot(haunch.y - crown.y, haunch.z - crown.z) - haunch.y);  // the three hinges in one line
  e.spread = bisect(0.0, flat, 1e-9, [&](double spread) { return ThreeHinges(arch, e.hinge, spread).exit().miss > 0.0; });
  const ThreeHinges::Exit end = ThreeHinges(arch, e.hinge, e.spread + 1e-6).exit();
  REQUIRE(end.joint == 0);  // the springing
  REQUIRE(end.outer);
  return e;
}

constexpr double kSpeed = 0.02;  // m/s, at which the supports part: arch_spreads.toml

/// The case with another arch.
cases::Case on_supports(const Arch& arch) {
  cases::Case c = load("arch_spreads").value;
  arch.shape(c);
  for (const auto& [name, side] : {std::pair{"right support", 1.0}, std::pair{"left support", -1.0}}) {
    const auto block = std::ranges::find(c.blocks, name, &cases::BlockSpec::name);
    const double middle = side * arch.radius, half = 0.5 * arch.thickness;
    block->box = {{{0.0, middle - half, -0.2}, {0.2, middle + half, 0.0}}};
    REQUIRE(norm(*block->motion->velocity - Vec3{0.0, 0.5 * side * kSpeed, 0.0}) == 0.0);
  }
  return c;
}

/// Spread of the supports and sinking of the crown until the arch falls: until it lies 1 mm below its three hinges.
struct History {
  std::vector<double> spread, sinking, hinged;  // m
};
History spread_apart(const Arch& arch, const Expected& e) {
  Run run(on_supports(arch));
  CHECK(run.settle());
  const std::size_t right = static_cast<std::size_t>(arch.voussoirs / 2 - 1), left = right + 1;  // of the crown
  History h;
  do {
    h.spread.push_back(kSpeed * run.time());
    h.sinking.push_back(-0.5 * (run.displacement(left).z + run.displacement(right).z));
    h.hinged.push_back(ThreeHinges(arch, e.hinge, std::min(h.spread.back(), e.spread)).sinking());
    run.until(run.time() + 0.02);
  } while (h.sinking.back() < h.hinged.back() + 1e-3 && h.spread.back() < 1.1 * e.spread);
  return h;
}

/// Compares with the three hinges; returns the spread at which the arch fell.
double compare(const Arch& arch, const History& h, const Expected& e) {
  const std::string what = "arch on spreading supports, n = " + std::to_string(arch.points) + ": ";
  double off = 0.0;
  for (std::size_t i = 0; i < h.spread.size() && h.spread[i] < 0.95 * e.spread; ++i)
    off = std::max(off, std::abs(h.sinking[i] - h.hinged[i]));
  expect_near(what + "spread at which it falls [m]", h.spread.back(), e.spread, 2e-2);
  expect_below(what + "sinking of the crown off that of three hinges [m], until 95 % of that", off, 5e-4);
  return h.spread.back();
}

Arch with_points(int n) { return {.thickness = 0.4, .voussoirs = 24, .points = n}; }

}  // namespace

TEST_CASE("arch on spreading supports") {
  const Arch arch = with_points(4);
  const Expected e = expected(arch);
  const History h = spread_apart(arch, e);
  compare(arch, h, e);
  write(Curve{"arch_spreads",
              "Arch on spreading supports",
              "spread of the supports [m]",
              "sinking of the crown [m]",
              false,
              {{"three hinges", "--", h.spread, h.hinged}, {"computed", "-", h.spread, h.sinking}}});
}

TEST_CASE("arch on spreading supports: convergence with the size of segments" * doctest::skip()) {
  Series got{"computed", "o", {}, {}}, hinged{"three hinges between the contact points", "--", {}, {}};
  Series continuum{"three hinges at the edges", "-", {0.0, 1.0 / 3.0}, {}};
  continuum.y.assign(2, expected(with_points(1 << 20)).spread);
  for (const int n : {3, 4, 6}) {
    const Expected e = expected(with_points(n));
    got.x.push_back(1.0 / n), got.y.push_back(compare(with_points(n), spread_apart(with_points(n), e), e));
    hinged.x.push_back(1.0 / n), hinged.y.push_back(e.spread);
  }
  write(Curve{"arch_spread_convergence",
              "Arch on spreading supports: spread at which it falls",
              "1/n, n contact points across the thickness",
              "spread [m]",
              false,
              {got, hinged, continuum}});
}

}  // namespace voussoir::testing
