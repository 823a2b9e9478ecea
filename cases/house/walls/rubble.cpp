// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/walls/rubble.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <utility>

#include "cases/random.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

// Limits in thousandths.
constexpr Tick kHeights = 250;  // of a course's height, greatest deviation from the mean
constexpr Tick kLengths = 400;  // of a brick's length, greatest deviation
constexpr Tick kDepths = 150;   // of a stone's depth, greatest offset of a joint within the wall
constexpr Tick kLean = 120;     // of a course's height, greatest offset of a head joint's ends
constexpr Tick kBump = 150;     // of a course's height, greatest rise or fall of a bed
constexpr Tick kSlope = 150;    // greatest slope of a bed
constexpr Tick kClear = 200;    // of a brick's length, least distance between joints of two courses

Tick thousandths(Tick of, Tick part) { return of * part / 1000; }

/// Random numbers, seeded by their purpose. Integers only, so the same on every machine.
class Dice {
 public:
  Dice(int seed, std::initializer_list<std::int64_t> what) : state_(static_cast<std::uint64_t>(std::int64_t{seed})) {
    for (const std::int64_t w : what) state_ = mixed(state_ ^ mixed(static_cast<std::uint64_t>(w)));
  }
  /// A number from -most to most. \pre most < 2^31: two metres
  Tick within(Tick most) { return (2 * most * bits() >> 31) - most; }
  /// A number from 0 to below 1.
  double share() { return static_cast<double>(bits()) * 0x1p-31; }

 private:
  std::int64_t bits() { return static_cast<std::int64_t>((state_ = mixed(state_)) >> 33); }
  std::uint64_t state_;
};

Rubble rubble_of(const House& house) { return house.rubble.value_or(Rubble{}); }

/// Identity of a wall, the same in all storeys.
std::tuple<int, std::int32_t, std::int32_t> line_of(const WallPlan& wall) { return {static_cast<int>(wall.side), wall.inner, wall.pier}; }

/// The space between two head joints of a course, through the whole wall or behind a beam.
struct Cell {
  std::array<Tick, 2> low, high;  // along the wall: ends at the bed below and at the bed above
  Interval depth;
  bool whole = true;  // through the wall; else behind a beam
};

/// A joint that ends on a bed, from the course below, from the course above, or both.
struct Vertex {
  bool lower = false, upper = false;
  Tick height = 0;
};
using Bed = std::map<Tick, Vertex>;

/// Lays one wall of one storey.
class WallMason {
 public:
  WallMason(const House& house, const HousePlan& plan, const WallPlan& wall, std::vector<Tick> below)
      : house_(house),
        plan_(plan),
        wall_(wall),
        rubble_(rubble_of(house)),
        irregularity_(ticks(rubble_.irregularity) / 1000000),
        below_(std::move(below)) {
    while (first_ < plan.course_count() && course(first_).low < wall.height.low) ++first_;
    end_ = first_;
    while (end_ < plan.course_count() && course(end_).high <= wall.height.high) ++end_;
  }

  void lay() {
    for (int k = first_; k < end_; ++k) cells_.push_back(lay_course(k));
    for (int k = first_; k <= end_; ++k) beds_.push_back(make_bed(k));
  }
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int end() const { return end_; }
  /// Ends of the head joints at the top of the wall.
  [[nodiscard]] const std::vector<Tick>& top_joints() const { return below_; }

  [[nodiscard]] std::vector<RubbleStone> stones(int k) const {
    std::vector<RubbleStone> all;
    const std::vector<Cell>& cells = nth(cells_, k - first_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const geometry::Polygon outline = outline_of(k, cells[i]);
      Dice dice = dice_for(k, 2, static_cast<std::int64_t>(i));
      const bool through = goes_through(k, cells[i], dice.share());
      for (const Interval depth : layers(cells[i], through, dice)) all.push_back({outline, depth, through && wall_.leaf > 0});
    }
    return all;
  }

 private:
  /// A length times a share in thousandths times the irregularity of the stones.
  [[nodiscard]] Tick irregular(Tick of, Tick part) const { return thousandths(thousandths(of, part), irregularity_); }
  [[nodiscard]] Interval course(int k) const { return nth(plan_.courses, k); }
  [[nodiscard]] Dice dice_for(int k, std::int64_t what, std::int64_t number) const {
    const auto [side, inner, pier] = line_of(wall_);
    return {rubble_.seed, {wall_.storey, side, inner, pier, k, what, number}};
  }

  std::vector<Cell> lay_course(int k) {
    std::vector<Cell> cells;
    for (const Interval span : free_spans(plan_, wall_, k, {0, wall_.thickness})) divide(k, span, cells);
    for (const Hole& hole : wall_.holes) {
      if (hole.floor < 0 || hole.depth.low == 0 || !hole.height.overlaps(course(k))) continue;
      cells.push_back({{hole.along.low, hole.along.low}, {hole.along.high, hole.along.high}, {0, hole.depth.low}, false});
    }
    std::ranges::sort(cells, {}, [](const Cell& c) { return c.low[0]; });
    below_.clear();
    for (const Cell& c : cells) below_.push_back(c.low[1]), below_.push_back(c.high[1]);
    std::ranges::sort(below_);
    return cells;
  }

