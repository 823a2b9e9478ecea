// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/laws/closing.h"
#include "kernels/laws/crushing.h"
#include "kernels/laws/laws_of_side.h"
#include "kernels/laws/segment_law.h"
#include "kernels/laws/softening.h"
#include "kernels/segments.h"

/// What kernels and solver ask of the optional laws of a side (SideLaws); they ask no law itself, so a new law answers the questions below
/// that concern it (CONTRIBUTING.md, "A joint law").
///
/// What the closed forms rely on: a side of which no segment has reached a limit of its Strength (law.h) follows segment_law.h. So a law
/// may change a bond from its first limit on, and a contact as soon as there is one.
namespace voussoir::kernels {

// ---- bonds

/// Whether some segment of [first, last) that is still bonded has springs that are not those of segment_law.h any more.
VOUSSOIR_INLINE bool has_changed_bonds(const SideLaws& a, int first, int last) noexcept {
  return a.softens() && is_worn(a.soft, first, last);
}

/// Calls `use` with the law of its segments: (state, segment, displacement, rate) -> SegmentStep. Each law is compiled apart, so that one
/// leaves the last digits of another as they are.
template <typename Use>
VOUSSOIR_INLINE SegmentTotals with_segment_law(const SideLaws& a, Stiffness k, Strength s, double step, FailureOptions o,
                                               const Use& use) noexcept {
  if (a.crushing != nullptr) {
    return use([&](SegmentState& q, int i, const Local& u, const Local& rate) {
      const auto law = [&](const Strength& left) {
        return a.softens() ? advance_soft_segment(q, a.soft.wear[i], u, rate, step, k, left, a.soft.law, o)
                           : advance_segment(q, u, rate, step, k, left, o);
      };
      return advance_under_falling_cap(law, q, a.crushed[i], s, *a.crushing);
    });
  }
  if (a.softens()) {
    return use([&](SegmentState& q, int i, const Local& u, const Local& rate) {
      return advance_soft_segment(q, a.soft.wear[i], u, rate, step, k, s, a.soft.law, o);
    });
  }
  return use([&](SegmentState& q, int, const Local& u, const Local& rate) { return advance_segment(q, u, rate, step, k, s, o); });
}

/// Normal stiffness of segment i while it is bonded [Pa/m]. \param n  m, its elongation
inline double bond_stiffness(const SideLaws& a, int i, double n, double kn) noexcept {
  return a.softens() ? stiffness_left(n, a.soft.wear[i], kn, a.soft.law) : kn;
}

/// J/m2, in the springs of segment i, which is bonded. \param x  m, their elongation
inline double stored_by_bond(const SideLaws& a, int i, Local x, Stiffness k) noexcept {
  return a.softens() ? stored_when_worn(x, a.soft.wear[i], k, a.soft.law) : detail::stored_energy(x, k);
}

// ---- contacts

/// Lets its contacts give way: moves their closures. \param factor  of Eq. 11, on the segment areas
VOUSSOIR_INLINE GaveWay give_way(const SideLaws& a, const NormalFields& f, double kn, double factor, PointsView p, SegmentsView q,
                                 double step) noexcept {
  if (a.closing.on()) return close_segments(f, kn, factor, p, q, step, a.closing, a.crushing, a.crushed);
  if (a.crushing != nullptr) return {.fracture = crush_segments(f, kn, factor, p, q, step, *a.crushing, a.crushed)};
  return {};
}

/// J/m2, in the springs of a contact. \param x  m, their elongation
inline double stored_by_contact(const SideLaws& a, Local x, Stiffness k) noexcept {
  if (a.closing.on()) return stored_at(-k.kn * x.n, a.closing) + 0.5 * k.ks * (x.s1 * x.s1 + x.s2 * x.s2);
  return detail::stored_energy(x, k);
}

/// m, that segment i has been crushed so far.
inline double crushed_by(const SideLaws& a, int i) noexcept { return a.crushed == nullptr ? 0.0 : a.crushed[i]; }

/// Normal stiffness of the free patches that it leaves [Pa/m]. Those of a joint that stiffens as it closes have their blocks' alone, and so
/// give back no more than the joint held.
inline double patch_stiffness(const SideLaws& a, double kn) noexcept { return a.closing.on() ? a.closing.blocks : kn; }

/// What a point of such a patch takes from its contact.
struct LeftToPatch {
  double n = 0.0;     // m, elongation of its spring, under the pressure that the contact had
  double lost = 0.0;  // J/m2
};
/// \param n  m, elongation of the contact's spring, below 0
inline LeftToPatch left_to_patch(const SideLaws& a, double n, double kn) noexcept {
  if (!a.closing.on()) return {.n = n};
  const double pressure = kn * -n;
  return {-pressure / a.closing.blocks, stored_at(pressure, a.closing) - 0.5 * pressure * pressure / a.closing.blocks};
}

}  // namespace voussoir::kernels
