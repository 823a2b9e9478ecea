// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/solids/pieces.h"

namespace voussoir::cases {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kFar = 1e5;         // m, beyond any wall
constexpr double kNoSection = 1e-9;  // m2

/// An end of a field: a plane at which the leg ends in courses of one parity, in the middle of a brick in the others; or a free end.
struct Fence {
  double before = 0.0, behind = 0.0;  // m: ends of the fields on its two sides
  int through = -1;                   // parity of the courses in which the leg runs through; −1: it does in none
};

/// The share of a brick's length from a plane to the origin of the grid. \param sign  1: the field lies behind the plane, −1: before it
double phase(const WallSpec& wall, const HousePlan& bricks, const Fence& fence, double sign) {
  if (fence.through < 0) return 0.0;
  const Wythe w = wythes_of(wall, bricks, fence.through)[0];
  const double share =
      (0.5 * static_cast<double>(w.unit) - sign * static_cast<double>(w.offset)) / static_cast<double>(bricks.brick_length);
  return share - std::floor(share);
}

/// The nearest whole number; the upper one within round-off of the middle between two, so that the place of a wall does not decide.
double nearest(double bricks) { return std::floor(bricks + 0.5 + 1e-6); }

Field fitted(const WallSpec& wall, const HousePlan& bricks, const Fence& a, const Fence& b) {
  Field f{a.behind, b.before};
  const double before = phase(wall, bricks, a, 1.0), behind = phase(wall, bricks, b, -1.0), length = metres(bricks.brick_length);
  const double bricks_in_it = nearest((f.high - f.low) / length - before - behind) + before + behind;
  const double scale = bricks_in_it > 0.0 ? (f.high - f.low) / (bricks_in_it * length) : 0.0;
  if (scale >= 2.0 / 3.0 - 1e-9 && scale <= 4.0 / 3.0 + 1e-9) f.scale = scale;
  f.origin = f.low + before * f.scale * length;
  return f;
}

/// Head joints of a layer, ascending.
std::vector<double> head_joints(const std::vector<Field>& fields, const Wythe& wythe, Span span, double half) {
  const double unit = metres(wythe.unit), offset = metres(wythe.offset);
  const double from = std::min(span.low.cut(half), span.low.cut(-half)), to = std::max(span.high.cut(half), span.high.cut(-half));
  std::vector<double> joints;
  for (const Field& f : fields) {
    const double low = std::max(from, f.low), high = std::min(to, f.high), step = unit * f.scale, first = f.origin + f.scale * offset;
    for (double k = std::ceil((low - first) / step - 1e-6); first + k * step < high - kPlanTolerance; k += 1.0) {
      if (first + k * step > low + kPlanTolerance) joints.push_back(first + k * step);
    }
  }
  return joints;
}

/// Parts a length that is more than a third too long for a unit into equal pieces.
void part_long(std::vector<double>& bounds, double unit) {
  std::vector<double> all{bounds.front()};
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double from = bounds[i - 1], n = std::ceil((bounds[i] - from) / (4.0 / 3.0 * unit) - 1e-6);
    for (double k = 1.0; k < n; k += 1.0) all.push_back(from + (bounds[i] - from) * k / n);
    all.push_back(bounds[i]);
  }
  bounds = std::move(all);
}

}  // namespace

std::vector<Field> fields_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg) {
  const HousePlan& bricks = plan.bricks[leg.wall];
  if (leg.ring) {
    Field whole{-kInfinite, kInfinite};
    const double brick = metres(bricks.brick_length);
    whole.scale = leg.length() / (std::max(1.0, nearest(leg.length() / brick)) * brick);
    return {whole};
  }
  std::vector<Fence> fences;
  if (leg.end(LegEnd::low) == nullptr) fences.push_back({});
  for (const Station& s : leg.stations) {
    const bool toothed = plan.meetings[s.meeting].toothed;
    if (!toothed && s.host && s.end == LegEnd::none) continue;  // the other leg leaves no trace
    Fence f{s.low.at, s.high.at, toothed ? (s.host ? 0 : 1) : -1};
    if (!toothed && s.host) std::swap(f.before, f.behind);
    fences.push_back(f);
  }
  if (leg.end(LegEnd::high) == nullptr) fences.push_back({leg.length(), leg.length()});
  std::vector<Field> fields;
  for (std::size_t i = 0; i + 1 < fences.size(); ++i) {
    if (fences[i + 1].before > fences[i].behind + kPlanTolerance) fields.push_back(fitted(wall, bricks, fences[i], fences[i + 1]));
  }
  return fields;
}

Layer::Layer(const WallSpec& wall, const Leg& leg, const std::vector<Field>& fields, const Wythe& wythe, Interval course)
    : leg_(leg),
      fields_(fields),
      wythe_(wythe),
      course_(course),
      low_(metres(wythe.depth.low) - leg.half),
      high_(metres(wythe.depth.high) - leg.half) {
  unit_ = metres(wythe.unit);
  for (const Field& f : fields) longest_ = std::max(longest_, unit_ * f.scale);
  if (fields.empty()) longest_ = unit_;
  least_ = std::max(unit_ / 3.0, least_piece(wall));
}

void Layer::lay(const Span& span, std::vector<PlanBrick>& bricks) const {
  const std::vector<double> all = bounds(span);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) add(span, all, i, bricks);
}