  /// Divides a span by head joints at random positions, clear of the ends of joints of the course below.
  void divide(int k, Interval span, std::vector<Cell>& cells) const {
    const Tick length = plan_.brick_length, half = plan_.shortest_piece();
    Dice dice = dice_for(k, 1, span.low - wall_.from);
    std::array<Tick, 2> low{span.low, span.low};
    Tick at = span.low;
    while (2 * (span.high - at) > 3 * length) {
      const Interval room{at + half, std::min(at + thousandths(length, 1600), span.high - half)};
      const Tick wanted = at + length + dice.within(irregular(length, kLengths));
      const Tick joint = clear_of_below(std::clamp(wanted, room.low, room.high), room);
      const Tick lean = dice.within(irregular(course(k).length(), kLean));
      cells.push_back({low, {joint - lean, joint + lean}, {0, wall_.thickness}, true});
      low = cells.back().high;
      at = joint;
    }
    cells.push_back({low, {span.high, span.high}, {0, wall_.thickness}, true});
  }

  /// The position in `room` nearest to `wanted` and clear of all joints below; if there is none, the one farthest from them.
  [[nodiscard]] Tick clear_of_below(Tick wanted, Interval room) const {
    const Tick clear = thousandths(plan_.brick_length, kClear);
    const auto distance = [&](Tick place) {
      Tick least = std::numeric_limits<Tick>::max();
      for (const Tick joint : below_) least = std::min(least, std::abs(joint - place));
      return least;
    };
    std::vector<Tick> places{wanted, room.low, room.high};
    for (std::size_t i = 0; i < below_.size(); ++i) {
      places.push_back(below_[i] - clear), places.push_back(below_[i] + clear);
      if (i > 0) places.push_back((below_[i - 1] + below_[i]) / 2);
    }
    std::erase_if(places, [&](Tick p) { return p < room.low || p > room.high; });
    const auto worth = [&](Tick p) { return std::pair(std::min(distance(p), clear), -std::abs(p - wanted)); };
    return *std::ranges::max_element(places, {}, worth);
  }

  /// Whether a bed is level at a position: at meeting walls, and at holes that end at the bed or go through it.
  [[nodiscard]] bool is_level(int k, Tick along) const {
    if (k == first_ || k == end_) return true;
    const Interval near{course(k - 1).low, course(k).high};
    const auto in = [&](const auto& x) {
      return x.height.low <= near.high && x.height.high >= near.low && x.along.low <= along && along <= x.along.high;
    };
    const Tick z = course(k).low;
    const auto at_bed = [&](const Hole& h) { return in(h) && h.height.low <= z && h.height.high >= z; };
    const auto beside = [&](const Hole& h) { return in(h) && (h.height.overlaps(course(k - 1)) || h.height.overlaps(course(k))); };
    return std::ranges::any_of(wall_.crossings, in) || std::ranges::any_of(wall_.holes, at_bed) || std::ranges::any_of(wall_.holes, beside);
  }

  /// The bed under course k.
  [[nodiscard]] Bed make_bed(int k) const {
    Bed bed;
    if (k > first_)
      for (const Cell& c : nth(cells_, k - 1 - first_)) bed[c.low[1]].lower = bed[c.high[1]].lower = true;
    if (k < end_)
      for (const Cell& c : nth(cells_, k - first_)) bed[c.low[0]].upper = bed[c.high[0]].upper = true;
    const Tick level = k < end_ ? course(k).low : course(k - 1).high;
    for (auto& [along, vertex] : bed) vertex.height = level;
    Dice dice = dice_for(k, 3, 0);
    for (auto from = bed.begin(); from != bed.end();) {
      auto to = std::next(from);
      const bool both = from->second.lower && from->second.upper;
      while (!both && to != bed.end() && to->second.lower == from->second.lower && to->second.upper == from->second.upper) ++to;
      const double part = dice.share();
      if (!both) raise(k, bed, from, to, part);
      from = to;
    }
    return bed;
  }

  /// Moves a run of joints that end from one side, with none from the other side between them, to one height, so that stones stay convex.
  void raise(int k, Bed& bed, Bed::iterator from, Bed::iterator to, double part) const {
    if (from == bed.begin() || to == bed.end()) return;
    for (auto v = from; v != to; ++v)
      if (is_level(k, v->first)) return;
    const Tick gap = std::min(from->first - std::prev(from)->first, to->first - std::prev(to)->first);
    const Tick low = std::min(course(k - 1).length(), course(k).length());
    const Tick by = static_cast<Tick>(part * static_cast<double>(std::min(irregular(low, kBump), irregular(gap, kSlope))));
    for (auto v = from; v != to; ++v) v->second.height += v->second.upper ? by : -by;
  }

