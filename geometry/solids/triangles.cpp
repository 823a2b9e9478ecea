// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

/// Twice the signed area of a triangle seen against a normal [m2].
double turn(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) { return dot(cross(b - a, c - a), normal); }

/// Whether a point is in the ear a, b, c, or on its diagonal from c to a except at its ends: cutting off such an ear would fold the rest.
bool is_in(Vec3 p, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
  constexpr double kOnDiagonal = 1e-9;  // of the diagonal's length
  if (p == a || p == b || p == c) return false;
  return turn(a, b, p, normal) > 0.0 && turn(b, c, p, normal) > 0.0 && turn(c, a, p, normal) > -kOnDiagonal * dot(a - c, a - c);
}

/// The corner whose ear is the best-shaped triangle.
std::size_t best_ear(const std::vector<Vec3>& loop, Vec3 normal) {
  std::size_t best = 0;
  double most = -1e300;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = loop[(i + loop.size() - 1) % loop.size()], b = loop[i], c = loop[(i + 1) % loop.size()];
    const double size = turn(a, b, c, normal), longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    bool empty = size > 0.0;
    for (std::size_t k = 0; empty && k < loop.size(); ++k) empty = !is_in(loop[k], a, b, c, normal);
    const double fat = empty ? size / longest : -1.0;
    if (fat > most) most = fat, best = i;
  }
  return best;
}

/// Whether the ear at corner i may be cut off: it turns inward, and contains no other corner.
bool is_ear(const Mesh& m, const std::vector<std::int32_t>& loop, std::size_t i, Vec3 normal) {
  const auto at = [&](std::size_t k) { return nth(m.vertices, loop[k % loop.size()]); };
  const Vec3 a = at(i + loop.size() - 1), b = at(i), c = at(i + 1);
  if (!(turn(a, b, c, normal) > 0.0)) return false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (is_in(at(k), a, b, c, normal)) return false;
  }
  return true;
}

/// The corner whose ear has the shortest diagonal. Among diagonals equal within `tie`, the lowest along a skew direction wins, so that the
/// choice does not depend on the order of corners.
std::size_t shortest_ear(const Mesh& m, const std::vector<std::int32_t>& loop, Vec3 normal, double tie) {
  constexpr Vec3 kAskew{0.5377, 0.3188, 0.7806};
  std::vector<std::pair<double, std::size_t>> ears;  // length, corner
  const auto at = [&](std::size_t k) { return nth(m.vertices, loop[k % loop.size()]); };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (is_ear(m, loop, i, normal)) ears.emplace_back(norm(at(i + 1) - at(i + loop.size() - 1)), i);
  }
  if (ears.empty()) return 0;
  const double least = std::min_element(ears.begin(), ears.end())->first;
  std::size_t best = 0;
  double lowest = 1e300;
  for (const auto& [length, i] : ears) {
    const double along = dot(kAskew, at(i + 1) + at(i + loop.size() - 1));
    if (length <= least + tie && along < lowest) lowest = along, best = i;
  }
  return best;
}

}  // namespace

Mesh with_parted_faces(const Mesh& m, double most, std::size_t& parted) {
  Mesh out{m.vertices, {}};
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    std::vector<std::int32_t> loop = m.faces[f];
    if (warp(m, f) > most) {
      const Vec3 normal = loop_plane(m, f).normal;
      ++parted;
      while (loop.size() > 3) {
        const std::size_t i = shortest_ear(m, loop, normal, most);
        out.faces.push_back({loop[(i + loop.size() - 1) % loop.size()], loop[i], loop[(i + 1) % loop.size()]});
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    out.faces.push_back(std::move(loop));
  }
  return out;
}

std::vector<std::array<Vec3, 3>> triangles_of(const Mesh& m, std::size_t face) {
  const Vec3 normal = loop_plane(m, face).normal;
  std::vector<Vec3> loop;
  for (const std::int32_t v : m.faces[face]) loop.push_back(nth(m.vertices, v));
  std::vector<std::array<Vec3, 3>> out;
  while (loop.size() > 3) {
    const std::size_t i = best_ear(loop, normal);
    out.push_back({loop[(i + loop.size() - 1) % loop.size()], loop[i], loop[(i + 1) % loop.size()]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
  }
  out.push_back({loop[0], loop[1], loop[2]});
  return out;
}

double winding_number(const Mesh& m, Vec3 point) {
  double angle = 0.0;
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    for (const auto& t : triangles_of(m, f)) {
      const Vec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
      const double la = norm(a), lb = norm(b), lc = norm(c);
      angle += 2.0 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace voussoir::geometry
