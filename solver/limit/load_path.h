// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "solver/limit/limit.h"

namespace voussoir::solver {

/// A point load at one place of its path.
struct LoadPosition {
  Vec3 from;                         // m, on the path
  LoadedPlace place;                 // where it meets the model; no element: it meets nothing that can move
  std::optional<LimitResult> found;  // none: nothing falls under a load here, whatever its size
  [[nodiscard]] double multiplier(bool coulomb) const { return coulomb ? found->coulomb.multiplier : found->associated.multiplier; }
};

struct LoadPath {
  std::vector<LoadPosition> positions;
  std::optional<std::size_t> weakest;  // that with the smallest multiplier (Coulomb's where asked for); none: nothing falls anywhere
};

/// A point load that moves along a line of straight pieces, at `count` places equally far from each other, both ends among them.
/// \param options  options.live.direction and .force are those of the load \param corners  two or more, m
/// \throw as limit_analysis, but that a place at which nothing falls is told in the result
LoadPath limit_along_path(const cases::Case& c, const cases::Model& model, const LimitOptions& options, std::span<const Vec3> corners,
                          int count);

}  // namespace voussoir::solver
