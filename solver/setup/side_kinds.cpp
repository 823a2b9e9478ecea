// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/side_kinds.h"

#include <bit>
#include <cmath>

namespace voussoir::solver {

namespace {

using kernels::kLanes;
using kernels::SideConstants;

constexpr int kBits = 40;  // of what counts as equal: 1e-12 of a metre, or of a value

/// One number of each lane after the other, as they lie in memory.
const double* numbers_of(const SideConstants& c) { return reinterpret_cast<const double*>(&c); }
std::size_t place(const SideConstants& c, const double* member) { return static_cast<std::size_t>(member - numbers_of(c)) / kLanes; }

std::int64_t rounded(double x, double unit) { return std::llround(std::ldexp(x / unit, kBits)); }

/// The leading digits of a positive value, whatever its size (or infinity).
std::int64_t leading(double x) {
  constexpr int kDrop = 52 - kBits;
  return (std::bit_cast<std::int64_t>(x) + (std::int64_t{1} << (kDrop - 1))) >> kDrop;
}

}  // namespace

SideKinds::Key SideKinds::key_of(const SideConstants& c) {
  Key key;
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = rounded(numbers_of(c)[i * kLanes], 1.0);  // lengths [m], parts of unit vectors
  for (const double* member : {c.kn, c.ks, c.area, c.tension, c.cohesion, c.tan_phi, c.compression, c.cap, c.friction}) {
    key[place(c, member)] = leading(*member);
  }
  const double moment = std::ldexp(1.0, std::ilogb(c.sss[0] + c.stt[0]));
  for (const double* member : {c.sss, c.sst, c.stt}) key[place(c, member)] = moment > 0.0 ? rounded(*member, moment) : 0;
  return key;
}

std::int32_t SideKinds::add(const SideConstants& c) {
  const auto [found, is_new] = known_.emplace(key_of(c), static_cast<std::int32_t>(kinds_.size()));
  if (!is_new) return found->second;
  Numbers& numbers = kinds_.emplace_back();
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = numbers_of(c)[i * kLanes];
  return found->second;
}

std::size_t BlockKinds::add(const Lanes& kinds) {
  const auto [found, is_new] = known_.emplace(kinds, constants_.size());
  if (!is_new) return found->second;
  SideConstants& c = constants_.emplace_back();
  auto* number = reinterpret_cast<double*>(&c);
  for (std::size_t l = 0; l < kinds.size(); ++l) {
    const SideKinds::Numbers& from = sides_.numbers(kinds[l]);
    for (std::size_t i = 0; i < from.size(); ++i) number[i * kLanes + l] = from[i];
  }
  return found->second;
}

}  // namespace voussoir::solver
