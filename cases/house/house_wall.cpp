// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_wall.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "cases/house/house_parts.h"
#include "cases/house/house_thickness.h"
#include "cases/house/walls/arches.h"
#include "cases/house/walls/brick_cells.h"
#include "cases/house/walls/prism.h"
#include "cases/house/walls/rubble.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// Joins a remainder at the back of `pieces` to its neighbour. The other end is treated with the pieces mirrored.
void join_leftover(std::vector<Interval>& pieces, Tick brick_length, bool half_at_edge) {
  if (pieces.size() < 2 || pieces.back().length() >= brick_length / 2) return;
  const Tick end = pieces.back().high;
  pieces.pop_back();
  Interval& last = pieces.back();
  if (end - last.low <= brick_length) {
    last.high = end;
    return;
  }
  // Together longer than a brick. Half a brick on the inside makes the end piece the longer one, which bonds the edge best.
  last.high = half_at_edge ? end - brick_length / 2 : last.low + brick_length / 2;
  pieces.push_back({last.high, end});
}

void mirror(std::vector<Interval>& pieces) {
  for (Interval& p : pieces) p = {-p.high, -p.low};
  std::reverse(pieces.begin(), pieces.end());
}

/// A lintel element or a brick before it becomes a block.
struct Laid {
  Interval along, depth, height;
  bool whole = true;
  std::int32_t member = -1;
  std::size_t opening = 0;
  bool through = false;
};

/// Adds a lintel, as thick as its wall, in equal rows about a brick long through the wall; each row is a separate member.
void add_lintel(const House& house, const HousePlan& plan, const WallPlan& wall, const Hole& hole, HouseParts& parts,
                std::vector<Laid>& laid) {
  const Tick element = ticks(house.openings[hole.opening].lintel->element);
  const Tick rows = (wall.thickness + plan.brick_length - 1) / plan.brick_length;
  for (Tick row = 0; row < rows; ++row) {
    const Interval depth{row * wall.thickness / rows, (row + 1) * wall.thickness / rows};
    for (const Interval along : cut_member(hole.along, element)) {
      laid.push_back({along, depth, hole.height, along.length() == element, parts.members, hole.opening});
    }
    ++parts.members;
  }
}

/// Joins pieces of two neighbouring layers to headers in Flemish bond: in the faces before each stretcher, between the faces everywhere. A
/// piece that an end or an opening changed in one layer only is left as it is.
void join_headers(const HousePlan& plan, int course, Interval leaf, bool full_height, std::vector<LaidBrick>& bricks) {
  const Tick width = plan.brick_width;
  const std::vector<Wythe> layers = wythes(plan, leaf.length(), course);
  if (layers[0].header == 0) return;
  const auto layer_of = [&](Interval depth) {
    const auto same = [&](const Wythe& w) { return w.depth.low + leaf.low == depth.low && w.depth.high + leaf.low == depth.high; };
    return std::ranges::find_if(layers, same) - layers.begin();
  };
  const auto count = static_cast<std::ptrdiff_t>(layers.size());
  const Tick period = layers[0].header + layers[0].unit, offset = layers[0].offset;
  const auto begins_header = [&](const LaidBrick& b) {
    const Tick middle = (b.along.low + b.along.high) / 2 - offset;
    const bool in_header = (middle % period + period) % period < width;
    return layer_of(b.depth) % 2 == (in_header ? 0 : 1);
  };
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const LaidBrick first = bricks[i];
    const std::ptrdiff_t layer = layer_of(first.depth);
    if (layer + 1 >= count || !begins_header(first)) continue;
    const Interval behind = nth(layers, layer + 1).depth, next{behind.low + leaf.low, behind.high + leaf.low};
    const auto second = std::ranges::find_if(bricks, [&](const LaidBrick& b) { return b.along == first.along && b.depth == next; });
    if (second == bricks.end()) continue;
    bricks[i] = {first.along, {first.depth.low, next.high}, full_height && first.along.length() == width};
    const bool before = second - bricks.begin() < static_cast<std::ptrdiff_t>(i);
    bricks.erase(second);
    if (before) --i;
  }
}

std::vector<Interval> without(const std::vector<Interval>& spans, const std::vector<Interval>& stones) {
  std::vector<Interval> left;
  for (Interval span : spans) {
    for (const Interval stone : stones) {
      if (!span.overlaps(stone)) continue;
      if (stone.low > span.low) left.push_back({span.low, stone.low});
      span.low = stone.high;
    }
    if (span.high > span.low) left.push_back(span);
  }
  return left;
}

