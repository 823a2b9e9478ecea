// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/assembly.h"

/// What the rooms of the geometry tests share.
namespace voussoir::geometry::test {

/// A generator whose numbers are the same with every standard library (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high) {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return low + (high - low) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

inline Polyhedron box_at(Vec3 low, Vec3 edges) { return make_box(low, low + edges); }

/// Parts that may float, all with one segment size.
inline std::vector<Part> parts_of(const std::vector<Polyhedron>& shapes, double size, bool anchored = true) {
  std::vector<Part> parts;
  for (const Polyhedron& s : shapes) parts.push_back({&s, size, anchored});
  return parts;
}

inline Assembly assemble_all(const std::vector<Polyhedron>& shapes, double size, std::optional<double> base_z = std::nullopt) {
  return assemble(parts_of(shapes, size), base_z);
}

/// Running bond, one wythe along x: bricks of 0.2 × 0.1 × 0.1 m, odd courses shifted by half a brick.
inline std::vector<Polyhedron> running_wall(int courses, int bricks) {
  std::vector<Polyhedron> shapes;
  for (int k = 0; k < courses; ++k) {
    for (int i = 0; i < bricks; ++i) shapes.push_back(box_at({0.2 * i + 0.1 * (k % 2), 0.0, 0.1 * k}, {0.2, 0.1, 0.1}));
  }
  return shapes;
}

inline double sum_of_areas(SegmentList segments) {
  double sum = 0.0;
  for (const Segment& s : segments) sum += s.area;
  return sum;
}

struct FirstMoments {
  double s = 0.0, t = 0.0;
};
inline FirstMoments first_moments(SegmentList segments) {
  FirstMoments m;
  for (const Segment& x : segments) m.s += x.s * x.area, m.t += x.t * x.area;
  return m;
}

inline Vec3 point_of(const Frame& f, const Segment& x) { return f.centre + x.s * f.axis_s + x.t * f.axis_t; }

/// Equal to a relative tolerance. doctest's own default adds one to the scale, so for areas of bricks it would be an absolute tolerance.
inline doctest::Approx relative(double value, double tolerance) { return doctest::Approx(value).epsilon(tolerance).scale(0.0); }

inline bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }
inline bool near(Vec3 a, Vec3 b, double tolerance) { return norm(a - b) <= tolerance; }

inline bool same(const Segment& a, const Segment& b) { return a.s == b.s && a.t == b.t && a.area == b.area; }
inline bool same(SegmentList a, SegmentList b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

/// What a call complains of: the message, or "" when it does not.
struct Complaint {
  std::string what;
  int subject = -2, other = -2;
  [[nodiscard]] bool mentions(const std::string& words) const { return what.find(words) != std::string::npos; }
};
template <class Call>
Complaint complaint(Call call) {
  try {
    call();
  } catch (const ModelError& e) {
    return {e.what(), e.subject(), e.other()};
  }
  return {};
}

}  // namespace voussoir::geometry::test
