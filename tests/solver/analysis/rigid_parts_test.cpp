// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/rigid_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

// Parts of a wall that is one element thick, of which it is known how they move.
namespace voussoir::testing {
namespace {

constexpr int kWide = 12, kTall = 8;
constexpr double kSize = 0.2;  // m

std::int32_t number(int i, int k) { return i + kWide * k; }

/// Still, on the base.
solver::ElementMotion wall() {
  solver::ElementMotion m;
  for (int k = 0; k < kTall; ++k)
    for (int i = 0; i < kWide; ++i) {
      m.mass.push_back(10.0 + i);
      m.centre.push_back({kSize * i, 0.0, kSize * (k + 0.5)});
      m.displacement.push_back({});
      if (i > 0) m.touching.push_back({number(i - 1, k), number(i, k)});
      m.touching.push_back({number(i, k), k > 0 ? number(i, k - 1) : -1});
    }
  return m;
}

/// The corner right of a diagonal turns about its foot by `angle` [rad]; the row on top slides by `slide` [m].
bool in_corner(int i, int k) { return i - k >= 5 && k < kTall - 1; }
solver::ElementMotion cracked(double angle, double slide) {
  solver::ElementMotion m = wall();
  const Vec3 foot{kSize * (kWide - 1), 0.0, 0.0};
  for (int k = 0; k < kTall; ++k)
    for (int i = 0; i < kWide; ++i) {
      const auto e = static_cast<std::size_t>(number(i, k));
      if (in_corner(i, k)) m.displacement[e] = cross(Vec3{0.0, angle, 0.0}, m.centre[e] - foot);
      if (k == kTall - 1) m.displacement[e] = {slide, 0.0, 0.0};
    }
  return m;
}

}  // namespace

TEST_CASE("rigid parts: a corner that turns, a course that slides, the rest stands") {
  solver::ElementMotion m = cracked(0.01, 0.02);
  for (std::size_t e = 0; e < m.mass.size(); ++e)  // elastic, a hundredth of it
    m.displacement[e].x += 1e-4 * m.centre[e].z;
  const std::vector<std::int32_t> part = solver::rigid_parts(m, 0.05);
  for (int k = 0; k < kTall; ++k)
    for (int i = 0; i < kWide; ++i) {
      INFO(i << ", " << k);
      const std::int32_t expected = k == kTall - 1 ? number(0, kTall - 1) : in_corner(i, k) ? number(5, 0) : -1;
      CHECK(part[static_cast<std::size_t>(number(i, k))] == expected);
    }
}

TEST_CASE("rigid parts: one motion is one part, and what has no mass belongs to none") {
  solver::ElementMotion m = wall();
  for (std::size_t e = 0; e < m.mass.size(); ++e) m.displacement[e] = Vec3{0.01, 0.0, 0.0} + cross(Vec3{0.0, 0.0, 0.003}, m.centre[e]);
  m.mass[3] = 0.0;
  const std::vector<std::int32_t> part = solver::rigid_parts(m, 0.01);
  CHECK(std::set<std::int32_t>(part.begin(), part.end()) == std::set<std::int32_t>{-1, 0});
  CHECK(part[3] == -1);
  CHECK(solver::rigid_parts(wall(), 0.1) == std::vector<std::int32_t>(m.mass.size(), -1));  // nothing moves
}

namespace {

/// What the means of parts leave of displacements along x, over these (roots of sums of mass × square).
double left_over(const solver::ElementMotion& m, const std::vector<std::int32_t>& part) {
  std::map<std::int32_t, std::array<double, 3>> of_part;  // mass, mass × x, mass × x²
  double all = 0.0, left = 0.0;
  for (std::size_t e = 0; e < m.mass.size(); ++e) {
    const double x = m.displacement[e].x;
    auto& s = of_part[part[e]];
    s[0] += m.mass[e], s[1] += m.mass[e] * x, s[2] += m.mass[e] * x * x;
    all += m.mass[e] * x * x;
  }
  for (const auto& [first, s] : of_part) left += first < 0 ? s[2] : s[2] - s[1] * s[1] / s[0];
  return std::sqrt(std::max(left, 0.0) / all);
}

}  // namespace

TEST_CASE("rigid parts: the less may be left over, the more parts there are; no more is left over than may be") {
  // Columns stretch and shrink in turn: no two of them move as one.
  solver::ElementMotion m = wall();
  for (std::size_t e = 0; e < m.mass.size(); ++e) m.displacement[e].x = e % kWide % 2 == 0 ? 0.01 : 0.011;
  std::size_t before = 0;
  for (const double misfit : {0.1, 0.03, 0.01}) {
    const std::vector<std::int32_t> part = solver::rigid_parts(m, misfit);
    const std::size_t parts = std::set<std::int32_t>(part.begin(), part.end()).size();
    CHECK(parts > before);
    CHECK(left_over(m, part) < 1.001 * misfit);
    before = parts;
  }
}

}  // namespace voussoir::testing
