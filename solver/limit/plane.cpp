// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "solver/limit/balance.h"

/// Models in which all happens in one plane (LimitPlane), and their contact points.
namespace voussoir::solver {
namespace {

constexpr double kFlat = 1e-9;       // of a length, a force: nothing
constexpr double kParallel = 1e-6;   // of unit vectors: too near to each other to tell a plane
constexpr double kRoundOff = 4e-16;  // of a coordinate, relative

/// The normal of the plane that holds the normals of all joints, or else that of the vertical plane of the force.
Vec3 across_of(const LimitContacts& contacts, Vec3 direction) {
  Vec3 best;
  const Vec3 first = contacts.points.front().normal;
  for (const LimitPoint& p : contacts.points) {
    const Vec3 across = cross(first, p.normal);
    if (norm(across) > norm(best)) best = across;
  }
  if (norm(best) > kParallel) return normalised(best);
  best = cross(first, direction);
  return norm(best) > kParallel ? normalised(best) : Vec3{};
}

/// Points of a joint that lie behind one another.
struct Row {
  std::size_t front = 0, back = 0;  // most and least along `across`
};

class Reduction {
 public:
  Reduction(const LimitContacts& contacts, const LimitPlane& plane, double size) : contacts_(contacts), plane_(plane) {
    double far = 0.0;
    for (const LimitPoint& p : contacts.points) far = std::max({far, std::abs(p.at.x), std::abs(p.at.y), std::abs(p.at.z)});
    flat_ = kFlat * size + kRoundOff * far;
  }

  [[nodiscard]] double flat() const { return flat_; }
  [[nodiscard]] double off(Vec3 at) const { return dot(at, plane_.across) - plane_.middle; }

  /// The points begin..end of one joint: its two ends in the plane (one, if they are at one place), or none if it does not lie on both
  /// sides of the plane there.
  [[nodiscard]] std::vector<BalancePoint> ends(std::size_t begin, std::size_t end) const {
    const Vec3 line = cross(plane_.across, contacts_.points[begin].normal);
    double low = place(begin, line), high = low;
    for (std::size_t i = begin; i < end; ++i) low = std::min(low, place(i, line)), high = std::max(high, place(i, line));
    std::vector<BalancePoint> found;
    for (const double where : {low, high}) {
      if (where == high && high - low <= flat_ && !found.empty()) continue;
      Row row{end, end};
      for (std::size_t i = begin; i < end; ++i) {
        if (std::abs(place(i, line) - where) > flat_) continue;
        if (row.front == end || off(at(i)) > off(at(row.front))) row.front = i;
        if (row.back == end || off(at(i)) < off(at(row.back))) row.back = i;
      }
      const double front = off(at(row.front)), back = off(at(row.back));
      if (front < -flat_ || back > flat_) return {};
      found.push_back(point(row, front, back));
    }
    return found;
  }

 private:
  [[nodiscard]] Vec3 at(std::size_t i) const { return contacts_.points[i].at; }
  [[nodiscard]] double place(std::size_t i, Vec3 line) const { return dot(at(i), line); }
  [[nodiscard]] BalancePoint point(Row row, double front, double back) const {
    const LimitPoint& p = contacts_.points[row.front];
    const double share = front - back > flat_ ? std::clamp(-back / (front - back), 0.0, 1.0) : 1.0;
    const Vec3 middle = share * at(row.front) + (1.0 - share) * at(row.back);
    return {p.a,
            p.b,
            middle,
            p.normal,
            normalised(cross(plane_.across, p.normal)),
            plane_.across,
            p.friction,
            {row.front, row.back},
            {share, 1.0 - share}};
  }

  const LimitContacts& contacts_;
  const LimitPlane& plane_;
  double flat_ = 0.0;
};

/// Calls take(begin, end) for the points of each joint; stops where it gives false. \return whether all gave true
template <class Take>
bool for_each_joint(const LimitContacts& contacts, const Take& take) {
  for (std::size_t begin = 0; begin < contacts.points.size();) {
    std::size_t end = begin;
    while (end < contacts.points.size() && contacts.points[end].joint == contacts.points[begin].joint) ++end;
    if (!take(begin, end)) return false;
    begin = end;
  }
  return true;
}

/// Whether all forces lie in the plane, and all moments are across it.
bool lie_in(const LimitForces& forces, const LimitPlane& plane) {
  const double little = kFlat * forces.weight;
  const auto in = [&](const BodyForces& f) {
    return std::ranges::all_of(f.force, [&](Vec3 v) { return std::abs(dot(v, plane.across)) <= little; }) &&
           std::ranges::all_of(f.moment, [&](Vec3 m) { return norm(m - dot(m, plane.across) * plane.across) <= little * forces.length; });
  };
  return in(forces.dead) && in(forces.live);
}

}  // namespace

std::optional<LimitPlane> plane_of(const LimitContacts& contacts, const LimitForces& forces, Vec3 direction) {
  if (contacts.points.empty() || !contacts.ties.empty()) return {};
  LimitPlane plane;
  plane.across = across_of(contacts, direction);
  if (plane.across == Vec3{} || !lie_in(forces, plane)) return {};
  for (const LimitPoint& p : contacts.points)
    if (std::abs(dot(p.normal, plane.across)) > kFlat) return {};
  plane.middle = dot(contacts.bodies.front().centre, plane.across);
  const Reduction reduction(contacts, plane, forces.length);
  for (const RigidBody& b : contacts.bodies)
    if (std::abs(reduction.off(b.centre)) > reduction.flat()) return {};
  if (!for_each_joint(contacts, [&](std::size_t begin, std::size_t end) { return !reduction.ends(begin, end).empty(); })) return {};
  plane.along = normalised(cross(plane.across, contacts.points.front().normal));
  plane.up = cross(plane.across, plane.along);
  return plane;
}

void Balance::take_points_of_plane(const LimitPlane& plane) {
  const Reduction reduction(contacts_, plane, length_);
  for_each_joint(contacts_, [&](std::size_t begin, std::size_t end) {
    for (const BalancePoint& p : reduction.ends(begin, end)) points_.push_back(p);
    return true;
  });
}

}  // namespace voussoir::solver
