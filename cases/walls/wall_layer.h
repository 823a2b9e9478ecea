// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cases/house/house_wall.h"
#include "cases/house/walls/cut_bricks.h"
#include "cases/walls/wall_layout.h"

/// The bricks of one layer of a course. Internal to cases/.
namespace voussoir::cases {

constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

/// An end of a span, and what it ends at: an opening, a meeting, a beam of a floor, or the free end of the leg.
struct Edge {
  LegCut cut;
  std::size_t opening = kNobody, meeting = kNobody, floor = kNobody;
};

/// A part of a leg that a course fills from face to face.
struct Span {
  Edge low, high;
};

/// Between two places where a leg meets others: joints lie at origin + scale * (offset + unit * k).
struct Field {
  double low = 0.0, high = 0.0, origin = 0.0, scale = 1.0;
};

/// The fields of a leg, ascending.
std::vector<Field> fields_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg);

class Layer {
 public:
  /// \param course  its heights
  Layer(const WallSpec& wall, const Leg& leg, const std::vector<Field>& fields, const Wythe& wythe, Interval course);

  /// Lays the bricks of a span.
  void lay(const Span& span, std::vector<PlanBrick>& bricks) const;
  /// Lays bricks cut to the hills of the leg. \pre the course is above the height of the wall
  void lay_in_hills(const Span& span, std::vector<PlanBrick>& bricks) const;

 private:
  /// Joints of a span, its ends included.
  [[nodiscard]] std::vector<double> bounds(const Span& span) const;
  [[nodiscard]] std::array<Vec3, 4> corners(const LegCut& low, const LegCut& high) const;
  void add(const Span& span, const std::vector<double>& bounds, std::size_t i, std::vector<PlanBrick>& bricks) const;
  /// \param ends  of the span in the middle of the layer \param height  of the course [m] \param whole  section of a whole brick [m2]
  void add_cut(const Span& span, std::array<double, 2> ends, const CutBrick& brick, std::array<double, 2> height, double whole,
               std::vector<PlanBrick>& bricks) const;
  /// The part of a brick with oblique ends under the top of its section.
  [[nodiscard]] geometry::Polyhedron under(const CutBrick& brick, const PlanBrick& plan) const;
  [[nodiscard]] bool is_whole(const LegCut& low, const LegCut& high) const;
  /// Length [m] of a whole brick at s; where two fields meet, that of the longer one.
  [[nodiscard]] double whole_length(double s) const;

  const Leg& leg_;
  const std::vector<Field>& fields_;
  const Wythe& wythe_;
  Interval course_;                                  // heights
  double low_, high_;                                // m, d of its faces
  double unit_ = 0.0, longest_ = 0.0, least_ = 0.0;  // m
};

}  // namespace voussoir::cases
