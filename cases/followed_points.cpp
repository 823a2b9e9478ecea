// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/followed_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cases/case.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

struct Near {
  std::size_t element = 0;
  double distance = std::numeric_limits<double>::infinity(), allowed = 0.0;  // m
};

/// The element whose bounding box is nearest; the lowest number among equally near ones.
Near nearest_box(const Model& model, Vec3 p) {
  Near best;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const auto [low, high] = geometry::bounds(model.blocks[i].shape);
    const auto apart = [](double x, double from, double to) { return std::max({from - x, 0.0, x - to}); };
    const Vec3 d{apart(p.x, low.x, high.x), apart(p.y, low.y, high.y), apart(p.z, low.z, high.z)};
    if (norm(d) < best.distance) best = {i, norm(d), std::max({high.x - low.x, high.y - low.y, high.z - low.z})};
  }
  return best;
}

std::string millimetres(double metres) { return text(std::round(1e3 * metres) / 1e3); }

}  // namespace

void check_followed_points(const Case& c, const Model& model) {
  Faults faults;
  for (std::size_t i = 0; i < c.output.history.size(); ++i) {
    const HistoryPoint& h = c.output.history[i];
    const Near near = nearest_box(model, h.point);
    if (near.distance <= near.allowed) continue;
    faults.add({indexed_key("output.history", i, "point"),
                quoted(h.name) + " lies outside the model: the nearest element, " + describe(model.blocks[near.element], near.element) +
                    ", is " + millimetres(near.distance) + " m away; allowed: in an element, or no farther from one than it is long (" +
                    millimetres(near.allowed) + " m)"});
  }
  faults.raise();
}

}  // namespace voussoir::cases
