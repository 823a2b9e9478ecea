// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/worst_dashpots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

constexpr std::size_t kBlock = 512;        // partners that are looked at together
constexpr double kRoundOff = 1.0 - 1e-14;  // of the comparison of a block

/// Faces that a face may meet.
struct Partners {
  std::vector<double> compliance, mass;
};

/// Classes than which no other is both stiffer and heavier. Only these can be the worst partner: one that is stiffer and heavier gives a
/// quotient at least as large, also after rounding.
Partners worst_partners(const std::vector<FaceClass>& classes, double FaceClass::*compliance) {
  std::vector<FaceClass> all = classes;
  std::ranges::sort(all, [&](const FaceClass& a, const FaceClass& b) {
    return a.*compliance != b.*compliance ? a.*compliance < b.*compliance : a.mass > b.mass;
  });
  Partners worst;
  for (const FaceClass& k : all) {
    if (!worst.mass.empty() && k.mass <= worst.mass.back()) continue;
    worst.compliance.push_back(k.*compliance), worst.mass.push_back(k.mass);
  }
  return worst;
}

/// A face, one sort of dashpot.
struct Own {
  double compliance = 0.0, mass = 0.0;
};

/// Whether a quotient mass / compliance with one of these partners may round to more than `most`. It can only if mass - most x compliance
/// is at least compliance times half the gap to the next larger number: a test without a division. In models of one material all quotients
/// are equal but for rounding, so it rules out nearly all.
bool may_be_more(const Own& own, const double* compliance, const double* mass, std::size_t count, double most) {
  const double half = 0.5 * kRoundOff * (std::nextafter(most, HUGE_VAL) - most);
  int more = 0;
#pragma omp simd reduction(| : more)
  for (std::size_t i = 0; i < count; ++i) {
    const double sum = own.compliance + compliance[i];
    more |= std::fma(-most, sum, own.mass + mass[i]) >= half * sum ? 1 : 0;
  }
  return more != 0;
}

double largest_quotient(const Own& own, const Partners& partners) {
  double most = 0.0;
  for (std::size_t first = 0; first < partners.mass.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, partners.mass.size() - first);
    const double *compliance = &partners.compliance[first], *mass = &partners.mass[first];
    if (!may_be_more(own, compliance, mass, count, most)) continue;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, (own.mass + mass[i]) / (own.compliance + compliance[i]));
  }
  return most;
}

}  // namespace

std::vector<std::array<double, 2>> worst_dashpots(const std::vector<FaceClass>& classes, double h, Team& team) {
  const Partners normal = worst_partners(classes, &FaceClass::compliance_n), shear = worst_partners(classes, &FaceClass::compliance_s);
  std::vector<std::array<double, 2>> worst(classes.size());
  const auto count = static_cast<std::int64_t>(classes.size());
  constexpr std::int64_t kAtATime = 64;
  const auto find = [&](std::int64_t i) {
    const FaceClass& k = nth(classes, i);
    nth(worst, i) = {2.0 * h * std::sqrt(largest_quotient({k.compliance_n, k.mass}, normal)),
                     2.0 * h * std::sqrt(largest_quotient({k.compliance_s, k.mass}, shear))};
  };
  team.share_out(count, kAtATime, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) find(i);
  });
  return worst;
}

}  // namespace voussoir::solver
