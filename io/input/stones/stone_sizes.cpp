// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/stone_sizes.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "cases/case.h"
#include "geometry/polyhedron.h"

namespace voussoir::io {
namespace {

constexpr double kLeastStone = 5e-3, kMostStone = 20.0, kMostModel = 300.0;  // m

double longest_side(const geometry::Box3& box) {
  const Vec3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z});
}

geometry::Box3 bounds_of(const cases::Stone& stone) {
  geometry::Polyhedron all;
  for (const cases::StonePiece& piece : stone.pieces) {
    all.vertices.insert(all.vertices.end(), piece.shape.vertices.begin(), piece.shape.vertices.end());
  }
  return geometry::bounds(all);
}

std::string metres(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g m", length);
  return text;
}

struct Sizes {
  double model, least, middle, most;  // longest sides: of all stones together, and of single stones
};

Sizes sizes_of(const std::vector<cases::Stone>& stones) {
  geometry::Polyhedron corners;  // of the bounding boxes of the stones
  std::vector<double> sides;
  for (const cases::Stone& stone : stones) {
    const geometry::Box3 box = bounds_of(stone);
    corners.vertices.insert(corners.vertices.end(), {box.low, box.high});
    sides.push_back(longest_side(box));
  }
  std::ranges::sort(sides);
  return {longest_side(geometry::bounds(corners)), sides.front(), sides[sides.size() / 2], sides.back()};
}

}  // namespace

std::vector<cases::InputError> unusual_sizes(const cases::Case& c) {
  std::vector<cases::InputError> all;
  for (std::size_t t = 0; t < c.stones.size(); ++t) {
    const cases::StonesSpec& spec = c.stones[t];
    if (spec.stones.empty()) continue;
    const Sizes s = sizes_of(spec.stones);
    if (s.middle >= kLeastStone && s.middle <= kMostStone && s.model <= kMostModel) continue;
    all.emplace_back("stones[" + std::to_string(t) + "].unit",
                     "makes stones of unusual size: those of " + spec.file + " are " + metres(s.least) + " to " + metres(s.most) +
                         " long, and " + metres(s.model) + " together; usually 5 mm to 20 m, and up to 300 m; allowed: m, cm, mm, in, ft");
  }
  return all;
}

}  // namespace voussoir::io
