// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "cases/loads/gravity.h"
#include "cases/loads/loads.h"
#include "solver/analysis/linear_programme.h"
#include "solver/world/errors.h"

namespace voussoir::solver {
namespace {

constexpr int kMostIterations = LimitResult::kMostProgrammes - 1, kLeastIterations = LimitResult::kLeastProgrammes - 1;
constexpr double kTurn = 0.7;       // of the slope of the limit, from one iteration to the next
constexpr double kLevel = 0.01;     // of the slope of friction: what is left of it
constexpr double kNoChange = 1e-7;  // of the multiplier: nothing more will come
constexpr std::size_t kRowsOfBody = 6;
constexpr double kRoundOff = 1e-12;  // in mean weights: a coefficient that would be zero but for it

/// A contact point in the programme. Forces in mean weights.
struct Point {
  Vec3 first, second;                     // unit tangents
  double cohesion = 0.0, slope = 0.0;     // the limit of shear is cohesion + slope × compression
  double compression = 0.0, found = 0.0;  // mean of the iterations, and of the last
  double shear = 0.0;                     // of the last
};

/// Directions of the facets' corners at a point, as long as the cone there has them wide.
std::vector<std::pair<double, double>> facets(const LimitOptions& o, bool plane) {
  if (plane) return {{1.0, 0.0}, {-1.0, 0.0}};
  std::vector<std::pair<double, double>> all;
  const double half = std::numbers::pi / o.facets, reach = o.outer ? 1.0 / std::cos(half) : 1.0;
  for (int k = 0; k < o.facets; ++k) {
    const double angle = 2.0 * half * k + (o.outer ? half : 0.0);
    all.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
  }
  return all;
}

/// Balance of all bodies under dead forces, a multiple of the live ones and forces at contact points.
class Problem {
 public:
  Problem(const cases::Case& c, const cases::Model& model, const LimitOptions& o, const LimitContacts& contacts)
      : contacts_(contacts),
        live_(o.live),
        tick_(o.tick),
        points_(contacts.points.size()),
        corners_(facets(o, contacts.plane.has_value())),
        inside_(1 + points_.size() * (corners_.size() + 2) >= o.inside_from) {
    const Vec3 across = cross({0, 0, 1}, live_);
    if (contacts.plane) {
      axes_ = {live_, {0, 0, 1}, {}, {}, across, {}};
    } else {
      axes_ = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    }
    number_rows();
    set_forces(c, model);
    for (std::size_t i = 0; i < points_.size(); ++i) set_tangents(contacts.points[i], points_[i]);
  }

  [[nodiscard]] double weight() const { return unit_ * static_cast<double>(contacts_.bodies.size()); }
  void associated(LimitState& out) {
    for (std::size_t i = 0; i < points_.size(); ++i) points_[i].cohesion = 0.0, points_[i].slope = contacts_.points[i].friction;
    // Where there is no solution the interior-point method does not converge, which is soon seen.
    if (!inside_ && !stands()) throw falls();
    if (!solve(out)) {
      if (inside_ && !stands()) throw falls();
      throw no_forces();
    }
    for (Point& p : points_) p.compression = p.found;
  }
  /// Compressions are averaged over iterations: taken as found they swing to and fro between mechanisms.
  /// \pre associated() has been called
  void coulomb(double associated, LimitState& out) {
    double last = associated;
    for (int i = 0, still = 0; i < kMostIterations && (i < kLeastIterations || still < 3); ++i) {
      for (std::size_t k = 0; k < points_.size(); ++k) {
        Point& p = points_[k];
        const double friction = contacts_.points[k].friction;
        p.slope = std::max(kTurn * p.slope, kLevel * friction);
        p.cohesion = (friction - p.slope) * p.compression;
      }
      if (!solve(out)) throw no_forces();
      for (Point& p : points_) p.compression = 0.5 * (p.compression + p.found);
      out.last_change = std::abs(out.multiplier - last) / std::max(out.multiplier, 1e-12);
      last = out.multiplier;
      still = out.last_change < kNoChange ? still + 1 : 0;
    }
  }

