// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "kernels/certificate.h"
#include "kernels/damaged_sides.h"
#include "kernels/steady_sides.h"

namespace voussoir::kernels {

namespace {

constexpr unsigned kGroup = (1U << kWidth) - 1U;

/// Which sides of a block are what, one bit each.
struct QuickBits {
  unsigned whole, open, steady;
};
/// Bit i of the result is the lowest of byte i: the product brings it to place 56 + i.
VOUSSOIR_INLINE unsigned lowest_bits(std::uint64_t bytes) noexcept {
  return static_cast<unsigned>((bytes & 0x0101010101010101U) * 0x0102040810204080U >> 56);
}
VOUSSOIR_INLINE QuickBits quick_bits(const Quick* quick) noexcept {
  static_assert(static_cast<int>(Quick::whole) == 1 && static_cast<int>(Quick::open) == 2 && static_cast<int>(Quick::steady) == 3);
  std::uint64_t bytes;
  static_assert(sizeof bytes == kLanes * sizeof(Quick));
  std::memcpy(&bytes, quick, sizeof bytes);
  const unsigned low = lowest_bits(bytes), high = lowest_bits(bytes >> 1);
  return {low & ~high, high & ~low, low & high};
}
VOUSSOIR_INLINE LaneMask steady_lanes(const Quick* quick) noexcept {
  return widened(reinterpret_cast<const unsigned char*>(quick)) == static_cast<long long>(Quick::steady);
}

/// Notes which lanes left something in the buffer for pairs.
VOUSSOIR_INLINE void mark(std::uint8_t* on, unsigned wrench, unsigned dashpot) noexcept {
  if (on == nullptr) return;
  for (int l = 0; l < kWidth; ++l) {
    on[l] = static_cast<std::uint8_t>((wrench >> l & 1U ? kOnWrench : 0) | (dashpot >> l & 1U ? kOnDashpot : 0));
  }
}

/// Of the lanes `whole`, those that are certain to stay so. Makes the normal one of length 1. Nearly always the bound over the whole side
/// does, and no corner is looked at.
VOUSSOIR_INLINE unsigned certain_of(const SideConstants& s, int at, unsigned whole, Kinematics& k, FailureOptions o) noexcept {
  const unsigned straight = whole & ~bits(normalise(k.n));
  const unsigned inside = straight & bits(well_inside(s, at, k));
  if (inside == straight && o.in_tension != ShearInTension::coulomb) return inside;
  return straight & bits(certified(s, at, k, o));
}

/// The sides `live`, all of them whole, if each is certain to stay so. On its own, so that what damaged sides take is in none of its
/// registers.
[[gnu::noinline]] bool advance_whole(const SideBlock& block, int at, unsigned live, std::int64_t first, const Rows& rows,
                                     FailureOptions o) noexcept {
  Kinematics k = kinematics(block, at, rows.pose);
  if (certain_of(*block.constants, at, live, k, o) != live) return false;
  scatter(block, at, first, wrench_of(k, elastic_sums(*block.constants, at, k)), live, rows, false);
  return true;
}

/// Where a side of the group that begins at `at` notes that it left something in the buffer for pairs, if there is one.
VOUSSOIR_INLINE std::uint8_t* marks(const Rows& rows, const BlockState& state, int at) noexcept {
  return rows.pairs.on == nullptr ? nullptr : rows.pairs.on + state.first + at;
}

/// The sides `live` of a group, whatever they are. Returns those whose segments were looked at. On its own, so that groups in which all are
/// whole need no room for what it takes.
[[gnu::noinline]] unsigned advance_any(const SideBlock& block, int at, unsigned live, const BlockState& state, const Rows& rows,
                                       StepClock clock, FailureOptions o, DamagedSide* result, EventSink& sink) noexcept {
  const SideConstants& constants = *block.constants;
  const QuickBits is = quick_bits(state.quick);
  const unsigned whole = live & is.whole >> at, steady = live & is.steady >> at;
  const unsigned open = state.look_closely ? 0U : live & is.open >> at;
  Kinematics k = kinematics(block, at, rows.pose);
  const unsigned still_open = open == 0 ? 0U : open & bits(all_open(constants, at, k));
  if (still_open == live) {
    mark(marks(rows, state, at), 0, 0);
    return 0;
  }
  SumLanes sums{};
  unsigned certain = 0;
  if (whole != 0) {
    certain = certain_of(constants, at, whole, k, o);
    sums = elastic_sums(constants, at, k);
  }
  if (steady != 0) certain |= steady & bits(stay_steady(block, *state.steady, at, k, steady_lanes(state.quick + at), sums));
  const unsigned left = live & ~(certain | still_open);
  unsigned touching = 0;
  if (left != 0) touching = advance_damaged(block, at, left, state.first, state.parts + at, k, rows, clock, o, sums, result + at, sink);
  scatter(block, at, state.first, wrench_of(k, sums), certain | left, rows, false);
  mark(marks(rows, state, at), certain | left, touching);
  return left;
}

}  // namespace

unsigned advance_sides(const SideBlock& block, const BlockState& state, const Rows& rows, StepClock clock, FailureOptions o,
                       DamagedSide* result, EventSink& sink) noexcept {
  const QuickBits is = quick_bits(state.quick);
  unsigned looked_at = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    const unsigned live = state.live >> at & kGroup;
    if (live == 0) continue;
    if ((live & ~(is.whole >> at)) == 0 && advance_whole(block, at, live, state.first, rows, o)) {
      mark(marks(rows, state, at), live, 0);
    } else {
      looked_at |= advance_any(block, at, live, state, rows, clock, o, result, sink) << at;
    }
  }
  return looked_at;
}

void gather_sides(std::span<const std::int64_t> codes, const PairBuffer& pairs, double* row) noexcept {
  const auto add = [](double* to, const double* from) {
    add_quad(to, load_quad(from));
    add_pair(to + 4, load_pair(from + 4));
  };
  for (const std::int64_t code : codes) {
    const std::uint8_t on = pairs.on[code / 2];
    if (on == 0) continue;
    const std::int64_t from = code * (kPairStride / 2);
    if (on & kOnWrench) add(row, pairs.wrench + from);
    if (on & kOnDashpot) add(row + kDashpotColumn, pairs.dashpot + from);
  }
}

void whole_side_energies(const SideBlock& block, const double* pose, double* energy) noexcept {
  const SideConstants& s = *block.constants;
  for (int at = 0; at < kLanes; at += kWidth) {
    Kinematics k = kinematics(block, at, pose);
    k.n = (1.0 / sqrt(dot(k.n, k.n))) * k.n;
    const Lanes ks = load_lanes(s.ks + at), extra = load_lanes(s.kn + at) - ks;
    const VecLanes ga = spring(ks, extra, k.n, k.a), gb = spring(ks, extra, k.n, k.b), gd = spring(ks, extra, k.n, k.d);
    const Lanes twice = load_lanes(s.area + at) * dot(k.d, gd) + load_lanes(s.sss + at) * dot(k.a, ga) +
                        2.0 * load_lanes(s.sst + at) * dot(k.a, gb) + load_lanes(s.stt + at) * dot(k.b, gb);
    store_lanes(energy + at, 0.5 * twice);
  }
}

}  // namespace voussoir::kernels