/// Positions of stones through both leaves in a course, ascending. Positions in a hole, or with less than half a brick beside them, are
/// left out.
std::vector<Interval> through_stones(const House& house, const HousePlan& plan, const WallPlan& wall, int course) {
  if (wall.leaf == 0 || !house.leaves->through) return {};
  const ThroughStones& through = *house.leaves->through;
  if (course % through.every != through.every / 2) return {};
  const Tick spacing = ticks(through.spacing), width = plan.brick_width;
  const bool stretchers = plan.bond == Bond::running || widths_through(plan, wall.leaf) == 1;
  const Tick grid = stretchers || course % 2 == 1 ? width / 2 : 0;  // so that no joint continues beside the stone
  const bool second_row = course / through.every % 2 == 1;
  const std::vector<Interval> spans = free_spans(plan, wall, course, {0, wall.thickness});
  const Interval between_corners{wall.meets[0] ? wall.corner : 0, wall.length - (wall.meets[1] ? wall.corner : 0)};
  std::vector<Interval> stones;
  for (Tick at = second_row ? spacing : spacing / 2; at < wall.length; at += spacing) {
    const Tick low = (at - grid) / width * width + grid;
    const Interval stone{low, low + width};
    if (stone.low < between_corners.low || stone.high > between_corners.high) continue;
    const auto room = [&](Tick beside) { return beside == 0 || beside >= plan.shortest_piece(); };
    const auto holds = [&](Interval s) { return room(stone.low - s.low) && room(s.high - stone.high); };
    if (std::ranges::any_of(spans, holds)) stones.push_back(stone);
  }
  return stones;
}

/// Fills the part of a layer of a course behind the pockets of beams.
void fill_behind_beams(const HousePlan& plan, const WallPlan& wall, int course, const Wythe& wythe, std::vector<LaidBrick>& bricks) {
  for (const Hole& hole : wall.holes) {
    const bool cut = hole.floor >= 0 && hole.depth.overlaps(wythe.depth) && hole.depth.low > wythe.depth.low;
    if (!cut || !hole.height.overlaps(nth(plan.courses, course))) continue;
    const Interval depth{wythe.depth.low, hole.depth.low};
    for (const Interval along : divide(hole.along, {depth, plan.brick_length, 0}, plan.brick_length))
      bricks.push_back({along, depth, false});
  }
}

/// Cells of a brick along x, y, z of the house.
CellCounts cells_of(const House& house, const HousePlan& plan, const WallPlan& wall, const Laid& laid) {
  const CellCounts n = cells_of_piece(*house.cells, cell_unit(plan, wall, laid.depth),
                                      {metres(laid.along.length()), metres(laid.depth.length()), metres(laid.height.length())}, laid.whole);
  return wall.along_x ? n : CellCounts{n[1], n[0], n[2]};
}

Block block_of(const House& house, const HousePlan& plan, const WallPlan& wall, const Laid& laid, const HouseParts& parts) {
  Block prototype;
  prototype.whole = laid.whole;
  prototype.member = laid.member;
  if (laid.member < 0) {
    prototype.kind = PartKind::brick;
    prototype.material = laid.through ? parts.through : parts.masonry;
    prototype.leaf = leaf_of(plan, wall, laid.depth);
    prototype.tag = wall_tag(house, wall);
    prototype.segment_size = segment_size_of(plan.brick_length, plan.brick_width, plan.brick_height);
    if (house.cells) prototype.cells = cells_of(house, plan, wall, laid);
  } else {
    prototype.kind = PartKind::lintel;
    prototype.material = parts.timber;
    prototype.tag = "lintel " + std::to_string(laid.opening);
    const Tick element = std::min(ticks(house.openings[laid.opening].lintel->element), ticks(house.openings[laid.opening].lintel->length));
    prototype.segment_size = segment_size_of(element, laid.depth.length(), laid.height.length());
  }
  return box_block(in_house(plan, wall, laid.along, laid.depth, laid.height), prototype);
}

