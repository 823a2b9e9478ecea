// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/arches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cases/house/house_wall.h"
#include "cases/house/walls/prism.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kFlatSkew = std::numbers::pi / 6.0;  // rad, angle of the skewbacks of a flat arch from upright
constexpr double kNear = 0.25;           // of a course: a joint that ends within this distance of a corner of the frame ends at the corner
constexpr int kFewest = 3, kMost = 101;  // voussoirs

std::string arch_key(std::size_t opening, const char* field) { return indexed_key("house.opening", opening, "arch") + field; }

/// The soffit: a circle about a point below, or a line whose joints radiate from such a point.
struct Soffit {
  double middle = 0.0, springing = 0.0, half = 0.0;  // m: along, height, half the span
  double angle = 0.0;                                // of the springing, from the crown [rad]
  double radius = 0.0, centre = 0.0;                 // m; centre: height
  bool flat = false;

  Soffit(Interval opening, Tick spring, double rise) : springing(metres(spring)), half(0.5 * metres(opening.length())) {
    middle = metres(opening.low) + half;
    flat = rise == 0.0;
    angle = flat ? kFlatSkew : 2.0 * std::atan2(rise, half);
    radius = half / std::sin(angle);
    centre = springing - radius * std::cos(angle);
  }
  [[nodiscard]] double length() const { return flat ? 2.0 * half : 2.0 * radius * angle; }
  /// Corner i of n + 1.
  [[nodiscard]] Point2 corner(int i, int n) const {
    const double share = 2.0 * i / n - 1.0;
    if (i == 0 || i == n) return {middle + share * half, springing};
    if (flat) return {middle + share * half, springing};
    return {middle + radius * std::sin(share * angle), centre + radius * std::cos(share * angle)};
  }
};

/// Edges of the frame [m].
struct FrameBox {
  double low, high, bottom, top, near;

  /// The point where the joint from a corner of the soffit meets the frame.
  [[nodiscard]] Point2 exit(const Soffit& soffit, Point2 from, bool end) const {
    const double ds = from.s - soffit.middle, dt = from.t - soffit.centre;  // from the centre
    const double side = ds < 0.0 ? low : high;
    const Point2 above{from.s + (top - from.t) * ds / std::max(dt, 1e-9), top};
    if (std::abs(above.s - side) < near) return {side, top};
    if ((above.s - low) * (high - above.s) > 0.0) return above;
    const double t = from.t + (side - from.s) * dt / ds;
    if (top - t < near) return {side, top};
    if (end && t - bottom < 2.0 * near) return {side, bottom};
    return {side, t};
  }
};

int count_of(const Arch& arch, const HousePlan& plan, const Soffit& soffit, const std::string& key) {
  if (!arch.voussoirs) return std::clamp(2 * static_cast<int>(soffit.length() / metres(plan.brick_width) / 2.0) + 1, kFewest, kMost);
  const int most = std::min(kMost, static_cast<int>(soffit.length() / metres(plan.lowest_course())));
  if (*arch.voussoirs < kFewest || *arch.voussoirs > most)
    throw InputError(key + ".voussoirs", std::to_string(*arch.voussoirs) + " voussoirs; allowed: " + std::to_string(kFewest) + " to " +
                                             std::to_string(most) + ", each at least half a course wide");
  return *arch.voussoirs;
}

}  // namespace

std::vector<Polygon> arch_sections(const Arch& arch, const HousePlan& plan, Interval span, Interval frame, const std::string& key) {
  const Soffit soffit(span, frame.low, arch.rise);
  const double near = kNear * metres(plan.brick_height);
  const FrameBox box{metres(span.low - ticks(arch.springer)), metres(span.high + ticks(arch.springer)), metres(frame.low),
                     metres(frame.high), near};
  const int n = count_of(arch, plan, soffit, key);
  std::vector<Point2> below, above;
  for (int i = 0; i <= n; ++i) {
    below.push_back(soffit.corner(i, n));
    above.push_back(box.exit(soffit, below.back(), i == 0 || i == n));
  }
  std::vector<Polygon> pieces;
  const Point2 first = above.front(), last = above.back();
  if (first.t > box.bottom) {  // else the first voussoir replaces the springer
    pieces.push_back({{box.low, box.bottom}, below.front(), first});
    if (first.s > box.low) pieces.back().push_back({box.low, box.top});
  }
  for (std::size_t i = 0; i + 1 < below.size(); ++i) {
    Polygon piece{below[i], below[i + 1], above[i + 1]};
    for (const double side : {box.high, box.low}) {  // a corner of the frame between the two joints
      const bool turns_high =
          side == box.high && above[i].t == box.top && above[i].s < side && above[i + 1].s == side && above[i + 1].t < box.top;
      const bool turns_low =
          side == box.low && above[i + 1].t == box.top && above[i + 1].s > side && above[i].s == side && above[i].t < box.top;
      if (turns_high || turns_low) piece.push_back({side, box.top});
    }
    piece.push_back(above[i]);
    pieces.push_back(std::move(piece));
  }
  if (last.t > box.bottom) {
    pieces.push_back({below.back(), {box.high, box.bottom}});
    if (last.s < box.high) pieces.back().push_back({box.high, box.top});
    pieces.back().push_back(last);
  }
  return pieces;
}

