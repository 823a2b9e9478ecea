// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases/house/house_parts.h"
#include "cases/house/house_wall.h"
#include "cases/house/roofs/house_pitched.h"
#include "cases/house/roofs/house_vault.h"
#include "cases/house/walls/brick_cells.h"
#include "cases/house/walls/cut_bricks.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

using geometry::Polygon;

/// In brick heights: a joint within this distance of a corner of the cut goes through the corner, so that no face is a sliver.
constexpr double kNear = 1e-3;

/// A course of a gable: its number in the wall, and its heights [m].
struct GableCourse {
  int number = 0;
  double low = 0.0, high = 0.0;
};

/// Layers of a course. Gables of a wall in Flemish bond are in English bond, gables of rubble are of bricks in running bond.
std::vector<Wythe> layers_of(const HousePlan& plan, const WallPlan& wall, int course) {
  if (plan.bond != Bond::flemish && plan.bond != Bond::rubble) return wythes(plan, wall, course);
  HousePlan other = plan;
  other.bond = plan.bond == Bond::rubble ? Bond::running : Bond::english;
  return wythes(other, wall, course);
}

/// The gable of one wall, in the plane (y, z). Computed in metres, since the cut of the vault lies on no grid.
class Gable {
 public:
  Gable(const HousePlan& plan, const WallPlan& wall, const Polygon& under) : plan_(plan), wall_(wall), under_(under) {
    height_ = metres(plan.brick_height);
    brick_ = metres(plan.brick_length) * metres(plan.brick_width) * height_;
  }

  /// Courses from the top of the wall to the crown. A remainder too low for a course raises the top of the course below.
  [[nodiscard]] std::vector<GableCourse> courses(double crown) const {
    std::vector<GableCourse> all;
    const double base = metres(plan_.height), near = kNear * height_;
    for (int i = 0; metres(i * plan_.brick_height) < crown - near; ++i) {
      double high = std::min(metres(plan_.height + (i + 1) * plan_.brick_height), base + crown);
      for (const geometry::Point2 p : under_) {
        if (std::abs(p.t - high) < near) high = p.t;
      }
      all.push_back({plan_.course_count() + i, all.empty() ? base : all.back().high, high});
    }
    while (all.size() > 1 && is_too_little(all.back())) {
      all[all.size() - 2].high = all.back().high;
      all.pop_back();
    }
    return all;
  }

  /// Bricks of a layer through the wall, divided at half the course's height like any other course; a piece of less than half a brick is
  /// joined to its neighbour.
  [[nodiscard]] std::vector<CutBrick> pieces(const GableCourse& course, const Wythe& wythe) const {
    const Polygon section = part_between(under_, course.low, course.high, -kFar, kFar);
    const std::vector<double> corners = corners_of(section);
    const Interval span = span_at(section, 0.5 * (course.low + course.high));
    std::vector<CutBrick> all;
    for (const Interval along : divide(span, wythe, plan_.brick_length)) {
      const double low = all.empty() ? -kFar : all.back().high;
      all.push_back({low, along.high == span.high ? kFar : through_corner(metres(along.high), corners), {}, 0.0});
    }
    const double least = 0.5 * brick_ / metres(wythe.depth.length());
    for (CutBrick& p : all) cut_brick(section, p);
    join_small(section, least, all);
    return all;
  }

  /// Whether no part of the unit is cut away.
  [[nodiscard]] bool is_whole(const CutBrick& piece, const Wythe& wythe) const {
    return std::abs(piece.area / (metres(wythe.unit) * height_) - 1.0) < 1e-9 && geometry::as_rectangle(piece.section) &&
           std::abs(piece.high - piece.low - metres(wythe.unit)) < 1e-9;
  }

 private:
  static constexpr double kFar = 1e5;  // m, beyond any wall

  [[nodiscard]] bool is_too_little(const GableCourse& course) const {
    if (course.high - course.low < 0.5 * height_) return true;
    const double area = geometry::region(part_between(under_, course.low, course.high, -kFar, kFar)).area;
    const std::vector<Wythe> layers = layers_of(plan_, wall_, course.number);
    return std::any_of(layers.begin(), layers.end(), [&](const Wythe& w) { return area * metres(w.depth.length()) < 0.5 * brick_; });
  }

  [[nodiscard]] static std::vector<double> corners_of(const Polygon& section) {
    std::vector<double> places;
    for (const geometry::Point2 p : section) places.push_back(p.s);
    return places;
  }

  [[nodiscard]] double through_corner(double joint, const std::vector<double>& corners) const {
    for (const double corner : corners) {
      if (std::abs(corner - joint) < kNear * height_) return corner;
    }
    return joint;
  }

  [[nodiscard]] Interval span_at(const Polygon& section, double z) const {
    Polygon above = section, scratch;
    geometry::clip(above, {0.0, -1.0}, -z, scratch);
    const geometry::Rectangle box = geometry::bounds(above);
    const Interval span{ticks(box.low.s), ticks(box.high.s)};
    // A crown narrower than half a brick is still one piece.
    const Tick lack = std::max<Tick>(0, plan_.shortest_piece() - span.length());
    return {span.low - lack, span.high + lack};
  }

  const HousePlan& plan_;
  const WallPlan& wall_;
  const Polygon& under_;
  double height_ = 0.0, brick_ = 0.0;  // m, m3
};

void add_course(const House& house, const HousePlan& plan, const WallPlan& wall, const Gable& gable, const GableCourse& course,
                HouseParts& parts) {
  Block prototype;
  prototype.kind = PartKind::brick;
  prototype.material = parts.masonry;
  prototype.tag = wall_tag(house, wall, "gable");
  prototype.segment_size = segment_size_of(plan.brick_length, plan.brick_width, plan.brick_height);
  for (const Wythe& wythe : layers_of(plan, wall, course.number)) {
    prototype.leaf = leaf_of(plan, wall, wythe.depth);
    const Interval x = in_house(plan, wall, {}, wythe.depth, {}).x;
    for (const CutBrick& piece : gable.pieces(course, wythe)) {
      std::vector<std::array<double, 2>> corners;
      for (const geometry::Point2 p : piece.section) corners.push_back({p.s, p.t});
      prototype.whole = gable.is_whole(piece, wythe);
      prototype.shape = geometry::make_prism(corners, metres(x.low), metres(x.high));
      prototype.cells = {1, 1, 1};
      if (house.cells && geometry::as_rectangle(piece.section)) {
        const auto [low, high] = geometry::bounds(prototype.shape);
        const CellCounts n = cells_of_piece(*house.cells, cell_unit(plan, wall, wythe.depth),
                                            {high.y - low.y, high.x - low.x, high.z - low.z}, prototype.whole);
        prototype.cells = by_edges(prototype.shape, {0, 1, 0}, n);
      }
      parts.blocks.push_back(prototype);
    }
  }
}

}  // namespace

void build_gables(const House& house, const HousePlan& plan, HouseParts& parts) {
  const Polygon profile =
      house.roof.kind == RoofKind::pitched ? pitched_gable(rafter_profile(house, plan), plan) : vault_profile(house, plan).inner;
  // The profile runs from the front over the crown to the rear: clockwise in (y, z).
  const Polygon under(profile.rbegin(), profile.rend());
  const double crown = height_of(profile);
  for (const Side side : {Side::right, Side::left}) {
    const WallPlan& wall = plan.wall(side);
    if (!wall.built) continue;
    const Gable gable(plan, wall, under);
    for (const GableCourse& course : gable.courses(crown)) add_course(house, plan, wall, gable, course, parts);
  }
}

}  // namespace voussoir::cases