void add_stones(const House& house, const HousePlan& plan, const WallPlan& wall, const std::vector<RubbleStone>& stones,
                HouseParts& parts) {
  Block prototype;
  prototype.kind = PartKind::brick;
  prototype.tag = wall_tag(house, wall);
  prototype.segment_size = segment_size_of(plan.brick_length, plan.brick_width, plan.brick_height);
  for (const RubbleStone& stone : stones) {
    prototype.material = stone.through ? parts.through : parts.masonry;
    prototype.leaf = leaf_of(plan, wall, stone.depth);
    prototype.shape = wall_prism(plan, wall, stone.outline, stone.depth);
    parts.blocks.push_back(prototype);
  }
}

/// Adds the blocks of one course. \param rubble  null: bricks
void build_course(const House& house, const HousePlan& plan, const WallPlan& wall, int course, const RubbleWalls* rubble,
                  HouseParts& parts) {
  const Interval height = nth(plan.courses, course);
  if (rubble != nullptr) add_stones(house, plan, wall, rubble->stones(wall, course), parts);
  std::vector<Laid> laid;
  if (rubble == nullptr) {
    for (const LaidBrick& brick : lay_course(house, plan, wall, course))
      laid.push_back({brick.along, brick.depth, height, brick.whole, -1, 0, brick.through});
  }
  for (const Hole& hole : wall.holes) {
    if (hole.lintel && hole.height.low == height.low) add_lintel(house, plan, wall, hole, parts, laid);
  }
  std::sort(laid.begin(), laid.end(),
            [](const Laid& a, const Laid& b) { return std::tie(a.along.low, a.depth.low) < std::tie(b.along.low, b.depth.low); });
  // In order round the house, so that blocks of neighbouring numbers are neighbours in space.
  if (wall.outer() && (wall.side == Side::rear || wall.side == Side::left)) std::reverse(laid.begin(), laid.end());
  for (const Laid& l : laid) parts.blocks.push_back(block_of(house, plan, wall, l, parts));
  for (const Hole& hole : wall.holes) {
    if (hole.arch && hole.height.low == height.low) add_arch(house, plan, wall, hole, parts);
  }
}

}  // namespace

std::vector<Wythe> wythes(const HousePlan& plan, Tick thickness, int course) {
  const Tick length = plan.brick_length;
  const Tick width = plan.brick_width;
  const bool even = course % 2 == 0;
  const Tick count = widths_through(plan, thickness);
  std::vector<Wythe> result;
  Tick at = 0;  // in brick widths
  const auto add = [&](Tick widths, Tick unit, Tick offset) {
    result.push_back({{depth_of_widths(plan, thickness, at), depth_of_widths(plan, thickness, at + widths)}, unit, offset});
    at += widths;
  };
  if (plan.bond == Bond::rubble) {
    add(count, length, 0);
  } else if (plan.bond == Bond::running || count == 1) {
    while (at < count) {
      add(1, length, even ? 0 : length / 2);
      result.back().half_at_edge = true;
    }
  } else if (plan.bond == Bond::flemish && count % 2 == 0) {
    const Tick offset = even ? 0 : length / 4 * 3;
    while (at < count) {
      const bool face = at == 0 || at + 1 == count;
      add(1, face ? length : width, offset);
      face ? result.back().header = width : result.back().core = true;
    }
  } else if (plan.bond == Bond::header && count == 2) {
    add(2, width, even ? 0 : width / 2);
  } else if (even) {
    while (at + 2 <= count) add(2, width, 0);
    if (at < count) add(1, length, 0);
  } else {
    add(1, length, length / 4);
    while (at + 2 <= count) add(2, width, length / 4);
    if (at < count) add(1, length, length / 4);
  }
  return result;
}

std::vector<Wythe> wythes(const HousePlan& plan, const WallPlan& wall, int course) {
  if (wall.leaf == 0) return wythes(plan, wall.thickness, course);
  std::vector<Wythe> both = wythes(plan, wall.leaf, course);
  for (Wythe& inner : wythes(plan, wall.thickness - wall.leaf, course)) {
    inner.depth = {inner.depth.low + wall.leaf, inner.depth.high + wall.leaf};
    both.push_back(inner);
  }
  return both;
}

std::int32_t leaf_of(const HousePlan& plan, const WallPlan& wall, Interval depth) {
  if (wall.leaf == 0 || (depth.low < wall.leaf && depth.high > wall.leaf)) return -1;
  return static_cast<std::int32_t>(2 * (&wall - plan.walls.data()) + (depth.low < wall.leaf ? 0 : 1));
}

