// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/load_path.h"

#include <algorithm>

#include "cases/model.h"
#include "geometry/nth.h"

namespace voussoir::solver {
namespace {

constexpr double kEqual = 1e-9;  // multipliers so near to each other are one: the first place is named

/// The point of the line at this share of its length.
Vec3 point_at(std::span<const Vec3> corners, double share) {
  double length = 0.0;
  for (std::size_t k = 1; k < corners.size(); ++k) length += norm(corners[k] - corners[k - 1]);
  double left = share * length;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const double piece = norm(corners[k] - corners[k - 1]);
    if (left <= piece && piece > 0.0) return corners[k - 1] + (left / piece) * (corners[k] - corners[k - 1]);
    left -= piece;
  }
  return corners.back();
}

}  // namespace

LoadPath limit_along_path(const cases::Case& c, const cases::Model& model, const LimitOptions& options, std::span<const Vec3> corners,
                          int count) {
  LoadPath out;
  for (int k = 0; k < count; ++k) {
    LoadPosition p;
    p.from = point_at(corners, count > 1 ? static_cast<double>(k) / (count - 1) : 0.0);
    p.place = cases::place_of_load(model, p.from, options.live.direction);
    if (p.place.element >= 0 && nth(model.blocks, p.place.element).fixed) p.place.element = -1;
    if (p.place.element >= 0) {
      LimitOptions here = options;
      here.live.kind = LiveLoad::Kind::force;
      here.live.on.clear();
      here.live.at = p.place.at;
      try {
        p.found = limit_analysis(c, model, here);
      } catch (const NothingFalls&) {
      }
    }
    out.positions.push_back(std::move(p));
  }
  for (std::size_t k = 0; k < out.positions.size(); ++k) {
    if (!out.positions[k].found) continue;
    const bool less =
        !out.weakest || out.positions[k].multiplier(options.coulomb) < out.positions[*out.weakest].multiplier(options.coulomb);
    if (less) out.weakest = k;
  }
  return out;
}

}  // namespace voussoir::solver
