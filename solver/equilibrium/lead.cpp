// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/equilibrium/lead.h"

#include <algorithm>
#include <cmath>

namespace voussoir::solver {

namespace {

/// Rotation vector from the orientation a to b, for small ones.
Vec3 turn_from(const double* a, const double* b) {
  const double w = b[0] * a[0] + b[1] * a[1] + b[2] * a[2] + b[3] * a[3];
  const Vec3 av{a[1], a[2], a[3]}, bv{b[1], b[2], b[3]};
  const Vec3 v = a[0] * bv - b[0] * av - cross(bv, av);
  return (w < 0.0 ? -2.0 : 2.0) * v;
}

}  // namespace

Lead::Lead(const World& w)
    : pose_(kPose * static_cast<std::size_t>(w.elements.count), 0.0), rate_(kRate * static_cast<std::size_t>(w.elements.count), 0.0) {}

void Lead::accept(const World& w, double way) {
  const Elements& e = w.elements;
  double old_square = 0.0, product = 0.0, square = 0.0;  // of the motion before and this one, by fictitious masses
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const double pose[kPose] = {e.ux[i], e.uy[i], e.uz[i], e.qw[i], e.qx[i], e.qy[i], e.qz[i]};
    double* last = pose_.data() + i * kPose;
    if (way > 0.0 && e.inert.inv_mass[i] > 0.0) {
      const double per = 1.0 / way, m = e.inert.mass[i], j = e.inert.inv_inertia[i] > 0.0 ? 1.0 / e.inert.inv_inertia[i] : 0.0;
      const Vec3 move = per * Vec3{pose[0] - last[0], pose[1] - last[1], pose[2] - last[2]}, turn = per * turn_from(last + 3, pose + 3);
      const Vec3 old_move = displacement(i), old_turn = rotation(i);
      square += m * dot(move, move) + j * dot(turn, turn);
      product += m * dot(move, old_move) + j * dot(turn, old_turn);
      old_square += m * dot(old_move, old_move) + j * dot(old_turn, old_turn);
      const double rate[kRate] = {move.x, move.y, move.z, turn.x, turn.y, turn.z};
      std::copy_n(rate, kRate, rate_.data() + i * kRate);
    }
    std::copy_n(pose, kPose, last);
  }
  if (!(way > 0.0) || !(square > 0.0)) {
    state_ = {};
    return;
  }
  // A jump is no forecast: of a motion that is new only so much is predicted as the one before had of it.
  const double share = state_.known > 0.0 ? std::clamp(product / square, 0.0, 1.0) : 1.0;
  if (state_.known > 0.0) {
    const double led = state_.share;
    state_.open = std::min(1.0, std::sqrt(std::max(0.0, square - 2.0 * led * product + led * led * old_square) / square));
  }
  state_.share = share, state_.known = 1.0;
}

}  // namespace voussoir::solver
