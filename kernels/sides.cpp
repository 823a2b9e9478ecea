// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/certificate.h"
#include "kernels/damaged_sides.h"
#include "kernels/side_state.h"
#include "kernels/steady_sides.h"
#include "kernels/whole_sides.h"

namespace voussoir::kernels {

namespace {

VOUSSOIR_INLINE LaneMask steady_lanes(const SideState* side_state) noexcept {
  return widened(reinterpret_cast<const unsigned char*>(side_state)) == static_cast<long long>(SideState::steady);
}

/// The lanes of `whole` that are certain to stay whole. Normalises the mean normal.
VOUSSOIR_INLINE unsigned certain_of(const SideConstants& s, int at, unsigned whole, Kinematics& k, FailureOptions o) noexcept {
  const unsigned straight = whole & ~bits(normalise(k.n));
  return straight & bits(certified(s, at, k, o));
}

/// Whole and steady sides of a group whose faces twist as solids do: as in advance_any. Returns the lanes that are certain.
[[gnu::noinline]] unsigned closed_forms(const SideBlock& block, int at, unsigned whole, unsigned steady, const BlockState& state,
                                        Kinematics k, FailureOptions o, SumLanes& sums) noexcept {
  const SideConstants& constants = *block.constants;
  const SolidFaces solid = solid_faces(block, at, k.n, k.es, load_lanes(constants.twist + at));
  k.a = solid.along_s(k.a), k.b = solid.along_t(k.b);
  unsigned certain = 0;
  if (whole != 0) {
    certain = certain_of(constants, at, whole, k, o);
    sums = elastic_sums(constants, at, k);
  }
  if (steady != 0) certain |= steady & bits(stay_steady(block, *state.steady, at, k, steady_lanes(state.side_state + at), sums));
  sums.sf = solid.along_s(sums.sf), sums.tf = solid.along_t(sums.tf);
  return certain;
}

/// Advances the sides `live` of a group, whatever their states. Returns the lanes processed segment by segment. A separate function, so
/// that groups of whole sides only need no stack space for it.
[[gnu::noinline]] unsigned advance_any(const SideBlock& block, int at, unsigned live, const BlockState& state, const Rows& rows,
                                       StepClock clock, FailureOptions o, DamagedSide* result, EventSink& sink) noexcept {
  const SideConstants& constants = *block.constants;
  const StateBits is = state_bits(state.side_state);
  const unsigned whole = live & is.whole >> at, steady = live & is.steady >> at;
  const unsigned open = state.look_closely ? 0U : live & is.open >> at;
  Kinematics k = kinematics(block, at, rows.pose);
  const unsigned still_open = open == 0 ? 0U : open & bits(all_open(constants, at, k));
  if (still_open == live) {
    note_copies(rows, state.first + at, 0);
    return 0;
  }
  SumLanes sums{};
  unsigned certain = 0;
  if (block.axis == kSolidFaces) {
    certain = closed_forms(block, at, whole, steady, state, k, o, sums);
  } else if (whole != 0) {
    certain = certain_of(constants, at, whole, k, o);
    sums = elastic_sums(constants, at, k);
  }
  if (steady != 0 && block.axis != kSolidFaces) {
    certain |= steady & bits(stay_steady(block, *state.steady, at, k, steady_lanes(state.side_state + at), sums));
  }
  const unsigned left = live & ~(certain | still_open);
  if (left != 0) advance_damaged(block, at, left, state, k, rows, clock, o, sums, result + at, sink);
  assemble(block, at, state.first, wrench_of(k, sums), certain | left, rows, false);
  note_copies(rows, state.first + at, certain | left);
  return left;
}

}  // namespace

unsigned advance_sides(const SideBlock& block, const BlockState& state, const Rows& rows, StepClock clock, FailureOptions o,
                       DamagedSide* result, EventSink& sink) noexcept {
  unsigned live = state.live, looked_at = 0;
  if (!state.bound_tried && (live & ~state_bits(state.side_state).whole) == 0 && has_short_form(o)) {
    constexpr std::int32_t kThis[] = {0};
    const auto lanes = static_cast<std::uint8_t>(live);
    unsigned done = 0;
    if (advance_whole({&block, &lanes, kThis, state.first, {}}, rows, done) == 1) return 0;
    live &= ~done;
  }
  for (int at = 0; at < kLanes; at += kWidth) {
    const unsigned here = live >> at & kGroup;
    if (here != 0) looked_at |= advance_any(block, at, here, state, rows, clock, o, result, sink) << at;
  }
  return looked_at;
}

void assemble_zeros(const SideBlock& block, unsigned live, const Rows& rows) noexcept {
  WrenchLanes nothing{};
  asm("" : "+m"(nothing));  // hides the value, or the compiler would drop the conversion of columns to rows
  for (int at = 0; at < kLanes; at += kWidth) {
    const unsigned here = live >> at & kGroup;
    if (here != 0) assemble(block, at, 0, nothing, here, rows, false);
  }
}

void whole_side_energies(const SideBlock& block, const double* pose, double* energy) noexcept {
  const SideConstants& s = *block.constants;
  for (int at = 0; at < kLanes; at += kWidth) {
    Kinematics k = kinematics(block, at, pose);
    k.n = (1.0 / sqrt(dot(k.n, k.n))) * k.n;
    if (block.axis == kSolidFaces) {
      const SolidFaces solid = solid_faces(block, at, k.n, k.es, load_lanes(s.twist + at));
      k.a = solid.along_s(k.a), k.b = solid.along_t(k.b);
    }
    const Lanes ks = load_lanes(s.ks + at), extra = load_lanes(s.kn + at) - ks;
    const VecLanes ga = spring(ks, extra, k.n, k.a), gb = spring(ks, extra, k.n, k.b), gd = spring(ks, extra, k.n, k.d);
    const Lanes twice = load_lanes(s.area + at) * dot(k.d, gd) + load_lanes(s.sss + at) * dot(k.a, ga) +
                        2.0 * load_lanes(s.sst + at) * dot(k.a, gb) + load_lanes(s.stt + at) * dot(k.b, gb);
    store_lanes(energy + at, 0.5 * twice);
  }
}

}  // namespace voussoir::kernels
