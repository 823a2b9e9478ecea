// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases/house/house_wall.h"
#include "cases/names.h"
#include "cases/walls/wall_meetings.h"

namespace voussoir::cases {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

/// An end of a span, and what it ends at: an opening, a meeting, or the free end of the leg.
struct Edge {
  Cut cut;
  std::size_t opening = kNobody, meeting = kNobody;
};

/// A part of a leg that a course fills from face to face.
struct Span {
  Edge low, high;
};

/// Whether a leg runs through the other one at a station in this course.
bool runs_through(const WallsPlan& plan, const Station& s, int course, Interval height) {
  const Meeting& m = plan.meetings[s.meeting];
  if (!plan.legs[s.host ? m.guest : m.host].height.overlaps(height)) return true;
  const bool turn_of_guest = m.toothed && course % 2 == 1 && (course / 2) % m.turns == m.turn;
  return s.host ? !turn_of_guest : turn_of_guest;
}

/// Between two places where a leg meets others: joints lie at origin + scale * (offset + unit * k).
struct Field {
  double low = 0.0, high = 0.0, origin = 0.0, scale = 1.0;
};

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

Field fitted(const WallSpec& wall, const HousePlan& bricks, const Fence& a, const Fence& b) {
  Field f{a.behind, b.before};
  const double before = phase(wall, bricks, a, 1.0), behind = phase(wall, bricks, b, -1.0), length = metres(bricks.brick_length);
  const double bricks_in_it = std::round((f.high - f.low) / length - before - behind) + before + behind;
  const double scale = bricks_in_it > 0.0 ? (f.high - f.low) / (bricks_in_it * length) : 0.0;
  if (scale >= 2.0 / 3.0 - 1e-9 && scale <= 4.0 / 3.0 + 1e-9) f.scale = scale;
  f.origin = f.low + before * f.scale * length;
  return f;
}

std::vector<Field> fields_of(const WallSpec& wall, const WallsPlan& plan, const Leg& leg) {
  const HousePlan& bricks = plan.bricks[leg.wall];
  if (leg.ring) {
    Field whole{-kInfinite, kInfinite};
    const double brick = metres(bricks.brick_length);
    whole.scale = leg.length() / (std::max(1.0, std::round(leg.length() / brick)) * brick);
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

/// The spans of a leg in a course: what its ends, other legs and openings leave.
std::vector<Span> spans_of(const WallsPlan& plan, const Leg& leg, int course, Interval height) {
  std::vector<Span> removed;
  Edge begin{{0.0, 0.0}}, end{{leg.length(), 0.0}};
  for (const Station& s : leg.stations) {
    const bool through = runs_through(plan, s, course, height);
    const Edge low{s.low, kNobody, s.meeting}, high{s.high, kNobody, s.meeting};
    if (s.end == LegEnd::low)
      begin = through ? low : high;
    else if (s.end == LegEnd::high)
      end = through ? high : low;
    else if (!through)
      removed.push_back({low, high});
  }
  for (const LegHole& h : leg.holes) {
    if (h.height.overlaps(height)) removed.push_back({{{h.low, 0.0}, h.opening}, {{h.high, 0.0}, h.opening}});
  }
  std::ranges::sort(removed, {}, [](const Span& r) { return r.low.cut.at; });
  if (leg.ring && !removed.empty()) {  // begins and ends at what is taken out first
    begin = removed.front().high, end = removed.front().low;
    end.cut.at += leg.length();
    removed.erase(removed.begin());
  }
  std::vector<Span> spans;
  const auto add = [&](const Edge& to) {
    if (longer_side(begin.cut, to.cut, leg.half) > kPlanTolerance) spans.push_back({begin, to});
  };
  for (const Span& r : removed) {
    add(r.low);
    if (longer_side(begin.cut, r.high.cut, leg.half) > kPlanTolerance) begin = r.high;
  }
  add(end);
  return spans;
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

class Layer {
 public:
  Layer(const WallSpec& wall, const Leg& leg, const std::vector<Field>& fields, const Wythe& wythe)
      : leg_(leg), fields_(fields), wythe_(wythe), low_(metres(wythe.depth.low) - leg.half), high_(metres(wythe.depth.high) - leg.half) {
    unit_ = metres(wythe.unit);
    for (const Field& f : fields) longest_ = std::max(longest_, unit_ * f.scale);
    if (fields.empty()) longest_ = unit_;
    least_ = std::max(unit_ / 3.0, least_piece(wall));
  }

  void lay(const Span& span, std::vector<PlanBrick>& bricks) const {
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
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const Cut low = i == 0 ? a : Cut{bounds[i]}, high = i + 2 == bounds.size() ? b : Cut{bounds[i + 1]};
      bricks.push_back({{leg_.at(low(low_), low_), leg_.at(high(low_), low_), leg_.at(high(high_), high_), leg_.at(low(high_), high_)},
                        is_whole(low, high)});
    }
  }

 private:
  [[nodiscard]] bool is_whole(const Cut& low, const Cut& high) const {
    if (low.slope != 0.0 || high.slope != 0.0) return false;
    const double length = high.at - low.at;
    return std::ranges::any_of(fields_, [&](const Field& f) {
      return low.at > f.low - kPlanTolerance && high.at < f.high + kPlanTolerance && std::abs(length - unit_ * f.scale) < kPlanTolerance;
    });
  }

  const Leg& leg_;
  const std::vector<Field>& fields_;
  const Wythe& wythe_;
  double low_, high_;                                // m, d of its faces
  double unit_ = 0.0, longest_ = 0.0, least_ = 0.0;  // m
};

std::string cause(const WallsPlan& plan, const Leg& leg, const Edge& e) {
  if (e.opening != kNobody) return "opening " + std::to_string(e.opening + 1);
  if (e.meeting == kNobody) return "the free end";
  const Meeting& m = plan.meetings[e.meeting];
  return "the " + plan.legs[&plan.legs[m.host] == &leg ? m.guest : m.host].tag;
}

void check_spans(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, const std::vector<Span>& spans, Faults& faults) {
  const double least = least_piece(wall);
  for (const Span& s : spans) {
    const double side = shorter_side(s.low.cut, s.high.cut, leg.half);
    if (side >= least - kPlanTolerance) continue;
    const std::size_t opening = s.high.opening != kNobody ? s.high.opening : s.low.opening;
    const std::string key = opening == kNobody ? wall_key(leg.wall, "points") : indexed_key(wall_key(leg.wall, "opening"), opening, "from");
    faults.add({key, "leaves a piece of the " + leg.tag + " between " + cause(plan, leg, s.low) + " and " + cause(plan, leg, s.high) + " " +
                         (side > 0.0 ? text(std::round(side * 1e4) * 1e-4) + " m long" : "whose faces cross") + "; at least " +
                         text(least) + " m, a fifth of a brick"});
  }
}

void check_bricks(const WallSpec& wall, const Leg& leg, const std::vector<PlanBrick>& bricks, Faults& faults) {
  const double least = 0.5 * least_piece(wall);
  for (const PlanBrick& b : bricks) {
    const Vec3 right = b.corners[1] - b.corners[0], left = b.corners[2] - b.corners[3];
    const Vec3 along = normalised(right + left);
    if (dot(right, along) > least && dot(left, along) > least) continue;
    faults.add(
        {wall_key(leg.wall, "points"), "bends too sharply for a wall " + text(wall.thickness) +
                                           " m thick: a block would be shorter than a tenth of a brick on one face; give points that "
                                           "are nearer, or a longer brick"});
    return;
  }
}

}  // namespace

std::vector<PlanBrick> lay_wall_course(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, int course) {
  const Interval height = plan.courses[plan.group[leg.wall]][static_cast<std::size_t>(course)];
  const std::vector<Field> fields = fields_of(wall, plan, leg);
  const std::vector<Span> spans = spans_of(plan, leg, course, height);
  std::vector<PlanBrick> bricks;
  for (const Wythe& wythe : wythes_of(wall, plan.bricks[leg.wall], course)) {
    const Layer layer(wall, leg, fields, wythe);
    const bool whole_ring = leg.ring && spans.size() == 1 && spans[0].low.opening == kNobody && spans[0].low.meeting == kNobody;
    if (!whole_ring) {
      for (const Span& s : spans) layer.lay(s, bricks);
      continue;
    }
    const double seam = fields[0].scale * metres(wythe.offset);
    layer.lay({{{seam, 0.0}}, {{seam + leg.length(), 0.0}}}, bricks);
  }
  return bricks;
}

std::array<double, 2> brick_stretch(const WallSpec& wall, const WallsPlan& plan, const Leg& leg) {
  std::array<double, 2> range{1.0, 1.0};
  for (const Field& f : fields_of(wall, plan, leg)) range = {std::min(range[0], f.scale), std::max(range[1], f.scale)};
  return range;
}

void check_layout(const std::vector<WallSpec>& walls, const WallsPlan& plan) {
  Faults faults;
  for (const Leg& leg : plan.legs) {
    const WallSpec& wall = walls[leg.wall];
    const Courses& courses = plan.courses[plan.group[leg.wall]];
    for (std::size_t c = 0; c < courses.size(); ++c) {
      if (!leg.height.overlaps(courses[c])) continue;
      const std::size_t known = faults.count();
      check_spans(wall, plan, leg, spans_of(plan, leg, static_cast<int>(c), courses[c]), faults);
      if (faults.count() == known) check_bricks(wall, leg, lay_wall_course(wall, plan, leg, static_cast<int>(c)), faults);
    }
  }
  faults.raise();
}

}  // namespace voussoir::cases
