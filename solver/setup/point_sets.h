// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <unordered_map>

#include "geometry/assembly.h"
#include "solver/world/world.h"

namespace voussoir::solver {

/// Fills PointSets, each distinct list of points once.
class PointSetBuilder {
 public:
  explicit PointSetBuilder(PointSets& sets) : sets_(sets) {}
  /// Number of the set that equals `points` bit for bit; added if new. \pre `points` outlives the builder
  std::int32_t add(geometry::SegmentList points);

 private:
  PointSets& sets_;
  std::unordered_map<std::string_view, std::int32_t> known_;  // by the bytes of their points
};

}  // namespace voussoir::solver
