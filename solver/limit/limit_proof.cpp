// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/limit_proof.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cases/model.h"
#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

Vec3 place(const geometry::Frame& f, const geometry::Segment& s) { return f.centre + s.s * f.axis_s + s.t * f.axis_t; }

}  // namespace

double ForceCheck::worst() const noexcept { return std::max({unbalanced, tension, over_friction, off_joint, over_yield}); }

ForceCheck LimitModel::check_forces(const ModelForces& found, double dead, double live) const {
  const std::vector<Vec3>& at_points = found.at_points;
  const double unit = forces_.weight / static_cast<double>(contacts_.bodies.size());
  ForceCheck out;
  std::vector<Vec3> force(contacts_.bodies.size()), moment(force.size());
  for (std::size_t b = 0; b < force.size(); ++b) {
    force[b] = dead * forces_.dead.force[b] + live * forces_.live.force[b];
    moment[b] = dead * forces_.dead.moment[b] + live * forces_.live.moment[b];
  }
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const LimitPoint& p = contacts_.points[i];
    const geometry::Joint& joint = nth(model_.assembly.joints, p.joint);
    for (const std::int32_t b : {p.a, p.b}) {
      if (b < 0) continue;
      const Vec3 f = b == p.a ? at_points[i] : -at_points[i];
      nth(force, b) += f, nth(moment, b) += cross(p.at - nth(contacts_.bodies, b).centre, f);
    }
    const double n = -dot(at_points[i], p.normal);
    const Vec3 shear = at_points[i] + n * p.normal;
    out.tension = std::max(out.tension, -n / unit);
    const double limit = limit_friction(model_, static_cast<std::size_t>(p.joint)) * std::max(n, 0.0);
    out.over_friction = std::max(out.over_friction, (cone_.gauge({dot(shear, p.first), dot(shear, p.second)}) - limit) / unit);
    double near = std::numeric_limits<double>::infinity();
    for (const auto* side : {&joint.side_a, &joint.side_b})
      for (const geometry::Segment& s : *side) near = std::min(near, norm(place(joint.frame(), s) - p.at));
    out.off_joint = std::max(out.off_joint, near / forces_.length);
  }
  for (std::size_t k = 0; k < contacts_.ties.size(); ++k) {
    const LimitTie& tie = contacts_.ties[k];
    const double pull = found.of_ties[k];
    out.over_yield = std::max({out.over_yield, (pull - tie.most) / unit, (tie.least - pull) / unit});
    for (std::size_t end = 0; end < 2; ++end) {
      for (const LimitTie::Hold& h : tie.ends[end]) {
        if (h.body < 0) continue;
        const Vec3 f = (end == 0 ? pull * h.share : -pull * h.share) * tie.along;
        nth(force, h.body) += f, nth(moment, h.body) += cross(h.at - nth(contacts_.bodies, h.body).centre, f);
      }
    }
  }
  for (std::size_t b = 0; b < force.size(); ++b)
    out.unbalanced = std::max({out.unbalanced, norm(force[b]) / unit, norm(moment[b]) / (unit * forces_.length)});
  return out;
}

Vec3 LimitModel::speed(std::int32_t body, Vec3 where, const std::vector<kernels::Twist>& motion) const {
  if (body < 0) return {};
  return nth(motion, body).v + cross(nth(motion, body).w, where - nth(contacts_.bodies, body).centre);
}

double LimitModel::power(const BodyForces& f, const std::vector<kernels::Twist>& motion) const {
  double sum = 0.0;
  for (std::size_t b = 0; b < motion.size(); ++b) sum += dot(f.force[b], motion[b].v) + dot(f.moment[b], motion[b].w);
  return sum;
}