  [[nodiscard]] geometry::Polygon outline_of(int k, const Cell& c) const {
    const Bed &under = nth(beds_, k - first_), &over = nth(beds_, k + 1 - first_);
    std::vector<std::array<Tick, 2>> corners;
    for (auto v = under.find(c.low[0]); v != std::next(under.find(c.high[0])); ++v)
      if (v->first == c.low[0] || v->first == c.high[0] || v->second.lower) corners.push_back({v->first, v->second.height});
    const std::size_t top = corners.size();
    for (auto v = over.find(c.low[1]); v != std::next(over.find(c.high[1])); ++v)
      if (v->first == c.low[1] || v->first == c.high[1] || v->second.upper) corners.push_back({v->first, v->second.height});
    std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(top), corners.end());
    geometry::Polygon outline;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {  // without corners in the middle of a level edge
      const bool end = i == 0 || i + 1 == top || i == top || i + 1 == n;
      if (!end && corners[i - 1][1] == corners[i][1] && corners[i + 1][1] == corners[i][1]) continue;
      outline.push_back({metres(corners[i][0]), metres(corners[i][1])});
    }
    return outline;
  }

  /// Whether a stone goes through the wall: by chance; in a wall of two leaves only at the positions given by House::leaves.
  [[nodiscard]] bool goes_through(int k, const Cell& c, double chance) const {
    if (!c.whole) return false;
    if (wall_.leaf == 0) return chance < rubble_.through;
    if (!house_.leaves->through || k % house_.leaves->through->every != house_.leaves->through->every / 2) return false;
    const Tick spacing = ticks(house_.leaves->through->spacing), from = k / house_.leaves->through->every % 2 == 1 ? spacing : spacing / 2;
    const Tick low = c.low[0] + c.low[1], high = c.high[0] + c.high[1];  // twice the mean of the ends
    for (Tick at = from; 2 * at < high; at += spacing)
      if (2 * at >= low) return true;
    return false;
  }

  /// Ranges of stones side by side through the wall: no stone is deeper than three brick widths.
  [[nodiscard]] std::vector<Interval> layers(const Cell& c, bool through, Dice& dice) const {
    if (through) return {c.depth};
    std::vector<Interval> parts;
    const auto cut = [&](Interval whole) {
      const Tick count = std::max<Tick>(1, (whole.length() / plan_.brick_width + 2) / 2), each = whole.length() / count;
      Tick from = whole.low;
      for (Tick i = 1; i <= count; ++i) {
        const Tick joint = i == count ? whole.high : whole.low + i * each + dice.within(irregular(each, kDepths));
        parts.push_back({from, joint});
        from = joint;
      }
    };
    if (wall_.leaf > c.depth.low && wall_.leaf < c.depth.high) {
      cut({c.depth.low, wall_.leaf});
      cut({wall_.leaf, c.depth.high});
    } else {
      cut(c.depth);
    }
    return parts;
  }

  const House& house_;
  const HousePlan& plan_;
  const WallPlan& wall_;
  Rubble rubble_;
  Tick irregularity_ = 0;    // thousandths
  std::vector<Tick> below_;  // ends of the head joints of the course below, ascending
  int first_ = 0, end_ = 0;  // courses
  std::vector<std::vector<Cell>> cells_;
  std::vector<Bed> beds_;  // under each course, and at the top
};

}  // namespace

std::vector<Interval> rubble_courses(const House& house, const HousePlan& plan, Interval between, std::int64_t number) {
  constexpr Tick kMean = 1000000;  // weight of a course of mean height
  const Rubble rubble = rubble_of(house);
  const auto count = static_cast<Tick>(cut_member(between, plan.brick_height).size());
  const Tick least = count * plan.lowest_course();
  const Tick spread =
      std::min(ticks(rubble.irregularity) / 1000000 * kHeights, (between.length() - least) * kMean / (between.length() + least));
  Dice dice(rubble.seed, {-1, number});
  std::vector<Tick> tops;
  for (Tick i = 0; i < count; ++i) tops.push_back((tops.empty() ? 0 : tops.back()) + kMean + dice.within(spread));
  std::vector<Interval> courses;
  for (const Tick top : tops) {
    const Tick low = courses.empty() ? between.low : courses.back().high;
    courses.push_back({low, between.low + between.length() / 1000 * top / (tops.back() / 1000)});
  }
  courses.back().high = between.high;
  return courses;
}

RubbleWalls::RubbleWalls(const House& house, const HousePlan& plan) {
  std::map<std::tuple<int, std::int32_t, std::int32_t>, std::vector<Tick>> tops;
  for (const WallPlan& wall : plan.walls) {
    if (!wall.built) continue;
    WallMason mason(house, plan, wall, tops[line_of(wall)]);
    mason.lay();
    for (int k = mason.first(); k < mason.end(); ++k) stones_[{&wall, k}] = mason.stones(k);
    tops[line_of(wall)] = mason.top_joints();
  }
}

const std::vector<RubbleStone>& RubbleWalls::stones(const WallPlan& wall, int course) const {
  static const std::vector<RubbleStone> none;
  const auto found = stones_.find({&wall, course});
  return found == stones_.end() ? none : found->second;
}

}  // namespace voussoir::cases
