// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/disjoint_sets.h"
#include "geometry/nth.h"
#include "geometry/solids/fit/fit_contacts.h"

namespace voussoir::geometry {

namespace {

/// Adds the moments of a triangle: its second moments are those of a third of its area at the middle of each side.
void add_triangle(Moments& m, Vec3 a, Vec3 b, Vec3 c) {
  const double area = 0.5 * norm(cross(b - a, c - a));
  m.area += area;
  for (const Vec3 p : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
    m.first += (area / 3.0) * p;
    m.second = m.second + (area / 3.0) * outer(p, p);
  }
}

double height(const HalfSpace& h, Vec3 v) { return dot(h.normal, v) - h.offset; }

HalfSpace turned(const HalfSpace& h) { return {-h.normal, -h.offset}; }

/// The normal of a contact, outward of a: the mean of both faces.
Vec3 normal_of(std::span<const FitBody> bodies, const FitContact& c) {
  const Vec3 n = nth(nth(bodies, c.a).faces, c.face_a).plane.normal;
  return c.b < 0 ? Vec3{0, 0, -1} : normalised(n - nth(nth(bodies, c.b).faces, c.face_b).plane.normal);
}

constexpr double kMore = 3.0;  // times the misfit of its contacts: so far may one plane for all of them pass

class Planes {
 public:
  Planes(std::span<const FitBody> bodies, std::span<FitContact> contacts, std::optional<double> base_z)
      : bodies_(bodies), contacts_(contacts), base_z_(base_z) {
    for (const FitContact& c : contacts_) origin_ += c.on_a.front() / static_cast<double>(contacts_.size());
  }

  void choose() {
    for (FitContact& c : contacts_)
      if (c.exact) c.plane = nth(nth(bodies_, c.a).body.faces, c.face_a);
    for (const auto& group : grouped(true)) {
      const auto all = [&](bool exact) {
        return std::all_of(group.begin(), group.end(), [&](auto k) { return contacts_[k].exact == exact; });
      };
      if (all(true) || give_one_plane(group)) continue;
      apart_.insert(apart_.end(), group.begin(), group.end());
    }
    std::sort(apart_.begin(), apart_.end());
    for (const auto& pair : grouped(false)) fit_pair(pair);
  }

 private:
  /// Contacts by common faces, or those of `apart_` by pairs of bodies; the sets in the order of their first contacts.
  std::vector<std::vector<std::size_t>> grouped(bool by_faces) {
    std::vector<std::vector<std::size_t>> out;
    if (!by_faces) {
      std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> place;
      for (const std::size_t k : apart_) {
        const auto [at, is_new] = place.try_emplace({contacts_[k].a, contacts_[k].b}, out.size());
        if (is_new) out.emplace_back();
        out[at->second].push_back(k);
      }
      return out;
    }
    DisjointSets sets(contacts_.size());
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> known;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const FitContact& c = contacts_[k];
      sets.join(k, known.try_emplace({c.a, c.face_a}, k).first->second);
      if (c.b >= 0) sets.join(k, known.try_emplace({c.b, c.face_b}, k).first->second);
    }
    std::map<std::size_t, std::size_t> place;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto [at, is_new] = place.try_emplace(sets.of(k), out.size());
      if (is_new) out.emplace_back();
      out[at->second].push_back(k);
    }
    return out;
  }

  [[nodiscard]] HalfSpace fit(const std::vector<std::size_t>& group, Vec3 towards) const {
    Moments m;
    for (const std::size_t k : group) {
      for (const auto* side : {&contacts_[k].on_a, &contacts_[k].on_b}) {
        std::vector<Vec3> moved = *side;
        for (Vec3& v : moved) v -= origin_;
        m.add(moved);
      }
    }
    HalfSpace h = fitted_plane(m, towards);
    h.offset += dot(h.normal, origin_);
    return h;
  }

  /// Whether a plane passes all faces of a group within half of their limits.
  [[nodiscard]] bool passes(const std::vector<std::size_t>& group, const HalfSpace& h) const {
    return std::all_of(group.begin(), group.end(), [&](std::size_t k) {
      const FitContact& c = contacts_[k];
      const auto within = [&](const std::vector<Vec3>& corners, double limit) {
        return std::all_of(corners.begin(), corners.end(), [&](Vec3 v) { return std::abs(height(h, v)) <= 0.5 * limit; });
      };
      return within(c.on_a, nth(bodies_, c.a).limit) && (c.b < 0 || within(c.on_b, nth(bodies_, c.b).limit));
    });
  }

