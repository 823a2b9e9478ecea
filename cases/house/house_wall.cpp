// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_wall.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "cases/house/house_parts.h"

namespace voussoir::cases {
namespace {

/// Joins a leftover at the end of `pieces` (its back) to its neighbour. The other end is treated with the pieces mirrored.
void join_leftover(std::vector<Interval>& pieces, Tick brick_length, bool half_at_edge) {
  if (pieces.size() < 2 || pieces.back().length() >= brick_length / 2) return;
  const Tick end = pieces.back().high;
  pieces.pop_back();
  Interval& last = pieces.back();
  if (end - last.low <= brick_length) {
    last.high = end;
    return;
  }
  // Too long for a brick. Half a brick on the inside keeps the end piece the longer one, which ties the edge best.
  last.high = half_at_edge ? end - brick_length / 2 : last.low + brick_length / 2;
  pieces.push_back({last.high, end});
}

void mirror(std::vector<Interval>& pieces) {
  for (Interval& p : pieces) p = {-p.high, -p.low};
  std::reverse(pieces.begin(), pieces.end());
}

/// A lintel element or a brick, before it becomes a block.
struct Laid {
  Interval along, depth, height;
  bool whole = true;
  std::int32_t member = -1;
  std::size_t opening = 0;
};

/// A lintel is as thick as its wall, in equal rows about a brick long through the wall; each row is a member of its own.
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

/// What the pockets of beams leave of a layer of a course behind them.
void fill_behind_beams(const HousePlan& plan, const WallPlan& wall, int course, const Wythe& wythe, std::vector<LaidBrick>& bricks) {
  for (const Hole& hole : wall.holes) {
    const bool cut = hole.floor >= 0 && hole.depth.overlaps(wythe.depth) && hole.depth.low > wythe.depth.low;
    if (!cut || !hole.height.overlaps(plan.courses[static_cast<std::size_t>(course)])) continue;
    const Interval depth{wythe.depth.low, hole.depth.low};
    for (const Interval along : divide(hole.along, {depth, plan.brick_length, 0}, plan.brick_length))
      bricks.push_back({along, depth, false});
  }
}

Block block_of(const House& house, const HousePlan& plan, const WallPlan& wall, const Laid& laid, const HouseParts& parts) {
  Block prototype;
  prototype.whole = laid.whole;
  prototype.member = laid.member;
  if (laid.member < 0) {
    prototype.kind = PartKind::brick;
    prototype.material = parts.masonry;
    prototype.tag = wall_tag(house, wall);
    prototype.segment_size = segment_size_of(plan.brick_length, plan.brick_width, plan.brick_height);
  } else {
    prototype.kind = PartKind::lintel;
    prototype.material = parts.timber;
    prototype.tag = "lintel " + std::to_string(laid.opening);
    const Tick element = std::min(ticks(house.openings[laid.opening].lintel->element), ticks(house.openings[laid.opening].lintel->length));
    prototype.segment_size = segment_size_of(element, laid.depth.length(), laid.height.length());
  }
  return box_block(in_house(plan, wall, laid.along, laid.depth, laid.height), prototype);
}

void build_course(const House& house, const HousePlan& plan, const WallPlan& wall, int course, HouseParts& parts) {
  const Interval height = plan.courses[static_cast<std::size_t>(course)];
  std::vector<Laid> laid;
  for (const LaidBrick& brick : lay_course(plan, wall, course)) laid.push_back({brick.along, brick.depth, height, brick.whole});
  for (const Hole& hole : wall.holes) {
    if (hole.lintel && hole.height.low == height.low) add_lintel(house, plan, wall, hole, parts, laid);
  }
  std::sort(laid.begin(), laid.end(),
            [](const Laid& a, const Laid& b) { return std::tie(a.along.low, a.depth.low) < std::tie(b.along.low, b.depth.low); });
  // Going round the house, so that neighbours in number are neighbours in space.
  if (wall.outer() && (wall.side == Side::rear || wall.side == Side::left)) std::reverse(laid.begin(), laid.end());
  for (const Laid& l : laid) parts.blocks.push_back(block_of(house, plan, wall, l, parts));
}

}  // namespace

std::vector<Wythe> wythes(const HousePlan& plan, Tick thickness, int course) {
  const Tick length = plan.brick_length;
  const Tick width = plan.brick_width;
  const bool even = course % 2 == 0;
  std::vector<Wythe> result;
  Tick at = 0;
  const auto add = [&](Tick depth, Tick unit, Tick offset) {
    result.push_back({{at, at + depth}, unit, offset});
    at += depth;
  };
  if (plan.bond == Bond::running || thickness == width) {
    while (at < thickness) {
      add(width, length, even ? 0 : length / 2);
      result.back().half_at_edge = true;
    }
  } else if (plan.bond == Bond::header && thickness == length) {
    add(length, width, even ? 0 : width / 2);
  } else if (even) {
    while (at + length <= thickness) add(length, width, 0);
    if (at < thickness) add(width, length, 0);
  } else {
    add(width, length, length / 4);
    while (at + length <= thickness) add(length, width, length / 4);
    if (at < thickness) add(width, length, length / 4);
  }
  return result;
}

std::vector<Interval> divide(Interval span, const Wythe& wythe, Tick brick_length) {
  const Tick unit = wythe.unit, offset = wythe.offset;
  std::vector<Interval> pieces;
  Tick joint = span.low - offset;
  joint = offset + (joint - (joint % unit + unit) % unit) + unit;  // the first joint above span.low
  Tick at = span.low;
  for (; joint < span.high; joint += unit) {
    pieces.push_back({at, joint});
    at = joint;
  }
  pieces.push_back({at, span.high});
  mirror(pieces);
  join_leftover(pieces, brick_length, wythe.half_at_edge);
  mirror(pieces);
  join_leftover(pieces, brick_length, wythe.half_at_edge);
  return pieces;
}

std::vector<LaidBrick> lay_course(const HousePlan& plan, const WallPlan& wall, int course) {
  std::vector<LaidBrick> bricks;
  const bool full_height = plan.courses[static_cast<std::size_t>(course)].length() == plan.brick_height;
  for (const Wythe& wythe : wythes(plan, wall.thickness, course)) {
    for (const Interval span : free_spans(plan, wall, course, wythe.depth)) {
      for (const Interval along : divide(span, wythe, plan.brick_length)) {
        bricks.push_back({along, wythe.depth, full_height && along.length() == wythe.unit});
      }
    }
    fill_behind_beams(plan, wall, course, wythe, bricks);
  }
  std::sort(bricks.begin(), bricks.end(),
            [](const LaidBrick& a, const LaidBrick& b) { return std::tie(a.along.low, a.depth.low) < std::tie(b.along.low, b.depth.low); });
  return bricks;
}

void build_walls(const House& house, const HousePlan& plan, HouseParts& parts) {
  for (int course = 0; course < plan.course_count(); ++course) {
    for (const WallPlan& wall : plan.walls) build_course(house, plan, wall, course, parts);
  }
}

}  // namespace voussoir::cases
