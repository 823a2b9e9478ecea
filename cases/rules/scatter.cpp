// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/rules/scatter.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/random.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// The random numbers of one joint, by counter.
class Draws {
 public:
  Draws(int seed, const std::array<std::int32_t, 4>& joint) noexcept : key_(mixed(static_cast<std::uint64_t>(seed))) {
    for (const std::int32_t part : joint) key_ = mixed(key_ ^ static_cast<std::uint32_t>(part));
  }
  /// A uniform number in (0, 1): the middle of one of 2^53 equal parts.
  [[nodiscard]] double uniform(std::uint64_t counter) const noexcept {
    return (static_cast<double>(mixed(key_ + counter) >> 11) + 0.5) * 0x1p-53;
  }
  /// A normal number: the sum of twelve uniform numbers has variance 1, and is normal but for its far tails (excess kurtosis −0.1), which
  /// are cut.
  [[nodiscard]] double normal() const noexcept {
    double sum = -6.0;
    for (std::uint64_t k = 0; k < 12; ++k) sum += uniform(k);
    return std::clamp(sum, -kScatterCut, kScatterCut);
  }

 private:
  std::uint64_t key_;
};

/// eˣ for |x| ≤ 8 by its series at x/64 (next term under 1e-16) and six squarings, since the bits of std::exp depend on the processor.
double exponential(double x) noexcept {
  const double y = x / 64.0;
  double sum = 1.0;
  for (int k = 12; k > 0; --k) sum = 1.0 + y * sum / k;
  for (int i = 0; i < 6; ++i) sum *= sum;
  return sum;
}

/// ln(1 + y) for 0 ≤ y ≤ 1, as 2 artanh(y/(2 + y)) by its series.
double logarithm_of_one_plus(double y) noexcept {
  const double t = y / (2.0 + y), t2 = t * t;
  double sum = 0.0;
  for (int k = 41; k > 0; k -= 2) sum = 1.0 / k + t2 * sum;
  return 2.0 * t * sum;
}

/// Largest coefficient of variation allowed: strengths stay above zero; for lognormal, the cut changes it little.
double most_variation(Distribution d) noexcept {
  switch (d) {
    case Distribution::normal:
      return 0.33;
    case Distribution::uniform:
      return 0.57;
    case Distribution::lognormal:
      return 1.0;
  }
  return 0.0;
}

}  // namespace

double strength_factor(const Scatter& s, const std::array<std::int32_t, 4>& joint) noexcept {
  if (s.variation == 0.0) return 1.0;
  const Draws draws(s.seed, joint);
  switch (s.distribution) {
    case Distribution::normal:
      return 1.0 + s.variation * draws.normal();
    case Distribution::uniform:
      return 1.0 + s.variation * std::sqrt(3.0) * (2.0 * draws.uniform(0) - 1.0);
    case Distribution::lognormal: {
      const double variance = logarithm_of_one_plus(s.variation * s.variation);
      return exponential(std::sqrt(variance) * draws.normal() - 0.5 * variance);
    }
  }
  return 1.0;
}

void check_scatter(const Scatter& s) {
  const double most = most_variation(s.distribution);
  if (s.variation >= 0.0 && s.variation <= most) return;
  throw InputError("scatter.variation", "= " + text(s.variation) + "; allowed with this distribution: 0 to " + text(most));
}

std::vector<double> strength_factors(const Scatter& s, const Model& model) {
  check_scatter(s);
  std::vector<bool> takes_part(model.laws.size(), s.laws.empty());
  takes_part[0] = false;  // "dry"
  for (std::size_t i = 0; i < s.laws.size(); ++i) {
    const std::int32_t law = find_law(model.laws, s.laws[i], indexed_key("scatter.laws", i, ""));
    nth(takes_part, law) = law != 0;
  }
  for (std::size_t i = 0; i < model.laws.size(); ++i) {
    const NamedLaw& law = model.laws[i];
    if (law.made_from >= 0) takes_part[i] = nth(takes_part, law.made_from);
    if (law.never_breaks) takes_part[i] = false;
  }
  std::vector<double> factors;
  factors.reserve(model.assembly.joints.size());
  for (std::size_t i = 0; i < model.assembly.joints.size(); ++i) {
    const geometry::Joint& j = model.assembly.joints[i];
    const bool scattered = nth(takes_part, model.joint_law[i]);
    factors.push_back(scattered ? strength_factor(s, {j.element_a, j.face_a, j.element_b, j.face_b}) : 1.0);
  }
  return factors;
}

}  // namespace voussoir::cases
