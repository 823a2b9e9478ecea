// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// A uniform grid over axis-aligned boxes: which boxes may touch a given box. Cells are as large as the largest usual box, so a box lies in few cells.
/// Memory is O(number of boxes): cells are hashed, so a brick thrown 1 km away costs nothing.
class UniformGrid {
 public:
  /// Re-fills the grid. Boxes are copied; their indices are their order.
  void build(std::span<const Box3> boxes);

  /// Appends to `out`, in ascending order and without doubles, all boxes that intersect `query` (closed intersection).
  void query(const Box3& query, std::vector<std::int32_t>& out) const;

 private:
  std::vector<Box3> boxes_;
  double cell_ = 1.0;                 // m
  std::vector<std::int32_t> start_;   // by hash bucket, into items_
  std::vector<std::int32_t> items_;   // box indices, ascending in a bucket
  std::uint32_t mask_ = 0;
};

}  // namespace voussoir::geometry