MotionCheck LimitModel::check_motion(const std::vector<kernels::Twist>& motion) const {
  MotionCheck out;
  out.deficit.assign(model_.assembly.joints.size(), 0.0);
  for (std::size_t e = 0; e < model_.blocks.size(); ++e)
    for (const Vec3 v : model_.blocks[e].shape.vertices) out.fastest = std::max(out.fastest, norm(speed(contacts_.body_of[e], v, motion)));
  if (out.fastest == 0.0) return out;
  for (std::size_t j = 0; j < model_.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = model_.assembly.joints[j];
    const auto body = [&](std::int32_t e) { return e == geometry::kBase ? -1 : nth(contacts_.body_of, e); };
    std::int32_t a = body(joint.element_a), b = body(joint.element_b);
    if (a == b) continue;
    const bool turned = a < 0;
    if (turned) std::swap(a, b);
    const Vec3 normal = turned ? -joint.frame().normal : joint.frame().normal;
    const Tangents axes = limit_tangents(joint, normal, direction_);
    const double friction = limit_friction(model_, j);
    for (const auto* side : {&joint.side_a, &joint.side_b}) {
      for (const geometry::Segment& s : *side) {
        const Vec3 where = place(joint.frame(), s), v = speed(b, where, motion) - speed(a, where, motion);
        const double open = dot(v, normal), needed = friction * cone_.support({dot(v, axes.first), dot(v, axes.second)});
        out.overlap = std::max(out.overlap, -open / out.fastest);
        out.deficit[j] = std::max(out.deficit[j], (needed - open) / out.fastest);
      }
    }
    out.off_normal = std::max(out.off_normal, out.deficit[j]);
  }
  for (const LimitTie& tie : contacts_.ties) {
    const double longer = stretching(tie, contacts_, motion) / out.fastest, held = longer > 0.0 ? tie.most : tie.least;
    const bool limited = std::isfinite(held);
    out.stretches.push_back(limited ? 0.0 : std::abs(longer));
    out.stretch = std::max(out.stretch, out.stretches.back());
    if (limited) out.tie_power += held * longer;
  }
  out.dead_power = power(forces_.dead, motion) / out.fastest;
  for (std::size_t b = 0; b < motion.size(); ++b)
    out.dead_terms +=
        (std::abs(dot(forces_.dead.force[b], motion[b].v)) + std::abs(dot(forces_.dead.moment[b], motion[b].w))) / out.fastest;
  out.live_power = power(forces_.live, motion) / out.fastest;
  return out;
}

double LimitModel::lost_power(const ModelForces& found, const std::vector<kernels::Twist>& motion) const {
  const std::vector<Vec3>& at_points = found.at_points;
  double lost = 0.0;
  for (std::size_t k = 0; k < contacts_.ties.size(); ++k) {
    const double longer = stretching(contacts_.ties[k], contacts_, motion),
                 held = longer > 0.0 ? contacts_.ties[k].most : contacts_.ties[k].least;
    lost += std::abs((std::isfinite(held) ? held - found.of_ties[k] : forces_.weight) * longer);
  }
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const LimitPoint& p = contacts_.points[i];
    const Vec3 v = speed(p.b, p.at, motion) - speed(p.a, p.at, motion);
    const double n = -dot(at_points[i], p.normal), open = dot(v, p.normal);
    const double taken = dot(at_points[i] + n * p.normal, v);
    const double due = limit_friction(model_, static_cast<std::size_t>(p.joint)) * n * cone_.support({dot(v, p.first), dot(v, p.second)});
    lost += std::abs(n * open) + std::abs(due - taken);
  }
  return lost / std::abs(power(forces_.live, motion));
}

double LimitModel::slack_of_bound(const ModelForces& found, const MotionCheck& c) const {
  const std::vector<Vec3>& at_points = found.at_points;
  double held = 0.0;
  for (std::size_t k = 0; k < c.stretches.size(); ++k) held += c.stretches[k] * std::abs(found.of_ties[k]);
  for (std::size_t i = 0; i < contacts_.points.size(); ++i) {
    const LimitPoint& p = contacts_.points[i];
    held += nth(c.deficit, p.joint) * std::abs(dot(at_points[i], p.normal));
  }
  return held / c.live_power;
}

}  // namespace voussoir::solver
