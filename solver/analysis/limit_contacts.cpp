// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/analysis/limit_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "cases/contact_rules.h"
#include "geometry/polygon.h"

namespace voussoir::solver {
namespace {

using geometry::Point2;

constexpr double kSamePlace = 1e-9;  // m
constexpr double kOnLine = 1e-12;    // m2, twice the area of three points on a line

double turn(Point2 o, Point2 a, Point2 b) { return (a.s - o.s) * (b.t - o.t) - (a.t - o.t) * (b.s - o.s); }

/// Corners of the convex hull (Andrew 1979); of points on a line its two ends.
std::vector<Point2> hull_of(std::vector<Point2> points) {
  const auto less = [](Point2 a, Point2 b) { return a.s != b.s ? a.s < b.s : a.t < b.t; };
  std::ranges::sort(points, less);
  points.erase(std::ranges::unique(points, [](Point2 a, Point2 b) { return std::hypot(a.s - b.s, a.t - b.t) < kSamePlace; }).begin(),
               points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  const auto chain = [&hull](auto first, auto last) {
    const std::size_t begin = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), *first) <= kOnLine) hull.pop_back();
      hull.push_back(*first);
    }
    hull.pop_back();  // it begins the other chain
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

std::optional<LimitPlane> plane_of(const cases::Model& model, Vec3 live) {
  const Vec3 across = cross({0, 0, 1}, live);
  std::optional<std::pair<double, double>> all;
  for (const cases::Block& block : model.blocks) {
    double low = 1e300, high = -1e300;
    for (const Vec3& v : block.shape.vertices) low = std::min(low, dot(v, across)), high = std::max(high, dot(v, across));
    for (const Vec3& v : block.shape.vertices) {
      if (std::min(dot(v, across) - low, high - dot(v, across)) > kSamePlace) return {};  // no prism
    }
    if (!all) all = {low, high};
    if (std::abs(low - all->first) > kSamePlace || std::abs(high - all->second) > kSamePlace) return {};
  }
  for (const geometry::Joint& j : model.assembly.joints) {
    if (std::abs(dot(j.frame.normal, across)) > kSamePlace) return {};
  }
  if (!all) return {};
  return LimitPlane{live, 0.5 * (all->first + all->second)};
}

double density(const cases::Model& model, std::size_t element) {
  return model.materials[static_cast<std::size_t>(model.blocks[element].material)].value.density;
}

void find_bodies(const cases::Model& model, LimitContacts& out) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> of_member;  // by house and member
  out.body_of.assign(model.blocks.size(), -1);
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    const cases::Block& block = model.blocks[e];
    if (block.fixed) continue;
    auto number = static_cast<std::int32_t>(out.bodies.size());
    if (block.member >= 0) number = of_member.try_emplace({block.house, block.member}, number).first->second;
    if (static_cast<std::size_t>(number) == out.bodies.size()) out.bodies.emplace_back();
    RigidBody& body = out.bodies[static_cast<std::size_t>(number)];
    const geometry::MassProperties& m = model.assembly.elements[e].mass;
    const double mass = density(model, e) * m.volume;
    body.elements.push_back(static_cast<std::int32_t>(e));
    body.centre += mass * m.centroid;
    body.mass += mass;
    out.body_of[e] = number;
  }
  for (RigidBody& b : out.bodies) b.centre = b.centre / b.mass;
}

/// Points that lie behind one another become one in the middle.
std::vector<Vec3> in_plane(std::vector<Vec3> points, const LimitPlane& plane) {
  const Vec3 across = cross({0, 0, 1}, plane.along);
  for (Vec3& p : points) p += (plane.middle - dot(p, across)) * across;
  return points;
}

std::vector<Vec3> points_of(const geometry::Joint& joint, const std::optional<LimitPlane>& plane) {
  const geometry::Frame& f = joint.frame;
  std::vector<Point2> points;
  for (const auto* side : {&joint.side_a, &joint.side_b}) {
    for (const geometry::Segment& s : *side) {
      Point2 p{s.s, s.t};
      if (plane) {
        const Vec3 at = in_plane({f.centre + s.s * f.axis_s + s.t * f.axis_t}, *plane).front() - f.centre;
        p = {dot(at, f.axis_s), dot(at, f.axis_t)};
      }
      points.push_back(p);
    }
  }
  std::vector<Vec3> all;
  for (const Point2 p : hull_of(std::move(points))) all.push_back(f.centre + p.s * f.axis_s + p.t * f.axis_t);
  return all;
}

bool has_bond(const cases::JointLaw& law) { return !law.stiffens() && (law.tension > 0.0 || law.cohesion > 0.0); }

}  // namespace

LimitContacts limit_contacts(const cases::Model& model, Vec3 live, bool reduce) {
  LimitContacts out;
  if (reduce) out.plane = plane_of(model, live);
  find_bodies(model, out);
  const auto body = [&](std::int32_t e) { return e == geometry::kBase ? -1 : out.body_of[static_cast<std::size_t>(e)]; };
  for (std::size_t j = 0; j < model.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = model.assembly.joints[j];
    std::int32_t a = body(joint.element_a), b = body(joint.element_b);
    if (a == b) continue;  // of one body, or both fixed
    if (has_bond(model.laws[static_cast<std::size_t>(model.joint_law[j])].value)) ++out.bonded;
    const double degrees = cases::friction_without_bond(model, j);
    const bool turned = a < 0;
    if (turned) std::swap(a, b);
    for (const Vec3 at : points_of(joint, out.plane)) {
      out.points.push_back({static_cast<std::int32_t>(j), a, b, at, turned ? -joint.frame.normal : joint.frame.normal,
                            std::tan(degrees * std::numbers::pi / 180.0)});
    }
  }
  return out;
}

}  // namespace voussoir::solver
