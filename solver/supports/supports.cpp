// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/supports/supports.h"

#include <algorithm>

#include "cases/loads/support_history.h"
#include "geometry/nth.h"
#include "geometry/turn.h"
#include "kernels/rows.h"

namespace voussoir::solver {
namespace {

bool turns(const Support& s) noexcept { return !s.history->rotation.empty(); }

/// Turns an element. \pre its displacement is stored
void turn_to(World& w, std::int32_t element, Quaternion q) {
  Elements& e = w.elements;
  const auto i = static_cast<std::size_t>(element);
  w.travel.add(element, norm(geometry::small_rotation({e.qw[i], e.qx[i], e.qy[i], e.qz[i]}, q)) * e.radius[i]);
  e.qw[i] = q.w, e.qx[i] = q.x, e.qy[i] = q.y, e.qz[i] = q.z;
  kernels::store_pose(e.pose.data(), element, {{e.ux[i], e.uy[i], e.uz[i]}, rotation_minus_identity(q)});
}

}  // namespace

bool supports_turn(const World& w) noexcept { return std::ranges::any_of(w.supports, turns); }

double place_supports(World& w, double t) {
  Elements& e = w.elements;
  double moved = 0.0;
  for (const Support& s : w.supports) {
    const auto i = static_cast<std::size_t>(s.element);
    const cases::SupportPose pose = pose_at(*s.history, e.body[i].ref, t);
    const Vec3 u = pose.displacement;
    const double jump = norm(u - Vec3{e.ux[i], e.uy[i], e.uz[i]});  // beside what its velocity has made of it
    w.travel.add(s.element, jump);
    e.ux[i] = u.x, e.uy[i] = u.y, e.uz[i] = u.z;
    kernels::store_displacement(e.pose.data(), s.element, u);
    if (turns(s)) turn_to(w, s.element, pose.orientation);
    moved = std::max(moved, w.travel.displacement_over_limit(e, s.element));
  }
  return moved;
}

void move_supports_on(World& w, double now, double next) {
  const double dt = w.dt;
  Elements& e = w.elements;
  for (Support& s : w.supports) {
    const auto i = static_cast<std::size_t>(s.element);
    const cases::SupportPose from = pose_at(*s.history, e.body[i].ref, now), to = pose_at(*s.history, e.body[i].ref, next);
    const Vec3 v = (to.displacement - from.displacement) / dt;
    // `kick` will count the loss with the new velocity, since it does not change that of fixed elements; (27) asks for the mean. `drift`
    // will count that by turning with an angular velocity of zero in place of the new one.
    const double* dash = e.dashpot.data() + i * kernels::kDashpotStride;
    double& loss = e.tally[i / kernels::kBatch * kernels::kTallies + static_cast<std::size_t>(kernels::Tally::loss_dashpots)];
    loss += 0.5 * dt * dot(Vec3{dash[0], dash[1], dash[2]}, v - Vec3{e.vx[i], e.vy[i], e.vz[i]});
    e.vx[i] = v.x, e.vy[i] = v.y, e.vz[i] = v.z;
    if (!turns(s)) continue;
    s.spin = geometry::small_rotation(from.orientation, to.orientation) / dt;
    loss -= 0.5 * dt * dot(Vec3{dash[3], dash[4], dash[5]}, s.spin);
  }
}

namespace {

double way_of(const World& w, const Support& s, Vec3 u, Vec3 sine_of_half) {
  return turns(s) ? norm(u) + 2.0 * norm(sine_of_half) * nth(w.elements.radius, s.element) : norm(u);
}

}  // namespace

double moved(const World& w, const Support& s) noexcept {
  const Elements& e = w.elements;
  const auto i = static_cast<std::size_t>(s.element);
  return way_of(w, s, {e.ux[i], e.uy[i], e.uz[i]}, {e.qx[i], e.qy[i], e.qz[i]});
}

double moved_at(const World& w, const Support& s, double t) noexcept {
  const cases::SupportPose pose = pose_at(*s.history, nth(w.elements.body, s.element).ref, t);
  return way_of(w, s, pose.displacement, {pose.orientation.x, pose.orientation.y, pose.orientation.z});
}

void spin_supports(World& w) noexcept {
  Elements& e = w.elements;
  for (const Support& s : w.supports) {
    if (!turns(s)) continue;
    const auto i = static_cast<std::size_t>(s.element);
    e.wx[i] = s.spin.x, e.wy[i] = s.spin.y, e.wz[i] = s.spin.z;
    e.store_velocity_row(s.element);
  }
}

}  // namespace voussoir::solver
