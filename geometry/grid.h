// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// A uniform grid over axis-aligned boxes: finds the boxes that may touch a given box. The cell size follows the median box, so a usual box
/// lies in few cells; a box that would fill hundreds of cells is kept in a separate list. Memory is O(number of boxes): cells are hashed,
/// so a brick thrown 1 km away costs nothing.
class UniformGrid {
 public:
  /// Builds the grid anew over copies of the boxes; the index of a box is its position in `boxes`. A box with a NaN, or with low > high, is
  /// never found. Allocates only when there are more boxes, or more cells filled, than ever before.
  void build(std::span<const Box3> boxes);

  /// Moves one box. Cheap where the box stays in its cells; fills the whole grid again once cells have run out of room for many boxes.
  /// \pre 0 <= index < number of boxes
  void move(std::int32_t index, const Box3& box);

  /// Appends to `out`, in ascending order and without doubles, all boxes that intersect `query` (closed intersection).
  /// Changes no state: any number of threads may query at once.
  void query(const Box3& query, std::vector<std::int32_t>& out) const;

 private:
  struct Cell {
    std::int32_t x, y, z;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct CellRange {
    Cell low, high;
    friend bool operator==(const CellRange&, const CellRange&) = default;
  };
  enum class Place : std::uint8_t { nowhere, cells, large };
  [[nodiscard]] double median_extent();
  [[nodiscard]] Place place_of(const Box3& box, const CellRange& cells) const noexcept;
  void fill();
  void refill();
  [[nodiscard]] bool add(std::int32_t index);
  void take_out(std::int32_t index);
  [[nodiscard]] Cell cell_of(Vec3 point) const noexcept;
  [[nodiscard]] CellRange cells_of(const Box3& box) const noexcept;
  [[nodiscard]] std::uint32_t bucket_of(Cell cell) const noexcept;
  void query_cell(Cell cell, Cell query_low, const Box3& query, std::vector<std::int32_t>& out) const;

  std::vector<Box3> boxes_;
  std::vector<CellRange> cells_;     // by box: cells that the box overlaps
  std::vector<Place> place_;         // by box: whether it is stored in cells, in large_ or nowhere
  std::vector<std::int32_t> large_;  // boxes that overlap too many cells, or whose cells had no room: tested by every query
  std::size_t most_large_ = 0;       // length of large_ at which the grid is filled again
  double per_cell_ = 1.0;            // 1/m
  std::vector<std::int32_t> start_;  // by hash bucket, index of its first box in items_
  std::vector<std::int32_t> end_;    // by hash bucket, end of its boxes in items_; between it and the next start_ there is room for more
  std::vector<std::int32_t> items_;  // box indices, each at most once in a bucket
  std::vector<double> extents_;      // m, scratch memory of build
  std::uint32_t mask_ = 0;
  std::int32_t room_ = 0;  // spare places of a bucket beyond its number of boxes when the grid was filled
};

}  // namespace voussoir::geometry
