// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "solver/setup/setup.h"
#include "solver/setup/worst_dashpots.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;

namespace {

using Dashpots = std::vector<std::array<double, 2>>;

/// Pair by pair.
Dashpots plain(const std::vector<solver::FaceClass>& classes, double h) {
  Dashpots worst;
  for (const solver::FaceClass& a : classes) {
    double cn = 0.0, cs = 0.0;
    for (const solver::FaceClass& b : classes) {
      cn = std::max(cn, 2.0 * h * std::sqrt((a.mass + b.mass) / (a.compliance_n + b.compliance_n)));
      cs = std::max(cs, 2.0 * h * std::sqrt((a.mass + b.mass) / (a.compliance_s + b.compliance_s)));
    }
    worst.push_back({cn, cs});
  }
  return worst;
}

enum class Kind { one_material, two_materials, any };

/// Of faces 0.1 to 1 m from the middles of their stones. Of one material, mass over compliance is one number but for rounding.
std::vector<solver::FaceClass> random_classes(int count, Kind kind) {
  std::mt19937_64 engine{2026};
  const auto random = [&](double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<solver::FaceClass> classes;
  for (int i = 0; i < count; ++i) {
    const double distance = random(0.1, 1.0);
    const bool second = kind == Kind::two_materials && i % 3 == 0;
    const double young = kind == Kind::any ? random(1e9, 9e9)
                         : second          ? 1.3e9
                                           : 5.7e9,
                 density = kind == Kind::any ? random(600.0, 2700.0)
                           : second          ? 700.0
                                             : 2200.0;
    classes.push_back({distance / (young / (1.0 - 0.2 * 0.2)), 2.0 * distance * 1.2 / young, density * distance});
  }
  return classes;
}

}  // namespace

TEST_CASE("the largest dashpots of faces are, bit by bit, those of the plain loop over all pairs") {
  for (const Kind kind : {Kind::one_material, Kind::two_materials, Kind::any}) {
    for (const int count : {1, 13, 3000}) {
      const std::vector<solver::FaceClass> classes = random_classes(count, kind);
      const Dashpots expected = plain(classes, 0.7);
      INFO(count << " classes, kind " << static_cast<int>(kind));
      for (const int threads : {1, 2, 3}) {
        solver::Team team(threads);
        CHECK(solver::worst_dashpots(classes, 0.7, team) == expected);
      }
    }
  }
  solver::Team team(2);
  CHECK(solver::worst_dashpots(random_classes(20, Kind::any), 0.0, team).front() == std::array{0.0, 0.0});
  CHECK(solver::worst_dashpots({}, 1.0, team).empty());
}

TEST_CASE("with points up to the rim the bounds of damping rates are those of the model turned, mirrored and with another first corner") {
  // A prism on another twice as wide. The points of the free part of the lower one's top depend on how it is cut into convex pieces.
  const int n = 7;
  const auto prism = [&](int first, double turn, double side, double low, double radius) {
    cases::BlockSpec b;
    b.name = low > 0.0 ? "upper" : "lower", b.material = "stone";
    for (const double z : {low, low + 0.3}) {
      for (int i = 0; i < n; ++i) {
        const int k = side > 0.0 ? i + first : first - i;
        const double angle = 2.0 * std::numbers::pi * k / n, r = radius * (1.0 + 0.05 * ((k + n) % n));
        const double x = side * r * std::cos(angle), y = r * std::sin(angle);
        b.vertices.push_back({x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), z});
      }
    }
    b.faces.resize(2);
    for (int i = 0; i < n; ++i) {
      b.faces[0].insert(b.faces[0].begin(), i), b.faces[1].push_back(n + i);
      b.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    return b;
  };
  const auto bounds_of = [&](int first, double turn, double side) {
    cases::Case c;
    c.materials["stone"] = {2000.0, 5e9, 0.2};
    c.base = cases::Base{};
    c.segment_rule = geometry::SegmentRule::rim, c.segment_size = 0.1;
    c.blocks = {prism(first, turn, side, 0.0, 0.6), prism(first, turn, side, 0.3, 0.3)};
    const cases::Model model = cases::build_model(c);
    const std::unique_ptr<solver::World> world = solver::build_world(c, model, {});
    return std::array{world->elements.body[0].beta, world->elements.body[1].beta};
  };
  const auto expected = bounds_of(0, 0.0, 1.0);
  for (const int first : {0, 1, 4}) {
    for (const double turn : {0.0, 1.0, 4.0}) {
      for (const double side : {1.0, -1.0}) {
        const auto found = bounds_of(first, turn, side);
        for (std::size_t k = 0; k < 2; ++k) CHECK(found[k] == doctest::Approx(expected[k]).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("the bounds of damping rates are the same bit by bit, however many threads set up the model") {
  const cases::Case c = testing::small_wall(6, 6);
  const cases::Model model = cases::build_model(c);
  const auto bounds_of = [&](int threads) {
    solver::Options options;
    options.threads = threads;
    const std::unique_ptr<solver::World> world = solver::build_world(c, model, options);
    std::vector<double> bounds;
    for (const kernels::BodyConstants& b : world->elements.body) bounds.push_back(b.beta);
    return bounds;
  };
  const std::vector<double> one = bounds_of(1);
  CHECK(one.front() > 0.0);
  for (const int threads : {2, 3, 7}) CHECK(bounds_of(threads) == one);
}