std::vector<Interval> divide(Interval span, const Wythe& wythe, Tick brick_length) {
  const Tick period = wythe.header + wythe.unit;
  std::vector<Interval> pieces;
  Tick at = span.low;
  const auto lay_to = [&](Tick joint) {
    if (joint <= at || joint >= span.high) return;
    pieces.push_back({at, joint});
    at = joint;
  };
  const Tick before = span.low - wythe.offset;
  for (Tick joint = span.low - (before % period + period) % period; joint < span.high; joint += period) {
    lay_to(joint);
    if (wythe.header > 0) lay_to(joint + wythe.header);
  }
  pieces.push_back({at, span.high});
  mirror(pieces);
  join_leftover(pieces, brick_length, wythe.half_at_edge);
  mirror(pieces);
  join_leftover(pieces, brick_length, wythe.half_at_edge);
  return pieces;
}

std::vector<LaidBrick> lay_course(const House& house, const HousePlan& plan, const WallPlan& wall, int course) {
  const bool full_height = nth(plan.courses, course).length() == plan.brick_height;
  const std::vector<Interval> stones = through_stones(house, plan, wall, course);
  std::vector<LaidBrick> bricks;
  for (const Wythe& wythe : wythes(plan, wall, course)) {
    for (const Interval span : without(free_spans(plan, wall, course, wythe.depth), stones)) {
      for (const Interval along : divide(span, wythe, plan.brick_length)) {
        const bool is_unit = along.length() == wythe.unit && !wythe.core;
        bricks.push_back({along, wythe.depth, full_height && is_unit});
      }
    }
    fill_behind_beams(plan, wall, course, wythe, bricks);
  }
  if (plan.bond == Bond::flemish) {
    join_headers(plan, course, {0, wall.leaf == 0 ? wall.thickness : wall.leaf}, full_height, bricks);
    if (wall.leaf > 0) join_headers(plan, course, {wall.leaf, wall.thickness}, full_height, bricks);
  }
  for (const Interval along : stones) bricks.push_back({along, {0, wall.thickness}, false, true});
  std::sort(bricks.begin(), bricks.end(),
            [](const LaidBrick& a, const LaidBrick& b) { return std::tie(a.along.low, a.depth.low) < std::tie(b.along.low, b.depth.low); });
  return bricks;
}

void plan_leaves(const House& house, HousePlan& plan) {
  if (!house.leaves) return;
  const Leaves& leaves = *house.leaves;
  if (leaves.through) {
    const Tick spacing = positive_length(leaves.through->spacing, "house.leaves.through.spacing"), least = 2 * plan.brick_length;
    if (spacing < least)
      throw InputError("house.leaves.through.spacing",
                       text(leaves.through->spacing) + " m is less than two bricks' length; at least " + text(metres(least)) + " m");
    if (leaves.through->every < 2)
      throw InputError("house.leaves.through.every", std::to_string(leaves.through->every) + "; stones lie in every second course at most");
  }
  for (const Side side : chosen_walls(plan, leaves.walls, "house.leaves")) {
    for (WallPlan& wall : plan.walls) {
      if (!wall.outer() || wall.side != side) continue;
      const Tick widths = widths_through(plan, wall.thickness), half = depth_of_widths(plan, wall.thickness, widths / 2);
      const Tick outer = leaves.outer ? wall_thickness(*leaves.outer, plan, "house.leaves.outer") : half;
      if (outer > 0 && 3 * (wall.thickness - outer) >= 2 * plan.brick_width) wall.leaf = outer;
      if (wall.leaf > 0 || wall.storey > 0) continue;
      throw InputError(leaves.outer ? "house.leaves.outer" : "house.leaves",
                       "the " + wall_name(house, wall) + " of " + text(metres(wall.thickness)) + " m has no room for two leaves" +
                           (leaves.outer ? ", the outer one of " + text(*leaves.outer) + " m" : std::string()) +
                           "; name thicker ones in house.leaves.walls, each leaf at least two thirds of a brick's width, " +
                           metres_text((2 * plan.brick_width + 2) / 3) + " m");
    }
  }
}

void build_walls(const House& house, const HousePlan& plan, HouseParts& parts) {
  const std::optional<RubbleWalls> rubble = plan.bond == Bond::rubble ? std::make_optional<RubbleWalls>(house, plan) : std::nullopt;
  for (int course = 0; course < plan.course_count(); ++course) {
    for (const WallPlan& wall : plan.walls) build_course(house, plan, wall, course, rubble ? &*rubble : nullptr, parts);
  }
}

}  // namespace voussoir::cases
