// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joints/side_outcome.h"

#include <cmath>

#include "kernels/side_laws.h"

namespace voussoir::solver {

namespace {

// Beyond these the mean frame of a joint no longer describes two faces that face each other; its segments go on as free patches. A joint
// that bends but still holds (a lintel's wood yields by a tenth of a radian) stays one: its bonds are cut by nothing but their limits.
constexpr double kTilt = 0.15;       // rad, relative rotation
constexpr double kSlideShare = 0.5;  // of a segment

bool comes_apart(const World& w, std::size_t id, const kernels::DamagedSide& r) {
  const double slide = kSlideShare * w.sides.size[id];
  if (r.slide2 > slide * slide) return true;
  return r.held == 0 && (r.tilt2 > kTilt * kTilt || r.gap > w.travel.skin());
}

/// A side that has just been looked at, and in which nothing happens, may need no look for a while.
bool found_steady(World& w, std::size_t id, const kernels::DamagedSide& r) {
  if (w.options.reference_kernels || r.held == 0 || r.touching || r.events != 0) return false;
  if (kernels::has_changed_bonds(w.sides.laws_of(id), 0, w.sides.parts[id].points.n)) return false;  // springs of one stiffness alone
  const std::size_t block = id / kernels::kLanes;
  const double left = kSlideShare * w.sides.size[id] - std::sqrt(r.slide2);
  return kernels::make_steady(w.sides.blocks[block], static_cast<int>(id % kernels::kLanes), w.sides.parts[id], r.u, left, w.failure,
                              w.sides.steady[block]);
}

/// Slip has opened the joint for good (THEORY.md (13e)), so that it touches before its faces meet: then an opening is no proof of no force.
bool stands_out(const World& w, std::size_t id) {
  if (!w.sides.laws_of(id).opens_by_slip()) return false;
  const kernels::SideParts& parts = w.sides.parts[id];
  for (int i = 0; i < parts.points.n; ++i) {
    if (parts.segments.closure(i) > 0.0) return true;
  }
  return false;
}

/// Most looks find nothing lost: then the sum, which lies elsewhere, is not even fetched.
void add_loss(double& sum, double loss) {
  if (loss != 0.0) sum += loss;
}

}  // namespace

bool record_side(World& w, std::size_t id, const kernels::DamagedSide& r, SideLook look) {
  Sides& s = w.sides;
  // The plain twin looks at every side in every step; what it finds must not come sooner.
  if (s.side_state[id] == kernels::SideState::open && !look.closely && r.gap > 0.0) return false;
  s.held[id] = r.held;
  add_loss(s.friction[id], r.friction);
  add_loss(s.impact[id], r.impact);
  add_loss(s.fracture[id], r.fracture);
  // A whole side that failed its certificate, but in which nothing happened, is still whole.
  if (s.side_state[id] == kernels::SideState::whole && r.events == 0) return false;
  s.side_state[id] = r.held == 0 && !r.touching && !stands_out(w, id) ? kernels::SideState::open : kernels::SideState::segments;
  if (comes_apart(w, id, r)) return true;
  if (look.for_steady && found_steady(w, id, r)) s.side_state[id] = kernels::SideState::steady;
  return false;
}

}  // namespace voussoir::solver