 private:
  void number_rows() {
    double mass = 0.0;
    std::size_t rows = 0;
    for (std::size_t k = 0; k < kRowsOfBody; ++k) row_[k] = axes_[k] == Vec3{} ? -1 : static_cast<int>(rows++);
    rows_of_body_ = rows;
    for (const RigidBody& b : contacts_.bodies) mass += b.mass;
    mean_mass_ = mass / static_cast<double>(contacts_.bodies.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) sum += norm(contacts_.points[i].at - centre(contacts_.points[i].a));
    if (!points_.empty()) length_ = sum / static_cast<double>(points_.size());
  }
  void set_forces(const cases::Case& c, const cases::Model& model) {
    const Vec3 g = cases::gravity_on_base(c);
    unit_ = mean_mass_ * norm(g);
    dead_.assign(rows_of_body_ * contacts_.bodies.size(), 0.0);
    live_forces_.assign(dead_.size(), 0.0);
    for (std::size_t b = 0; b < contacts_.bodies.size(); ++b) {
      const RigidBody& body = contacts_.bodies[b];
      act(static_cast<std::int32_t>(b), body.centre, (body.mass / unit_) * g, dead_);
      act(static_cast<std::int32_t>(b), body.centre, (body.mass * norm(g) / unit_) * live_, live_forces_);
    }
    for (std::size_t i = 0; i < c.loads.size(); ++i) {
      const cases::Load& load = c.loads[i];
      if (load.history) {
        throw cases::InputError("load[" + std::to_string(i) + "].history", "does not go with limit analysis, which knows no time; allowed: force");
      }
      for (const std::int32_t e : cases::loaded_elements(model, load, i)) set_load(load, model, static_cast<std::size_t>(e));
    }
  }
  void set_load(const cases::Load& load, const cases::Model& model, std::size_t element) {
    const std::int32_t body = contacts_.body_of[element];
    act(body, load.at.value_or(model.assembly.elements[element].mass.centroid), load.force / unit_, dead_);
    for_each_row(body, {}, load.moment / (unit_ * length_), [&](std::size_t row, double value) { dead_[row] += value; });
  }
  void set_tangents(const LimitPoint& at, Point& p) const {
    const auto along = [&](Vec3 v) { return v - dot(v, at.normal) * at.normal; };
    const Vec3 of_live = along(live_);
    p.first = normalised(norm(of_live) > 1e-3 ? of_live : along({0, 0, 1}));
    p.second = cross(at.normal, p.first);
  }
  [[nodiscard]] Vec3 centre(std::int32_t body) const { return contacts_.bodies[static_cast<std::size_t>(body)].centre; }

  /// What a force and a moment (over the mean length) about the centre add to the equations of a body.
  template <class Take>
  void for_each_row(std::int32_t body, Vec3 force, Vec3 moment, const Take& take) const {
    const std::size_t first = static_cast<std::size_t>(body) * rows_of_body_;
    for (std::size_t k = 0; k < kRowsOfBody; ++k) {
      if (row_[k] < 0) continue;
      const double value = dot(axes_[k], k < 3 ? force : moment);
      if (std::abs(value) > kRoundOff) take(first + static_cast<std::size_t>(row_[k]), value);
    }
  }
  void act(std::int32_t body, Vec3 at, Vec3 force, std::vector<double>& on) const {
    for_each_row(body, force, cross(at - centre(body), force) / length_, [&](std::size_t row, double value) { on[row] += value; });
  }
  /// A force at a contact point on body a, and its opposite on b.
  template <class Take>
  void at_point(const LimitPoint& p, Vec3 force_on_a, const Take& take) const {
    for_each_row(p.a, force_on_a, cross(p.at - centre(p.a), force_on_a) / length_, take);
    if (p.b >= 0) for_each_row(p.b, -force_on_a, -cross(p.at - centre(p.b), force_on_a) / length_, take);
  }

