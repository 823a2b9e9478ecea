// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/nth.h"
#include "geometry/solids/pieces.h"

namespace voussoir::geometry {

namespace {

/// Two unit vectors perpendicular to n and to each other.
std::pair<Vec3, Vec3> across(Vec3 n) {
  const Vec3 aside = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalised(cross(aside, n));
  return {u, cross(n, u)};
}

/// A single cut of a convex polyhedron.
class Clip {
 public:
  Clip(const Polyhedron& p, const HalfSpace& h, double tolerance) : shape_(p), plane_(h), tolerance_(tolerance) {
    for (const Vec3& v : p.vertices) height_.push_back(dot(h.normal, v) - h.offset);
  }

  Polyhedron cut() {
    const auto [low, high] = std::minmax_element(height_.begin(), height_.end());
    if (*high <= tolerance_) return shape_;
    if (*low >= -tolerance_) return {};
    out_.vertices = shape_.vertices;
    for (const auto& loop : shape_.faces) cut_face(loop);
    add_cap();
    return compacted();
  }

 private:
  [[nodiscard]] int side(std::int32_t v) const {
    const double h = nth(height_, v);
    return h > tolerance_ ? 1 : h < -tolerance_ ? -1 : 0;
  }

  /// The point where an edge crosses the plane, shared by both faces at the edge.
  std::int32_t crossing(std::int32_t a, std::int32_t b) {
    if (a > b) std::swap(a, b);
    const auto [known, is_new] = crossings_.try_emplace({a, b}, static_cast<std::int32_t>(out_.vertices.size()));
    if (is_new) {
      const double ha = nth(height_, a), hb = nth(height_, b);
      const Vec3 from = nth(shape_.vertices, a), to = nth(shape_.vertices, b);
      out_.vertices.push_back(from + (ha / (ha - hb)) * (to - from));
    }
    return known->second;
  }

  void cut_face(const std::vector<std::int32_t>& loop) {
    std::vector<std::int32_t> kept;
    bool below = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::int32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      below = below || side(a) < 0;
      if (side(a) <= 0) kept.push_back(a);
      if (side(a) * side(b) < 0) kept.push_back(crossing(a, b));
    }
    if (!below || kept.size() < 3) return;  // a face that only touches the plane is dropped
    out_.faces.push_back(std::move(kept));
  }

  /// Adds the face made by the cut: all points on the plane, in order around their centre.
  void add_cap() {
    std::vector<std::int32_t> rim;
    for (std::size_t v = 0; v < shape_.vertices.size(); ++v) {
      if (side(static_cast<std::int32_t>(v)) == 0) rim.push_back(static_cast<std::int32_t>(v));
    }
    for (const auto& [edge, v] : crossings_) rim.push_back(v);
    if (rim.size() < 3) return;
    const auto at = [&](std::int32_t v) { return nth(out_.vertices, v); };
    Vec3 middle;
    for (const std::int32_t v : rim) middle += at(v) / static_cast<double>(rim.size());
    const auto [s, t] = across(plane_.normal);
    const auto angle = [&, s = s, t = t](std::int32_t v) { return std::atan2(dot(at(v) - middle, t), dot(at(v) - middle, s)); };
    std::sort(rim.begin(), rim.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
    out_.faces.push_back(std::move(rim));
  }

  Polyhedron compacted() {
    std::vector<std::int32_t> number(out_.vertices.size(), -1);
    Polyhedron p;
    for (auto& loop : out_.faces) {
      for (std::int32_t& v : loop) {
        std::int32_t& n = nth(number, v);
        if (n < 0) {
          n = static_cast<std::int32_t>(p.vertices.size());
          p.vertices.push_back(nth(out_.vertices, v));
        }
        v = n;
      }
    }
    p.faces = std::move(out_.faces);
    return p;
  }

  const Polyhedron& shape_;
  const HalfSpace& plane_;
  double tolerance_;
  std::vector<double> height_;  // m, of the vertices above the plane
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> crossings_;
  Polyhedron out_;
};

}  // namespace

Polyhedron clipped(const Polyhedron& p, const HalfSpace& h, double tolerance) { return Clip(p, h, tolerance).cut(); }

}  // namespace voussoir::geometry
