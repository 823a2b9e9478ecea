// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/grid.h"
#include "geometry/separation.h"
#include "io/output/measures/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Stands for the base in a pair of bodies.
inline constexpr std::int32_t kBaseBody = -1;

/// How deep elements are in each other, and in the base, in one frame. m.
struct Interpenetration {
  double deepest = 0;                  // of any two bodies; 0: none overlap
  std::int32_t a = -1, b = kBaseBody;  // that pair: a the element with the lower number; its a is -1 if none overlap
  double deepest_in_base = 0;
  std::int64_t deep_pairs = 0;  // deeper than half a segment, the larger one of both; -1: sizes of segments are not known
};

/// Looks at every pair of elements by the exact test of geometry/separation.h: bonded or not, fixed or not. For one thread; frames one
/// after the other.
class InterpenetrationCheck {
 public:
  /// \param run  its /model \throw FileError
  InterpenetrationCheck(const Hdf5File& run, const Building& building, const std::vector<Pose>& start);

  [[nodiscard]] Interpenetration at(const std::vector<Pose>& poses);
  /// Pairs of bodies, the base among them, that overlap or are no farther apart than 0.1 mm.
  [[nodiscard]] std::int64_t touching_pairs(const std::vector<Pose>& poses);

 private:
  void place_all(const std::vector<Pose>& poses, double wider);
  void begin_with_last(Interpenetration& now) const;
  void take_base(std::size_t element, Interpenetration& now) const;
  void take_pair(std::int32_t a, std::int32_t b, Interpenetration& now) const;
  [[nodiscard]] bool touch(std::int32_t a, std::int32_t b) const;

  std::vector<geometry::ConvexBody> body_, placed_;  // about the centroid as at first; as they lie in the frame at hand
  std::vector<double> half_segment_;                 // m; empty: not known
  bool has_base_;
  double base_;
  std::vector<geometry::Box3> box_;
  geometry::UniformGrid grid_;
  std::vector<std::int32_t> near_;
  std::int32_t last_a_ = kBaseBody, last_b_ = kBaseBody;  // the deepest pair of elements of the frame before
};

}  // namespace voussoir::io