  /// Compression, shears towards the corners of the facets, and what is left up to the limit.
  void add_columns(LinearProgramme& lp, std::size_t i) const {
    const LimitPoint& at = contacts_.points[i];
    const Point& p = points_[i];
    const std::size_t limit = dead_.size() + i;
    const auto take = [&](std::size_t row, double value) { lp.add(row, value); };
    at_point(at, -at.normal, take);
    lp.add(limit, -p.slope);
    lp.end_column();
    for (const auto& [s, t] : corners_) {
      at_point(at, s * p.first + t * p.second, take);
      lp.add(limit, 1.0);
      lp.end_column();
    }
    lp.add(limit, 1.0);
    lp.end_column();
    lp.right(limit) = p.cohesion;
  }

  /// Whether contacts can bear the dead forces: those are a cone, so they bear all of them or none.
  [[nodiscard]] bool stands() const {
    LinearProgramme lp(dead_.size() + points_.size());
    for (std::size_t row = 0; row < dead_.size(); ++row)
      if (dead_[row] != 0.0) lp.add(row, dead_[row]);
    lp.end_column();
    for (std::size_t i = 0; i < points_.size(); ++i) add_columns(lp, i);
    const LpOutcome found = (inside_ ? lp.solve_inside(1.0) : lp.solve(false, 1.0)).outcome;
    if (found == LpOutcome::none) throw no_forces();  // no forces at all are a solution
    return found == LpOutcome::at_bound;
  }
  static cases::InputError falls() {
    return {"", "does not stand under its dead loads alone, as dry blocks with the friction of their contacts"};
  }
  static NumericalError no_forces() {
    return NumericalError(
        "limit analysis found no forces to the accuracy needed, which says nothing of the structure; try another number of --facets or a "
        "larger segments.size, and look for blocks that are very small, or loads that are very large, beside the others");
  }
  /// Whether a solution was found.
  [[nodiscard]] bool solve(LimitState& out) {
    LinearProgramme lp(dead_.size() + points_.size());
    for (std::size_t row = 0; row < dead_.size(); ++row) {
      if (live_forces_[row] != 0.0) lp.add(row, live_forces_[row]);
      lp.right(row) = -dead_[row];
    }
    lp.end_column();
    for (std::size_t i = 0; i < points_.size(); ++i) add_columns(lp, i);
    const LpSolution found = inside_ ? lp.solve_inside() : lp.solve(true);
    if (found.outcome == LpOutcome::none) return false;
    if (found.outcome == LpOutcome::at_bound)
      throw cases::InputError("", "has no collapse multiplier in this direction: nothing falls, whatever the force");
    ++out.programmes;
    out.multiplier = found.unknowns.front();
    ++programmes_;
    if (tick_) tick_(programmes_, out.multiplier);
    take_forces(found.unknowns, out);
    take_motion(found.prices, out);
    return true;
  }
  void take_forces(const std::vector<double>& unknowns, LimitState& out) {
    std::vector<double> left = dead_;
    for (std::size_t row = 0; row < left.size(); ++row) left[row] += out.multiplier * live_forces_[row];
    out.over_friction = 0.0;
    std::size_t column = 1;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Point& p = points_[i];
      p.found = unknowns[column++];
      Vec3 shear;
      for (const auto& [s, t] : corners_) shear += unknowns[column++] * (s * p.first + t * p.second);
      ++column;
      p.shear = norm(shear);
      out.over_friction = std::max(out.over_friction, p.shear - reach() * contacts_.points[i].friction * p.found);
      at_point(contacts_.points[i], shear - p.found * contacts_.points[i].normal,
               [&](std::size_t row, double value) { left[row] += value; });
    }
    out.off_balance = 0.0;
    for (const double x : left) out.off_balance = std::max(out.off_balance, std::abs(x));
  }
  [[nodiscard]] double reach() const { return std::hypot(corners_.front().first, corners_.front().second); }

