// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/polyhedron.h"

/// A box with vertices within its edges, as meshes have them.
namespace voussoir::testing {

/// Every edge in so many equal parts: 6 faces and 8 + 12 (parts − 1) vertices.
inline geometry::Polyhedron divided_box(Vec3 low, Vec3 high, int parts) {
  const geometry::Polyhedron box = geometry::make_box(low, high);
  geometry::Polyhedron out{box.vertices, {}};
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> first;  // vertex within an edge, from its lesser end on
  for (const auto& loop : box.faces) {
    std::vector<std::int32_t> divided;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::int32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      const auto edge = std::minmax(from, to);
      const auto [at, is_new] = first.try_emplace(edge, static_cast<std::int32_t>(out.vertices.size()));
      const Vec3 a = box.vertices[static_cast<std::size_t>(edge.first)], b = box.vertices[static_cast<std::size_t>(edge.second)];
      for (int k = 1; is_new && k < parts; ++k) out.vertices.push_back(a + (static_cast<double>(k) / parts) * (b - a));
      divided.push_back(from);
      for (int k = 1; k < parts; ++k) divided.push_back(at->second + (from < to ? k - 1 : parts - 1 - k));
    }
    out.faces.push_back(divided);
  }
  return out;
}

}  // namespace voussoir::testing
