// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/grid.h"
#include "geometry/separation.h"
#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Index of the base in a pair of bodies.
inline constexpr std::int32_t kBaseBody = -1;

/// Overlap of elements with each other, and with the base, in one frame [m].
struct Interpenetration {
  double deepest = 0;                  // of any two bodies; 0: no overlap
  std::int32_t a = -1, b = kBaseBody;  // the deepest pair: a is the element with the lower number; -1 without overlap
  double deepest_in_base = 0;
  std::int64_t deep_pairs = 0;  // pairs deeper than half of the larger segment of both; -1: segment sizes are unknown
};

/// Tests every pair of bodies of which one at least is free, bonded or not, by the exact method of geometry/separation.h. Two supports
/// do not count, nor a support and the base: contact does not act between them. For use by one thread; frames in order.
class InterpenetrationCheck {
 public:
  /// \param run  its /model \throw FileError
  InterpenetrationCheck(const Hdf5File& run, const Building& building, const std::vector<Pose>& start);

  [[nodiscard]] Interpenetration at(const std::vector<Pose>& poses);
  /// Number of pairs of bodies, including the base, that overlap or are at most 0.1 mm apart.
  [[nodiscard]] std::int64_t touching_pairs(const std::vector<Pose>& poses);

 private:
  void place_all(const std::vector<Pose>& poses, double wider);
  void begin_with_last(Interpenetration& now) const;
  void take_base(std::size_t element, Interpenetration& now) const;
  void take_pair(std::int32_t a, std::int32_t b, Interpenetration& now) const;
  /// Whether these elements are a pair, counted from `a`.
  [[nodiscard]] bool is_pair(std::size_t a, std::int32_t b) const {
    return b > static_cast<std::int32_t>(a) && (fixed_[a] == 0 || fixed_[static_cast<std::size_t>(b)] == 0);
  }
  [[nodiscard]] bool touch(std::int32_t a, std::int32_t b) const;

  std::vector<geometry::ConvexBody> body_, placed_;  // relative to the initial centroid; as placed in the current frame
  std::vector<double> half_segment_;                 // m; empty: unknown
  std::vector<std::uint8_t> fixed_;                  // 1: a support
  bool has_base_;
  double base_;
  std::vector<geometry::Box3> box_;
  geometry::UniformGrid grid_;
  std::vector<std::int32_t> near_;
  std::int32_t last_a_ = kBaseBody, last_b_ = kBaseBody;  // deepest pair of elements in the previous frame
};

}  // namespace voussoir::io