  /// The prices of the equations of balance are velocities: those in which live forces of multiplier 1 have the power 1.
  void take_motion(const std::vector<double>& prices, LimitState& out) const {
    double power = 0.0;
    for (std::size_t row = 0; row < live_forces_.size(); ++row) power += live_forces_[row] * prices[row];
    out.motion.assign(contacts_.bodies.size(), {});
    double fastest = 0.0;
    for (std::size_t b = 0; b < contacts_.bodies.size(); ++b) {
      for (std::size_t k = 0; k < kRowsOfBody; ++k) {
        if (row_[k] < 0) continue;
        const double price = prices[b * rows_of_body_ + static_cast<std::size_t>(row_[k])] / power;
        if (k < 3) out.motion[b].v += price * axes_[k];
        if (k >= 3) out.motion[b].w += (price / length_) * axes_[k];
      }
      fastest = std::max(fastest, norm(out.motion[b].v));
    }
    for (const LimitPoint& p : contacts_.points) {
      for (const std::int32_t b : {p.a, p.b}) {
        if (b < 0) continue;
        const kernels::Twist& m = out.motion[static_cast<std::size_t>(b)];
        fastest = std::max(fastest, norm(m.v + cross(m.w, p.at - centre(b))));
      }
    }
    for (kernels::Twist& m : out.motion) m.v = m.v / fastest, m.w = m.w / fastest;
  }

  const LimitContacts& contacts_;
  Vec3 live_;
  std::function<void(int, double)> tick_;
  int programmes_ = 0;
  std::array<Vec3, kRowsOfBody> axes_;  // of the equations of a body: forces, moments; zero: there is none
  std::array<int, kRowsOfBody> row_{};  // −1: there is none
  std::size_t rows_of_body_ = 0;
  double mean_mass_ = 0.0, unit_ = 1.0, length_ = 1.0;  // kg, N, m
  std::vector<double> dead_, live_forces_;              // by equation, in mean weights
  std::vector<Point> points_;
  std::vector<std::pair<double, double>> corners_;
  bool inside_;  // programmes are solved by the interior-point method
};

/// Whether the loads of the case leave a plane model plane.
bool loads_stay_in_plane(const cases::Case& c, Vec3 live) {
  const Vec3 across = cross({0, 0, 1}, live);
  return std::abs(dot(cases::gravity_on_base(c), across)) < 1e-12 && std::ranges::all_of(c.loads, [&](const cases::Load& l) {
           return dot(l.force, across) == 0.0 && cross(l.moment, across) == Vec3{} && !l.at;
         });
}

}  // namespace

LimitResult limit_analysis(const cases::Case& c, const cases::Model& model, const LimitOptions& options) {
  if (norm(cases::gravity_on_base(c)) == 0.0) throw cases::InputError("gravity.acceleration", "is zero; limit analysis needs weights");
  LimitResult out;
  out.contacts = limit_contacts(model, options.live, loads_stay_in_plane(c, options.live));
  if (out.contacts.bodies.empty()) throw cases::InputError("", "has no block that could move");
  out.has_loads = !c.loads.empty();
  out.is_tilt = !out.has_loads && (!c.base || (c.base->tilt[0] == 0.0 && c.base->tilt[1] == 0.0));
  if (!out.contacts.plane) {
    const double half = std::numbers::pi / options.facets;
    out.cone_error = options.outer ? 1.0 / std::cos(half) - 1.0 : 1.0 - std::cos(half);
  }
  Problem problem(c, model, options, out.contacts);
  out.weight = problem.weight();
  problem.associated(out.associated);
  if (options.coulomb) problem.coulomb(out.associated.multiplier, out.coulomb);
  return out;
}

}  // namespace voussoir::solver
