// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/nth.h"
#include "kernels/rows.h"
#include "solver/limit/contacts.h"
#include "solver/limit/live_load.h"

/// Equilibrium equations of limit analysis, scaled to numbers near 1: forces are divided by the mean weight of a body, moments by that and
/// the mean lever.
namespace voussoir::solver {

/// A plane that contains all forces, the centre of every body, and the middle of every joint. Points behind one another are one point in
/// the programme, and motion out of the plane is excluded; the resulting forces and motion are valid for the model in space (limit_proof.h
/// checks both).
struct LimitPlane {
  Vec3 along, up, across;  // unit vectors; across: normal of the plane
  double middle = 0.0;     // m, along `across`
};

/// The plane of a model, if it has one; none where there are ties.
std::optional<LimitPlane> plane_of(const LimitContacts& contacts, const LimitForces& forces, Vec3 direction);

/// A contact point of the programme. In a plane it represents two points of the model, with these shares of its force.
struct BalancePoint {
  std::int32_t a = 0, b = -1;  // bodies; −1: fixed
  Vec3 at, normal, first, second;
  double friction = 0.0;
  std::array<std::size_t, 2> of{};  // indices into LimitContacts::points
  std::array<double, 2> share{1.0, 0.0};
};

/// One way in which a tie bears: its tension, or its compression.
struct BalanceTie {
  std::size_t of = 0;      // index into LimitContacts::ties
  double sign = 1.0;       // −1: compression
  double most = 0.0;       // mean weights; infinite: no limit
  std::vector<TiePull> pulls;  // per mean weight of its force
};

/// Forces on the model.
struct ModelForces {
  std::vector<Vec3> at_points;  // N, on body a, at each of LimitContacts::points
  std::vector<double> of_ties;  // N, tension, of each of LimitContacts::ties
};

class Balance {
 public:
  Balance(const LimitContacts& contacts, const LimitForces& forces, const std::optional<LimitPlane>& plane);

  [[nodiscard]] std::size_t rows() const noexcept { return dead_.size(); }
  [[nodiscard]] const std::vector<double>& dead() const noexcept { return dead_; }  // by equation
  [[nodiscard]] const std::vector<double>& live() const noexcept { return live_; }  // scaled to the sum of all weights
  /// Factor from the multiplier of live() to that of LimitForces::live.
  [[nodiscard]] double live_scale() const noexcept { return live_scale_; }
  [[nodiscard]] const std::vector<BalancePoint>& points() const noexcept { return points_; }
  [[nodiscard]] const std::vector<BalanceTie>& ties() const noexcept { return ties_; }
  [[nodiscard]] double unit() const noexcept { return unit_; }  // N

  /// Calls take(row, value) for each equation that contains a force on body a of a point, and the opposite force on b.
  template <class Take>
  void at_point(const BalancePoint& p, Vec3 force_on_a, const Take& take) const {
    on_body(p.a, force_on_a, cross(p.at - centre(p.a), force_on_a) / length_, take);
    if (p.b >= 0) on_body(p.b, -force_on_a, -cross(p.at - centre(p.b), force_on_a) / length_, take);
  }
  /// Calls take(row, value) for each equation that contains the force of a tie.
  template <class Take>
  void at_tie(const BalanceTie& t, const Take& take) const {
    for (const TiePull& p : t.pulls) on_body(p.body, p.force, p.moment / length_, take);
  }
  /// Velocities of bodies, proportional to the prices of the equations; the fastest contact point or centre has the speed 1.
  [[nodiscard]] std::vector<kernels::Twist> motion(const std::vector<double>& prices) const;
  /// Velocity of b relative to a at a point.
  [[nodiscard]] Vec3 against(const BalancePoint& p, const std::vector<kernels::Twist>& motion) const;
  /// Speed at which a tie gives way: gets longer, or shorter in compression.
  [[nodiscard]] double giving(const BalanceTie& t, const std::vector<kernels::Twist>& motion) const {
    return t.sign * stretching(contacts_.ties[t.of], contacts_, motion);
  }
  /// Forces on the model from those at points() and of ties(), in mean weights.
  [[nodiscard]] ModelForces forces(const std::vector<Vec3>& at_points, const std::vector<double>& of_ties) const;

 private:
  static constexpr std::size_t kMostRows = 6;
  static constexpr double kRoundOff = 1e-13;  // magnitude below which a coefficient is taken as zero

  template <class Take>
  void on_body(std::int32_t body, Vec3 force, Vec3 moment, const Take& take) const {
    const std::size_t first = static_cast<std::size_t>(body) * rows_of_body_;
    for (std::size_t k = 0; k < rows_of_body_; ++k) {
      const double value = dot(axes_[k], k < forces_of_body_ ? force : moment);
      if (std::abs(value) > kRoundOff) take(first + k, value);
    }
  }
  [[nodiscard]] Vec3 centre(std::int32_t body) const { return nth(contacts_.bodies, body).centre; }
  [[nodiscard]] Vec3 speed(std::int32_t body, Vec3 at, const std::vector<kernels::Twist>& motion) const;
  void put(const BodyForces& forces, double scale, std::vector<double>& rows) const;
  void take_points_of_plane(const LimitPlane& plane);
  void take_ties();

  const LimitContacts& contacts_;
  std::array<Vec3, kMostRows> axes_{};  // axes of the equations of a body: forces, then moments
  std::size_t rows_of_body_ = 6, forces_of_body_ = 3;
  double unit_ = 1.0, length_ = 1.0, live_scale_ = 1.0;  // N, m, -
  std::vector<double> dead_, live_;
  std::vector<BalancePoint> points_;
  std::vector<BalanceTie> ties_;
};

}  // namespace voussoir::solver