  /// How far a plane is from the common areas of a group [m].
  [[nodiscard]] double farthest(const std::vector<std::size_t>& group, const HalfSpace& h) const {
    double most = 0.0;
    for (const std::size_t k : group) {
      for (const auto* side : {&contacts_[k].on_a, &contacts_[k].on_b}) {
        for (const Vec3& v : *side) most = std::max(most, std::abs(height(h, v)));
      }
    }
    return most;
  }

  /// The largest gap or overlap of a group, or what counts as none [m].
  [[nodiscard]] double misfit(const std::vector<std::size_t>& group) const {
    double most = 0.0;
    for (const std::size_t k : group) {
      const FitContact& c = contacts_[k];
      most = std::max({most, -c.low, c.high, nth(bodies_, c.a).snap});
    }
    return most;
  }

  bool give_one_plane(const std::vector<std::size_t>& group) {
    const Vec3 first = normal_of(bodies_, contacts_[group.front()]);
    const bool on_base = std::any_of(group.begin(), group.end(), [&](std::size_t k) { return contacts_[k].b < 0; });
    HalfSpace h = fit(group, first);
    if (on_base) h = {{0, 0, first.z > 0.0 ? 1.0 : -1.0}, first.z > 0.0 ? *base_z_ : -*base_z_};
    if (!passes(group, h) || farthest(group, h) > kMore * misfit(group)) return false;
    for (const std::size_t k : group) {
      contacts_[k].plane = dot(normal_of(bodies_, contacts_[k]), h.normal) > 0.0 ? h : turned(h);
      contacts_[k].exact = false;
    }
    return true;
  }

  void fit_pair(const std::vector<std::size_t>& pair) {
    FitContact& c = contacts_[pair.front()];
    if (std::all_of(pair.begin(), pair.end(), [&](std::size_t k) { return contacts_[k].exact; })) return;
    HalfSpace h = c.b < 0 ? HalfSpace{{0, 0, -1}, -*base_z_} : fit(pair, normal_of(bodies_, c));
    for (const std::size_t k : pair) contacts_[k].plane = h, contacts_[k].exact = false;
  }

  std::span<const FitBody> bodies_;
  std::span<FitContact> contacts_;
  std::optional<double> base_z_;
  Vec3 origin_;                     // near the contacts, so that moments keep their digits
  std::vector<std::size_t> apart_;  // contacts whose pairs have planes of their own
};

}  // namespace

void Moments::add(std::span<const Vec3> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) add_triangle(*this, polygon[0], polygon[i], polygon[i + 1]);
}

void Moments::add(const Moments& other) {
  area += other.area, first += other.first;
  second = second + other.second;
}

HalfSpace fitted_plane(const Moments& m, Vec3 towards) {
  const Vec3 centre = m.first / m.area;
  const Mat3 c = (1.0 / m.area) * m.second - outer(centre, centre);
  Eigen::Matrix3d covariance;
  covariance << c.r0.x, c.r0.y, c.r0.z, c.r1.x, c.r1.y, c.r1.z, c.r2.x, c.r2.y, c.r2.z;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(covariance);
  Vec3 normal = normalised(towards);
  if (solved.info() == Eigen::Success && solved.eigenvalues()[1] > 25.0 * std::max(solved.eigenvalues()[0], 0.0)) {
    const Vec3 n{solved.eigenvectors()(0, 0), solved.eigenvectors()(1, 0), solved.eigenvectors()(2, 0)};
    const double along = dot(n, towards);
    if (std::abs(along) > 0.8) normal = normalised(along > 0.0 ? n : -n);
  }
  return {normal, dot(normal, centre)};
}

void choose_planes(std::span<const FitBody> bodies, std::span<FitContact> contacts, std::optional<double> base_z) {
  if (!contacts.empty()) Planes(bodies, contacts, base_z).choose();
}

}  // namespace voussoir::geometry
