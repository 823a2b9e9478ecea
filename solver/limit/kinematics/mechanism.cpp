// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/kinematics/mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

constexpr double kStill = 1e-3;  // of the fastest point's speed: does not move

/// The velocity of b against a at a contact point.
Vec3 against(const LimitContacts& c, const LimitState& s, const LimitPoint& p) {
  const auto of = [&](std::int32_t body) {
    if (body < 0) return Vec3{};
    const auto i = static_cast<std::size_t>(body);
    return s.motion[i].v + cross(s.motion[i].w, p.at - c.bodies[i].centre);
  };
  return of(p.b) - of(p.a);
}

}  // namespace

Mechanism mechanism_of(const LimitContacts& c, const LimitState& s) {
  const std::size_t n = c.bodies.size();
  geometry::DisjointSets sets(n + 1);  // of bodies; the last is the ground
  const auto place = [&](std::int32_t body) { return body < 0 ? n : static_cast<std::size_t>(body); };
  std::map<std::int32_t, double> apart;  // by joint
  for (const LimitPoint& p : c.points) {
    double& most = apart[p.joint];
    most = std::max(most, norm(against(c, s, p)));
  }
  for (const LimitPoint& p : c.points)
    if (apart[p.joint] < kStill) sets.join(place(p.a), place(p.b));
  std::map<std::size_t, MechanismPart> by_root;
  Mechanism out;
  for (std::size_t b = 0; b < n; ++b) {
    if (sets.same(b, n)) {
      out.standing += c.bodies[b].mass;
      continue;
    }
    MechanismPart& part = by_root[sets.of(b)];
    part.bodies.push_back(static_cast<std::int32_t>(b));
    part.mass += c.bodies[b].mass;
    part.centre += c.bodies[b].mass * c.bodies[b].centre;
  }
  for (auto& [root, part] : by_root) {
    part.centre = part.centre / part.mass;
    for (const std::int32_t b : part.bodies) {
      const auto i = static_cast<std::size_t>(b);
      const double share = c.bodies[i].mass / part.mass;
      part.motion.w += share * s.motion[i].w;
      part.motion.v += share * s.motion[i].v;
    }
    out.parts.push_back(std::move(part));
  }
  double heaviest = 0.0;
  for (const MechanismPart& p : out.parts) heaviest = std::max(heaviest, p.mass);
  const auto without_round_off = [&](const MechanismPart& p) { return std::round(1e9 * p.mass / heaviest); };
  std::ranges::stable_sort(out.parts, std::greater(), without_round_off);  // of equal parts in the order of their bodies
  std::vector<std::int32_t> part_of(n + 1, -1);
  for (std::size_t k = 0; k < out.parts.size(); ++k)
    for (const std::int32_t b : out.parts[k].bodies) nth(part_of, b) = static_cast<std::int32_t>(k);
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<MechanismSeam, std::set<std::int32_t>>> seams;
  std::map<std::pair<std::int32_t, std::int32_t>, double> least;
  for (const LimitPoint& p : c.points) {
    const auto ends = std::minmax(part_of[place(p.a)], part_of[place(p.b)]);
    if (ends.first == ends.second) continue;
    auto& [seam, joints] = seams[ends];
    const Vec3 v = against(c, s, p);
    const double open = dot(v, p.normal);
    seam.a = ends.first, seam.b = ends.second;
    seam.open = std::max(seam.open, open);
    seam.slide = std::max(seam.slide, norm(v - open * p.normal));
    joints.insert(p.joint);
    const auto [at, first] = least.try_emplace(ends, norm(v));
    at->second = std::min(at->second, norm(v));
  }
  for (auto& [ends, found] : seams) {
    MechanismSeam& seam = found.first;
    seam.joints = static_cast<int>(found.second.size());
    seam.hinge = seam.open > kStill && least[ends] < kStill;
    out.seams.push_back(seam);
  }
  return out;
}

}  // namespace voussoir::solver
