// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/prism.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

using Loop = std::vector<std::int32_t>;

/// For each corner of the bottom, the vertex above: the far end of the edge that leaves the bottom there. Nothing unless the shape is a
/// prism over `bottom`.
std::optional<Loop> tops(const Polyhedron& p, std::size_t bottom) {
  const Loop& ring = p.faces[bottom];
  const std::size_t k = ring.size();
  if (p.vertices.size() != 2 * k || p.faces.size() != k + 2) return std::nullopt;
  const auto in_ring = [&](std::int32_t v) { return std::find(ring.begin(), ring.end(), v) != ring.end(); };
  Loop top(k, -1);
  int ends = 0;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    if (f == bottom) continue;
    const Loop& loop = p.faces[f];
    const auto below = std::count_if(loop.begin(), loop.end(), in_ring);
    if (below == 0 && loop.size() == k) {
      ++ends;
      continue;
    }
    if (below != 2 || loop.size() != 4) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!in_ring(loop[i]) || in_ring(loop[(i + 1) % 4])) continue;  // the edge that leaves the bottom upwards
      nth(top, std::find(ring.begin(), ring.end(), loop[i]) - ring.begin()) = loop[(i + 1) % 4];
    }
  }
  if (ends != 1 || std::find(top.begin(), top.end(), -1) != top.end()) return std::nullopt;
  return top;
}

Vec3 middle(const Polyhedron& p, const Loop& loop) {
  Vec3 sum;
  for (const std::int32_t v : loop) sum += nth(p.vertices, v);
  return sum / static_cast<double>(loop.size());
}

/// The faces of make_prism or make_hexahedron over k corners.
std::vector<Loop> prism_faces(std::int32_t k) {
  if (k == 4) return {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  std::vector<Loop> faces;
  for (std::int32_t i = 0; i < k; ++i) faces.push_back({i, (i + 1) % k, (i + 1) % k + k, i + k});
  Loop top(static_cast<std::size_t>(k)), bottom(static_cast<std::size_t>(k));
  std::iota(top.begin(), top.end(), k);
  std::iota(bottom.rbegin(), bottom.rend(), 0);
  faces.push_back(bottom);
  faces.push_back(top);
  return faces;
}

}  // namespace

bool is_prism(const Polyhedron& p) noexcept {
  const int k = static_cast<int>(p.vertices.size()) / 2;
  if (k < 3 || p.vertices.size() % 2 != 0 || p.faces.size() != static_cast<std::size_t>(k + 2)) return false;
  int ends = 0;
  for (const auto& face : p.faces) {
    int below = 0;
    for (const std::int32_t v : face) below += v < k ? 1 : 0;
    const int size = static_cast<int>(face.size());
    if (size == k && (below == 0 || below == k)) {
      ++ends;
    } else if (size != 4 || below != 2) {
      return false;
    } else {
      // Sides may have only corners i, i + 1 and the vertices above these two.
      for (const std::int32_t v : face) {
        if (v < k && std::find(face.begin(), face.end(), v + k) == face.end()) return false;
      }
    }
  }
  return ends == 2;
}

Polyhedron in_prism_order(const Polyhedron& p) {
  std::optional<std::size_t> bottom;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    if (!tops(p, f)) continue;
    if (!bottom || middle(p, p.faces[f]).z < middle(p, p.faces[*bottom]).z) bottom = f;
  }
  if (!bottom) return p;
  // The bottom face is counter-clockwise seen from below; its ring must be counter-clockwise seen from above.
  Loop ring = p.faces[*bottom], top = *tops(p, *bottom);
  std::reverse(ring.begin(), ring.end());
  std::reverse(top.begin(), top.end());
  const auto place = [&](std::int32_t v) {
    const Vec3 x = nth(p.vertices, v);
    return std::tuple(x.z, x.y, x.x);
  };
  const auto first = std::min_element(ring.begin(), ring.end(), [&](auto a, auto b) { return place(a) < place(b); }) - ring.begin();
  std::rotate(ring.begin(), ring.begin() + first, ring.end());
  std::rotate(top.begin(), top.begin() + first, top.end());
  Polyhedron out;
  for (const Loop* loop : {&ring, &top}) {
    for (const std::int32_t v : *loop) out.vertices.push_back(nth(p.vertices, v));
  }
  out.faces = prism_faces(static_cast<std::int32_t>(ring.size()));
  return out;
}

}  // namespace voussoir::geometry