void Layer::lay_in_hills(const Span& span, std::vector<PlanBrick>& bricks) const {
  const std::vector<double> all = bounds(span);
  for (const Hill& hill : leg_.hills) {
    if (course_.low > hill.last) continue;
    const double low = metres(course_.low), high = course_.low == hill.last ? hill.crown : metres(course_.high);
    const geometry::Polygon section = part_between(hill.under, low, high, -kFar, kFar);
    std::vector<CutBrick> cut;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      CutBrick brick{std::max(all[i], hill.from), std::min(all[i + 1], hill.to), {}, 0.0};
      if (brick.high < brick.low + kPlanTolerance) continue;
      cut_brick(section, brick);
      if (brick.area > kNoSection) cut.push_back(std::move(brick));
    }
    const double whole = unit_ * metres(course_.length());
    join_small(section, 0.5 * whole, cut);
    for (const CutBrick& brick : cut) add_cut(span, {all.front(), all.back()}, brick, {low, high}, whole, bricks);
  }
}

std::vector<double> Layer::bounds(const Span& span) const {
  const auto &a = span.low.cut, &b = span.high.cut;
  const double middle = 0.5 * (low_ + high_), from = std::max(a(low_), a(high_)), to = std::min(b(low_), b(high_));
  std::vector<double> bounds{a(middle)};
  const std::vector<double> joints = head_joints(fields_, wythe_, span, leg_.half);
  for (const double j : joints) {
    if (j > from + least_ - kPlanTolerance && j < to - least_ + kPlanTolerance) bounds.push_back(j);
  }
  bounds.push_back(b(middle));
  part_long(bounds, longest_);
  const auto too_near = [&](double j) { return j < from + least_ - kPlanTolerance || j > to - least_ + kPlanTolerance; };
  bounds.erase(std::remove_if(bounds.begin() + 1, bounds.end() - 1, too_near), bounds.end() - 1);
  return bounds;
}

std::array<Vec3, 4> Layer::corners(const LegCut& low, const LegCut& high) const {
  return {leg_.at(low(low_), low_), leg_.at(high(low_), low_), leg_.at(high(high_), high_), leg_.at(low(high_), high_)};
}

void Layer::add(const Span& span, const std::vector<double>& bounds, std::size_t i, std::vector<PlanBrick>& bricks) const {
  const LegCut low = i == 0 ? span.low.cut : LegCut{bounds[i]}, high = i + 2 == bounds.size() ? span.high.cut : LegCut{bounds[i + 1]};
  bricks.push_back({corners(low, high), is_whole(low, high), course_, {}});
  bricks.back().length = whole_length(0.5 * (low.at + high.at));
}

void Layer::add_cut(const Span& span, std::array<double, 2> ends, const CutBrick& brick, std::array<double, 2> height, double whole,
                    std::vector<PlanBrick>& bricks) const {
  const LegCut low = brick.low == ends[0] ? span.low.cut : LegCut{brick.low};
  const LegCut high = brick.high == ends[1] ? span.high.cut : LegCut{brick.high};
  PlanBrick b{corners(low, high), false, {ticks(height[0]), ticks(height[1])}, {}, brick.area / whole};
  const bool is_cut = brick.area < (brick.high - brick.low) * (height[1] - height[0]) * (1.0 - 1e-9);
  if (is_cut) b.shape = low.slope == 0.0 && high.slope == 0.0 ? across(leg_, brick.section, low_, high_) : under(brick, b);
  b.whole = !is_cut && is_whole(low, high);
  b.length = whole_length(0.5 * (low.at + high.at));
  bricks.push_back(std::move(b));
}

geometry::Polyhedron Layer::under(const CutBrick& brick, const PlanBrick& plan) const {
  geometry::Polyhedron shape = upright(plan.corners, plan.height);
  const Facet& f = leg_.facets[0];
  for (std::size_t i = 0; i < brick.section.size(); ++i) {
    const geometry::Point2 p = brick.section[i], q = brick.section[(i + 1) % brick.section.size()];
    if (q.s > p.s - kPlanTolerance) continue;  // counter-clockwise: the top runs back
    const Vec3 normal = normalised((q.t - p.t) * f.along + Vec3{0.0, 0.0, p.s - q.s});
    const Vec3 at = f.from + (p.s - f.start) * f.along + Vec3{0, 0, p.t};
    shape = geometry::clipped(shape, {normal, dot(normal, at)}, 1e-9);
  }
  return shape;
}

double Layer::whole_length(double s) const {
  double longest = 0.0;
  for (const Field& f : fields_)
    if (s > f.low - kPlanTolerance && s < f.high + kPlanTolerance) longest = std::max(longest, unit_ * f.scale);
  return longest > 0.0 ? longest : unit_;
}

bool Layer::is_whole(const LegCut& low, const LegCut& high) const {
  if (std::max(std::abs(low.slope), std::abs(high.slope)) * leg_.half > kPlanTolerance) return false;
  const double length = high.at - low.at;
  return std::ranges::any_of(fields_, [&](const Field& f) {
    return low.at > f.low - kPlanTolerance && high.at < f.high + kPlanTolerance && std::abs(length - unit_ * f.scale) < kPlanTolerance;
  });
}

}  // namespace voussoir::cases
