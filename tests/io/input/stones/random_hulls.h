// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "geometry/vec3.h"

/// Convex polyhedra by brute force, and their integrals by quadrature: nothing of the program but its vectors.
namespace hulls {

using voussoir::cross;
using voussoir::dot;
using voussoir::norm;
using voussoir::normalised;
using voussoir::Vec3;

struct Hull {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;  // counter-clockwise from outside
};

/// Sorted round their middle, counter-clockwise against n.
inline std::vector<int> round_order(const std::vector<Vec3>& points, std::vector<int> which, Vec3 n) {
  Vec3 middle;
  for (const int i : which) middle += points[static_cast<std::size_t>(i)] / static_cast<double>(which.size());
  const Vec3 u = normalised(cross(std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, n)), v = cross(n, u);
  const auto angle = [&](int i) {
    const Vec3 r = points[static_cast<std::size_t>(i)] - middle;
    return std::atan2(dot(r, v), dot(r, u));
  };
  std::sort(which.begin(), which.end(), [&](int a, int b) { return angle(a) < angle(b); });
  return which;
}

/// Every plane through three points that has all others on one side is a face.
inline Hull hull_of(const std::vector<Vec3>& points, double tolerance = 1e-9) {
  Hull h;
  const int n = static_cast<int>(points.size());
  std::vector<std::vector<int>> known;
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = j + 1; k < n; ++k) {
        Vec3 normal = cross(at(j) - at(i), at(k) - at(i));
        if (norm(normal) < 1e-7) continue;
        normal = normalised(normal);
        double low = 0.0, high = 0.0;
        std::vector<int> on;
        for (int l = 0; l < n; ++l) {
          const double d = dot(at(l) - at(i), normal);
          low = std::min(low, d), high = std::max(high, d);
          if (std::abs(d) <= tolerance) on.push_back(l);
        }
        if (low < -tolerance && high > tolerance) continue;
        if (std::find(known.begin(), known.end(), on) != known.end()) continue;
        known.push_back(on);
        h.faces.push_back(round_order(points, on, high > tolerance ? -normal : normal));
      }
    }
  }
  std::vector<int> number(points.size(), -1);
  for (auto& face : h.faces) {
    for (int& v : face) {
      int& m = number[static_cast<std::size_t>(v)];
      if (m < 0) {
        m = static_cast<int>(h.vertices.size());
        h.vertices.push_back(at(v));
      }
      v = m;
    }
  }
  return h;
}

/// The same elsewhere. Hulls are found at the origin, where coordinates have all their digits.
inline Hull moved(Hull h, Vec3 by) {
  for (Vec3& v : h.vertices) v += by;
  return h;
}

/// Points on an ellipsoid about `centre`.
inline std::vector<Vec3> random_points(std::mt19937& random, Vec3 centre, int count) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> axis(0.15, 0.45);
  const double a = axis(random), b = axis(random), c = axis(random);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Vec3 d = normalised({normal(random), normal(random), normal(random)});
    points.push_back(centre + Vec3{a * d.x, b * d.y, c * d.z});
  }
  return points;
}

struct Integrals {
  double volume = 0.0;
  Vec3 centroid;
  std::array<double, 6> inertia{};  // about the centroid, unit density: xx, yy, zz, xy, xz, yz
};

/// Of tetrahedra from a vertex by four points each, exact for second moments.
inline Integrals integrals_of(const Hull& h) {
  constexpr double kA = 0.58541019662496845446, kB = 0.13819660112501051518;
  Integrals r;
  const auto visit = [&](auto use) {
    const Vec3 o = h.vertices[0];
    for (const auto& face : h.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const std::array<Vec3, 4> p{o, h.vertices[static_cast<std::size_t>(face[0])], h.vertices[static_cast<std::size_t>(face[i])],
                                    h.vertices[static_cast<std::size_t>(face[i + 1])]};
        const double volume = dot(p[1] - o, cross(p[2] - o, p[3] - o)) / 6.0;
        for (std::size_t q = 0; q < 4; ++q) {
          Vec3 x;
          for (std::size_t k = 0; k < 4; ++k) x += (k == q ? kA : kB) * p[k];
          use(x, 0.25 * volume);
        }
      }
    }
  };
  Vec3 first;
  visit([&](Vec3 x, double w) { r.volume += w, first += w * (x - h.vertices[0]); });
  r.centroid = h.vertices[0] + first / r.volume;
  visit([&](Vec3 x, double w) {
    const Vec3 d = x - r.centroid;
    r.inertia[0] += w * (d.y * d.y + d.z * d.z), r.inertia[1] += w * (d.x * d.x + d.z * d.z), r.inertia[2] += w * (d.x * d.x + d.y * d.y);
    r.inertia[3] -= w * d.x * d.y, r.inertia[4] -= w * d.x * d.z, r.inertia[5] -= w * d.y * d.z;
  });
  return r;
}

inline double shortest_edge(const Hull& h) {
  double least = 1e300;
  for (const auto& face : h.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      least = std::min(
          least, norm(h.vertices[static_cast<std::size_t>(face[(i + 1) % face.size()])] - h.vertices[static_cast<std::size_t>(face[i])]));
    }
  }
  return least;
}

/// Heron's formula over a fan.
inline double area_of(const Hull& h, const std::vector<int>& face) {
  double area = 0.0;
  const auto at = [&](std::size_t i) { return h.vertices[static_cast<std::size_t>(face[i])]; };
  for (std::size_t i = 1; i + 1 < face.size(); ++i) area += 0.5 * norm(cross(at(i) - at(0), at(i + 1) - at(0)));
  return area;
}

/// Both parts of a hull that a plane cuts, and the area of the section.
struct Halves {
  Hull below, above;
  double section = 0.0;
};
inline Halves halves_of(const Hull& h, Vec3 normal, double offset) {
  std::vector<Vec3> below, above, cut;
  for (const Vec3& v : h.vertices) (dot(v, normal) < offset ? below : above).push_back(v);
  for (const auto& face : h.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (a > b) continue;
      const Vec3 p = h.vertices[static_cast<std::size_t>(a)], q = h.vertices[static_cast<std::size_t>(b)];
      const double dp = dot(p, normal) - offset, dq = dot(q, normal) - offset;
      if ((dp < 0.0) != (dq < 0.0)) cut.push_back(p + dp / (dp - dq) * (q - p));
    }
  }
  below.insert(below.end(), cut.begin(), cut.end());
  above.insert(above.end(), cut.begin(), cut.end());
  std::vector<int> all(cut.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const Hull section{cut, {}};
  return {hull_of(below), hull_of(above), area_of(section, round_order(cut, all, normal))};
}

}  // namespace hulls