Interval arch_frame(const Arch& arch, Tick springing) noexcept { return {springing, springing + ticks(arch.rise) + ticks(arch.thickness)}; }

Interval arch_height(const Opening& opening, Tick head) noexcept {
  return arch_frame(*opening.arch, head + (opening.lintel ? ticks(opening.lintel->height) : 0));
}

Tick rows_through(const HousePlan& plan, Tick thickness) noexcept { return (thickness + plan.brick_length - 1) / plan.brick_length; }

void check_arch(const Arch& arch, const HousePlan& plan, Interval span, const std::string& key) {
  const double half = 0.5 * metres(span.length());
  if (!(arch.rise >= 0.0 && arch.rise <= half + 1e-9))
    throw InputError(key + ".rise",
                     text(arch.rise) + " m; allowed: 0 (a flat arch) to " + text(half) + " m, half the width (a semicircle)");
  const Tick thickness = positive_length(arch.thickness, key + ".thickness");
  if (thickness < plan.lowest_course())
    throw InputError(key + ".thickness",
                     text(arch.thickness) + " m is less than half a course; at least " + metres_text(plan.lowest_course()) + " m");
  const Tick springer = positive_length(arch.springer, key + ".springer");
  if (springer < plan.shortest_piece())
    throw InputError(key + ".springer",
                     text(arch.springer) + " m is less than half a brick; at least " + metres_text(plan.shortest_piece()) + " m");
}

Hole arch_hole(const House& house, const Hole& under, const HousePlan& plan, const WallPlan& wall) {
  const std::size_t index = under.opening;
  const Arch& arch = *house.openings[index].arch;
  check_arch(arch, plan, under.along, arch_key(index, ""));
  const Tick springer = ticks(arch.springer);
  Hole hole{{under.along.low - springer, under.along.high + springer},
            arch_height(house.openings[index], under.height.high),
            index,
            false,
            {0, wall.thickness}};
  hole.arch = true;
  if (hole.height.high > wall.height.high)
    throw InputError(arch_key(index, ".thickness"), text(arch.thickness) + " m ends at " + metres_text(hole.height.high - wall.height.low) +
                                                        " m, over the height of the wall (" + metres_text(wall.height.length()) + " m)");
  count_of(arch, plan, Soffit(under.along, hole.height.low, arch.rise), arch_key(index, ""));
  return hole;
}

void add_arch(const House& house, const HousePlan& plan, const WallPlan& wall, const Hole& hole, HouseParts& parts) {
  Block prototype;
  prototype.kind = PartKind::arch_stone;
  prototype.material = parts.arches[hole.opening];
  prototype.tag = wall_tag(house, wall);
  prototype.segment_size = segment_size_of(plan.brick_length, plan.brick_width, plan.brick_height);
  const Tick rows = rows_through(plan, wall.thickness);
  const Arch& arch = *house.openings[hole.opening].arch;
  const Interval span{hole.along.low + ticks(arch.springer), hole.along.high - ticks(arch.springer)};
  for (const Polygon& section : arch_sections(arch, plan, span, hole.height, arch_key(hole.opening, ""))) {
    for (Tick row = 0; row < rows; ++row) {
      const Interval depth{row * wall.thickness / rows, (row + 1) * wall.thickness / rows};
      prototype.leaf = leaf_of(plan, wall, depth);
      prototype.shape = wall_prism(plan, wall, section, depth);
      parts.blocks.push_back(prototype);
    }
  }
}

}  // namespace voussoir::cases
