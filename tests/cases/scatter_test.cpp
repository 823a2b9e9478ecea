// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/rules/scatter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/case.h"

using namespace voussoir;
using namespace voussoir::cases;

namespace {

constexpr int kMany = 40000;

Scatter scatter(Distribution d, double variation, int seed = 1) { return {seed, variation, d, {}}; }

/// Factors of joints as a wall has them: neighbours along a row, each with one face or another.
std::vector<double> draw(const Scatter& s, int count) {
  std::vector<double> all;
  for (std::int32_t i = 0; i < count; ++i) all.push_back(strength_factor(s, {i / 4, i % 4, i / 4 + 1, (i + 1) % 4}));
  return all;
}

struct Moments {
  double mean = 0.0, deviation = 0.0;
};
Moments moments(const std::vector<double>& x) {
  Moments m;
  for (const double v : x) m.mean += v / static_cast<double>(x.size());
  for (const double v : x) m.deviation += (v - m.mean) * (v - m.mean) / static_cast<double>(x.size() - 1);
  m.deviation = std::sqrt(m.deviation);
  return m;
}

/// Correlation of neighbours in the list.
double neighbour_correlation(const std::vector<double>& x) {
  const Moments m = moments(x);
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += (x[i - 1] - m.mean) * (x[i] - m.mean);
  return sum / (static_cast<double>(x.size() - 1) * m.deviation * m.deviation);
}

/// Two materials and three laws, a stack of four blocks on the base.
Case stack() {
  Case c;
  c.materials["adobe"] = {1800.0, 9.8e7, 0.25};
  c.materials["wood"] = {700.0, 6.3e8, 0.3};
  c.joint_laws["mud"] = {1e4, 1e4, 30.0, 1e5};
  c.joint_laws["glue"] = {1e6, 1e6, 30.0, 1e7};
  c.joints.default_law = "mud";
  c.joints.between = {{{"wood", "wood"}, "glue"}, {{"adobe", "base"}, "dry"}};
  c.base = Base{};
  for (int i = 0; i < 4; ++i) {
    BlockSpec b;
    b.name = "b" + std::to_string(i);
    b.material = i < 2 ? "adobe" : "wood";
    b.box = {{Vec3{0.0, 0.0, 0.1 * i}, Vec3{0.2, 0.1, 0.1 * (i + 1)}}};
    c.blocks.push_back(b);
  }
  c.scatter = scatter(Distribution::lognormal, 0.3);
  return c;
}

}  // namespace

TEST_CASE("scatter: mean 1 and the coefficient of variation asked for") {
  for (const Distribution d : {Distribution::lognormal, Distribution::normal, Distribution::uniform}) {
    for (const double variation : {0.01, 0.1, 0.3}) {
      CAPTURE(static_cast<int>(d));
      CAPTURE(variation);
      const Moments m = moments(draw(scatter(d, variation), kMany));
      // Five standard errors of a mean; the cut at three deviations costs the variation about 1 % (and a lognormal's mean a little more
      // of it), sampling five times 1/sqrt(2 N).
      CHECK(std::abs(m.mean - 1.0) < variation * (5.0 / std::sqrt(kMany) + 0.02 * variation));
      CHECK(std::abs(m.deviation / variation - 1.0) < 5.0 / std::sqrt(2.0 * kMany) + 0.02);
    }
  }
}

TEST_CASE("scatter: bounds of each distribution") {
  const double v = 0.3, cut = kScatterCut;
  const auto range = [&](Distribution d) {
    const std::vector<double> x = draw(scatter(d, v), kMany);
    return std::pair(*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()));
  };
  const auto [low_n, high_n] = range(Distribution::normal);
  CHECK(low_n == doctest::Approx(1.0 - cut * v).epsilon(1e-12));  // of 40,000 some lie beyond
  CHECK(high_n == doctest::Approx(1.0 + cut * v).epsilon(1e-12));
  const auto [low_u, high_u] = range(Distribution::uniform);
  CHECK(low_u >= 1.0 - std::sqrt(3.0) * v);
  CHECK(high_u <= 1.0 + std::sqrt(3.0) * v);
  CHECK(high_u - low_u > 0.999 * 2.0 * std::sqrt(3.0) * v);
  const double sigma = std::sqrt(std::log(1.0 + v * v));
  const auto [low_l, high_l] = range(Distribution::lognormal);
  CHECK(low_l == doctest::Approx(std::exp(-cut * sigma - 0.5 * sigma * sigma)).epsilon(1e-12));
  CHECK(high_l == doctest::Approx(std::exp(cut * sigma - 0.5 * sigma * sigma)).epsilon(1e-12));
  CHECK(low_l > 0.0);
}

