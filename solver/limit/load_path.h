// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cases/forward.h"
#include "cases/loads/loaded_place.h"
#include "solver/limit/limit.h"

namespace voussoir::solver {

/// A point load at one position of its path.
struct LoadPosition {
  Vec3 from;                         // m, on the path
  cases::LoadedPlace place;          // point of action on the model; without element: nothing movable is hit
  std::optional<LimitResult> found;  // none: no collapse under a load at this position, whatever its size
  [[nodiscard]] double multiplier(bool coulomb) const { return coulomb ? found->coulomb.multiplier : found->associated.multiplier; }
};

struct LoadPath {
  std::vector<LoadPosition> positions;
  std::optional<std::size_t> weakest;  // position with the smallest multiplier (Coulomb's if requested); none: no collapse at any position
};

/// Analyses a point load that moves along a polyline, at `count` equidistant positions including both ends.
/// \param options  options.live.direction and .force are those of the load \param corners  two or more, m
/// \throw as limit_analysis, except that positions without collapse are part of the result
LoadPath limit_along_path(const cases::Case& c, const cases::Model& model, const LimitOptions& options, std::span<const Vec3> corners,
                          int count);

}  // namespace voussoir::solver
