// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/contacts.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "cases/model.h"
#include "cases/rules/contact_rules.h"
#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"
#include "geometry/polygon.h"
#include "solver/limit/convex_hull.h"

namespace voussoir::solver {
namespace {

constexpr double kAcross = 1e-3;  // of a direction: less of it lies in the joint's plane than can be told from round-off

double density(const cases::Model& model, std::size_t element) {
  return nth(model.materials, model.blocks[element].material).value.density;
}

/// Which elements hold together: those of a timber member, pieces of a stone whose joints never break, and cells of a unit, which a limit
/// analysis takes as unbreakable.
geometry::DisjointSets held_together(const cases::Model& model) {
  geometry::DisjointSets sets(model.blocks.size());
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> of_member;  // by house and member
  std::map<std::int32_t, std::size_t> of_unit;
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    const cases::Block& b = model.blocks[e];
    if (b.member >= 0) sets.join(of_member.try_emplace({b.house, b.member}, e).first->second, e);
    if (b.unit >= 0) sets.join(of_unit.try_emplace(b.unit, e).first->second, e);
  }
  for (std::size_t j = 0; j < model.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = model.assembly.joints[j];
    if (joint.element_b != geometry::kBase && nth(model.laws, model.joint_law[j]).never_breaks)
      sets.join(static_cast<std::size_t>(joint.element_a), static_cast<std::size_t>(joint.element_b));
  }
  return sets;
}

void find_bodies(const cases::Model& model, LimitContacts& out) {
  geometry::DisjointSets together = held_together(model);
  std::map<std::size_t, std::int32_t> of_set;
  out.body_of.assign(model.blocks.size(), -1);
  for (std::size_t e = 0; e < model.blocks.size(); ++e) {
    if (model.blocks[e].fixed) continue;
    const std::int32_t number = of_set.try_emplace(together.of(e), static_cast<std::int32_t>(out.bodies.size())).first->second;
    if (static_cast<std::size_t>(number) == out.bodies.size()) out.bodies.emplace_back();
    RigidBody& body = nth(out.bodies, number);
    const geometry::MassProperties& m = model.assembly.elements[e].mass;
    const double mass = density(model, e) * m.volume;
    if (body.elements.empty()) body.centre = m.centroid;
    body.elements.push_back(static_cast<std::int32_t>(e));
    body.mass += mass;
    body.centre += (mass / body.mass) * (m.centroid - body.centre);  // by differences: far from the origin they keep their digits
    out.body_of[e] = number;
  }
}

std::vector<Vec3> points_of(const geometry::Joint& joint) {
  std::vector<geometry::Point2> points;
  for (const auto* side : {&joint.side_a, &joint.side_b})
    for (const geometry::Segment& s : *side) points.push_back({s.s, s.t});
  std::vector<Vec3> all;
  const geometry::Frame f = joint.frame();
  for (const std::size_t i : hull_corners(points)) all.push_back(f.centre + points[i].s * f.axis_s + points[i].t * f.axis_t);
  return all;
}

bool has_bond(const cases::JointLaw& law) { return !law.stiffens() && (law.tension > 0.0 || law.cohesion > 0.0); }

}  // namespace

double limit_friction(const cases::Model& model, std::size_t joint) {
  return std::tan(cases::friction_without_bond(model, joint) * std::numbers::pi / 180.0);
}

Tangents limit_tangents(const geometry::Joint& joint, Vec3 normal, Vec3 live) {
  for (const Vec3 wanted : {live, Vec3{0, 0, 1}, joint.frame().axis_s}) {
    const Vec3 along = wanted - dot(wanted, normal) * normal;
    if (norm(along) <= kAcross) continue;
    const Vec3 first = normalised(along);
    return {first, cross(normal, first)};
  }
  return {joint.frame().axis_s, joint.frame().axis_t};
}

LimitContacts limit_contacts(const cases::Model& model, Vec3 live) {
  LimitContacts out;
  find_bodies(model, out);
  const auto body = [&](std::int32_t e) { return e == geometry::kBase ? -1 : nth(out.body_of, e); };
  for (std::size_t j = 0; j < model.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = model.assembly.joints[j];
    std::int32_t a = body(joint.element_a), b = body(joint.element_b);
    if (a == b) continue;  // of one body, or both fixed
    if (has_bond(nth(model.laws, model.joint_law[j]).value)) ++out.bonded;
    const bool turned = a < 0;
    if (turned) std::swap(a, b);
    const Vec3 normal = turned ? -joint.frame().normal : joint.frame().normal;
    const Tangents axes = limit_tangents(joint, normal, live);
    for (const Vec3 at : points_of(joint))
      out.points.push_back({static_cast<std::int32_t>(j), a, b, at, normal, axes.first, axes.second, limit_friction(model, j)});
  }
  out.ties = limit_ties(model, out.body_of);
  return out;
}

}  // namespace voussoir::solver
