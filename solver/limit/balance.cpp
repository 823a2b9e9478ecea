// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/balance.h"

#include <algorithm>
#include <utility>

#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

double sum_of(const BodyForces& f, double length) {
  double sum = 0.0;
  for (std::size_t b = 0; b < f.force.size(); ++b) sum += norm(f.force[b]) + norm(f.moment[b]) / length;
  return sum;
}

}  // namespace

Balance::Balance(const LimitContacts& contacts, const LimitForces& forces, const std::optional<LimitPlane>& plane) : contacts_(contacts) {
  axes_ = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  if (plane) {
    rows_of_body_ = 3, forces_of_body_ = 2;
    axes_ = {plane->along, plane->up, plane->across};
  }
  unit_ = forces.weight / static_cast<double>(contacts.bodies.size());
  length_ = forces.length;
  live_scale_ = forces.weight / sum_of(forces.live, length_);
  put(forces.dead, 1.0, dead_);
  put(forces.live, live_scale_, live_);
  take_ties();
  if (plane) {
    take_points_of_plane(*plane);
    return;
  }
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    const LimitPoint& p = contacts.points[i];
    points_.push_back({p.a, p.b, p.at, p.normal, p.first, p.second, p.friction, {i, i}, {1.0, 0.0}});
  }
}

void Balance::put(const BodyForces& forces, double scale, std::vector<double>& rows) const {
  rows.assign(rows_of_body_ * contacts_.bodies.size(), 0.0);
  for (std::size_t b = 0; b < contacts_.bodies.size(); ++b)
    on_body(static_cast<std::int32_t>(b), (scale / unit_) * forces.force[b], (scale / (unit_ * length_)) * forces.moment[b],
            [&](std::size_t row, double value) { rows[row] = value; });
}

void Balance::take_ties() {
  for (std::size_t k = 0; k < contacts_.ties.size(); ++k) {
    const LimitTie& tie = contacts_.ties[k];
    for (const double sign : {1.0, -1.0}) {
      const double most = sign > 0.0 ? tie.most : -tie.least;
      if (!(most > 0.0)) continue;
      std::vector<TiePull> pulls = pulls_of(tie, contacts_);
      for (TiePull& p : pulls) p.force = sign * p.force, p.moment = sign * p.moment;
      ties_.push_back({k, sign, most / unit_, std::move(pulls)});
    }
  }
}

Vec3 Balance::speed(std::int32_t body, Vec3 at, const std::vector<kernels::Twist>& motion) const {
  if (body < 0) return {};
  const kernels::Twist& m = nth(motion, body);
  return m.v + cross(m.w, at - centre(body));
}

Vec3 Balance::against(const BalancePoint& p, const std::vector<kernels::Twist>& motion) const {
  return speed(p.b, p.at, motion) - speed(p.a, p.at, motion);
}

std::vector<kernels::Twist> Balance::motion(const std::vector<double>& prices) const {
  std::vector<kernels::Twist> out(contacts_.bodies.size());
  double fastest = 0.0;
  for (std::size_t b = 0; b < out.size(); ++b) {
    for (std::size_t k = 0; k < rows_of_body_; ++k) {
      const double price = prices[b * rows_of_body_ + k];
      if (k < forces_of_body_) out[b].v += price * axes_[k];
      if (k >= forces_of_body_) out[b].w += (price / length_) * axes_[k];
    }
    fastest = std::max(fastest, norm(out[b].v));
  }
  for (const BalancePoint& p : points_) fastest = std::max({fastest, norm(speed(p.a, p.at, out)), norm(speed(p.b, p.at, out))});
  if (fastest > 0.0)
    for (kernels::Twist& m : out) m.v = m.v / fastest, m.w = m.w / fastest;
  return out;
}

ModelForces Balance::forces(const std::vector<Vec3>& at_points, const std::vector<double>& of_ties) const {
  ModelForces all{std::vector<Vec3>(contacts_.points.size()), std::vector<double>(contacts_.ties.size(), 0.0)};
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) all.at_points[points_[i].of[k]] += (unit_ * points_[i].share[k]) * at_points[i];
  for (std::size_t k = 0; k < ties_.size(); ++k) all.of_ties[ties_[k].of] += ties_[k].sign * unit_ * of_ties[k];
  return all;
}

}  // namespace voussoir::solver