TEST_CASE("scatter: half of the lognormal factors lie below exp(-s^2/2), a sixth beyond each deviation") {
  const double v = 0.4, sigma = std::sqrt(std::log(1.0 + v * v));
  const std::vector<double> x = draw(scatter(Distribution::lognormal, v), kMany);
  const auto share_below = [&](double z) {
    const double limit = std::exp(z * sigma - 0.5 * sigma * sigma);
    return static_cast<double>(std::count_if(x.begin(), x.end(), [&](double f) { return f < limit; })) / kMany;
  };
  for (const double z : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    CAPTURE(z);
    CHECK(std::abs(share_below(z) - 0.5 * std::erfc(-z / std::sqrt(2.0))) < 0.01);
  }
}

TEST_CASE("scatter: the same seed gives the same bits, another seed others, neighbours are independent") {
  const std::vector<double> a = draw(scatter(Distribution::lognormal, 0.2, 5), kMany);
  CHECK(a == draw(scatter(Distribution::lognormal, 0.2, 5), kMany));
  const std::vector<double> b = draw(scatter(Distribution::lognormal, 0.2, 6), kMany);
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) same += a[i] == b[i];
  CHECK(same < 200);  // those cut at three deviations may agree: 0.27 % of each side, squared
  CHECK(std::abs(neighbour_correlation(a)) < 5.0 / std::sqrt(kMany));
}

TEST_CASE("scatter: a model has a factor for every joint of the laws that take part") {
  Case c = stack();
  const Model all = build_model(c);
  REQUIRE(all.joint_strength.size() == all.assembly.joints.size());
  REQUIRE(all.joint_strength.size() == 4);
  c.scatter.laws = {"glue"};
  const Model glue = build_model(c);
  c.scatter.variation = 0.0;
  const Model none = build_model(c);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string& law = all.laws[static_cast<std::size_t>(all.joint_law[i])].name;
    CHECK((all.joint_strength[i] != 1.0) == (law != "dry"));
    CHECK(glue.joint_strength[i] == (law == "glue" ? all.joint_strength[i] : 1.0));
    CHECK(none.joint_strength[i] == 1.0);
  }
}

TEST_CASE("scatter: a joint keeps its factor when blocks are added at the end") {
  Case c = stack();
  const Model before = build_model(c);
  BlockSpec top = c.blocks.back();
  top.name = "top";
  top.box = {{Vec3{0.0, 0.0, 0.4}, Vec3{0.2, 0.1, 0.5}}};
  c.blocks.push_back(top);
  const Model after = build_model(c);
  for (std::size_t i = 0; i < before.assembly.joints.size(); ++i) {
    const geometry::Joint& j = before.assembly.joints[i];
    for (std::size_t k = 0; k < after.assembly.joints.size(); ++k) {
      const geometry::Joint& l = after.assembly.joints[k];
      if (l.element_a == j.element_a && l.element_b == j.element_b) CHECK(after.joint_strength[k] == before.joint_strength[i]);
    }
  }
}

TEST_CASE("scatter: what cannot be is refused") {
  Case c = stack();
  const auto refused = [&](const Scatter& s) -> std::string {
    c.scatter = s;
    try {
      build_model(c);
    } catch (const InputError& e) {
      return e.key();
    }
    return "built";
  };
  CHECK(refused(scatter(Distribution::normal, 0.3)) == "built");
  CHECK(refused(scatter(Distribution::normal, 0.4)) == "scatter.variation");
  CHECK(refused(scatter(Distribution::uniform, 0.6)) == "scatter.variation");
  CHECK(refused(scatter(Distribution::lognormal, -0.1)) == "scatter.variation");
  CHECK(refused({1, 0.1, Distribution::lognormal, {"mud", "lime"}}) == "scatter.laws[1]");
}
