// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <unordered_map>

#include "geometry/assembly.h"
#include "solver/world/world.h"

namespace voussoir::solver {

/// Fills PointSets, each distinct list of points once.
class PointSetBuilder {
 public:
  explicit PointSetBuilder(PointSets& sets) : sets_(sets) {}
  /// Number of the set that equals `points` bit for bit; added if new.
  std::int32_t add(std::span<const geometry::Segment> points);

 private:
  PointSets& sets_;
  std::unordered_map<std::string, std::int32_t> known_;
};

}  // namespace voussoir::solver
