// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/wall_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/names.h"
#include "cases/walls/wall_layer.h"
#include "cases/walls/wall_meetings.h"
#include "cases/walls/wall_pockets.h"

namespace voussoir::cases {
namespace {

constexpr double kLeastShare = 0.2;  // of a brick that is cut along its top

/// Whether a leg runs through the other one at a station in this course.
bool runs_through(const WallsPlan& plan, const Station& s, int course, Interval height) {
  const Meeting& m = plan.meetings[s.meeting];
  if (!height_there(plan, s).overlaps(height)) return true;
  const bool turn_of_guest = m.toothed && course % 2 == 1 && (course / 2) % m.turns == m.turn;
  return s.host ? !turn_of_guest : turn_of_guest;
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

std::string cause(const WallsPlan& plan, const Leg& leg, const Edge& e) {
  if (e.opening != kNobody) return "opening " + std::to_string(e.opening + 1);
  if (e.floor != kNobody) return "a beam of " + indexed_key("floor", e.floor, "");
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
    const std::size_t floor = s.high.floor != kNobody ? s.high.floor : s.low.floor;
    const std::string key = floor != kNobody     ? indexed_key("floor", floor, "spacing")
                            : opening == kNobody ? wall_key(leg.wall, "points")
                                                 : indexed_key(wall_key(leg.wall, "opening"), opening, "from");
    faults.add({key, "leaves a piece of the " + leg.tag + " between " + cause(plan, leg, s.low) + " and " + cause(plan, leg, s.high) + " " +
                         (side > 0.0 ? text(std::round(side * 1e4) * 1e-4) + " m long" : "whose faces cross") + "; at least " +
                         text(least) + " m, a fifth of a brick" +
                         (floor == kNobody ? "" : "; beams of two floors lie opposite each other, or as far apart")});
  }
}

void check_bricks(const WallSpec& wall, const Leg& leg, const std::vector<PlanBrick>& bricks, Faults& faults) {
  const double least = 0.5 * least_piece(wall);
  for (const PlanBrick& b : bricks) {
    if (b.shape && b.share >= kLeastShare) continue;
    if (b.shape) {
      faults.add({leg.hills.front().key, "leaves a brick of the " + leg.tag + " at " + metres_text(b.height.low) +
                                             " m above the base of which the top cuts all but " + text(std::round(1e3 * b.share) * 0.1) +
                                             " %; at least a fifth: walls that meet it there are in the way; move or lower them"});
      continue;
    }
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

/// Parts spans where beams lie in a layer.
std::vector<Span> parted(const std::vector<Span>& spans, const std::vector<FilledPlace>& beams) {
  std::vector<Span> all;
  for (Span rest : spans) {
    for (const FilledPlace& b : beams) {
      if (b.low.at < rest.low.cut.at - kPlanTolerance || b.high.at > rest.high.cut.at + kPlanTolerance) continue;
      if (b.low.at > rest.low.cut.at + kPlanTolerance || b.low.slope != rest.low.cut.slope)
        all.push_back({rest.low, {b.low, kNobody, kNobody, b.floor}});
      rest.low = {b.high, kNobody, kNobody, b.floor};
    }
    all.push_back(rest);
  }
  return all;
}

/// The bricks beside beams in a layer.
void fill_beside(const Leg& leg, Interval height, const std::vector<FilledPlace>& beams, std::vector<PlanBrick>& bricks) {
  for (const FilledPlace& b : beams) {
    for (const auto& [from, to] : b.rest)
      bricks.push_back(
          {{leg.at(b.low(from), from), leg.at(b.high(from), from), leg.at(b.high(to), to), leg.at(b.low(to), to)}, false, height, {}});
  }
}

/// Checks beams of several floors in a layer against each other: apart, opposite each other, or far enough beside that. Tells the first
/// fault.
void check_each_other(const std::vector<FilledPlace>& beams, double least, const Leg& leg, Faults& faults) {
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const FilledPlace& b = beams[i];
    const FilledPlace* next = i + 1 < beams.size() && beams[i + 1].low.at < b.high.at + kPlanTolerance ? &beams[i + 1] : nullptr;
    const FilledPlace* last = i > 0 && beams[i - 1].high.at > b.low.at - kPlanTolerance ? &beams[i - 1] : nullptr;
    if (next == nullptr && last == nullptr && !b.crossed) continue;
    std::size_t later = b.floor, other = b.other;
    for (const FilledPlace* beside : {next, last})
      if (beside != nullptr) later = std::max(later, beside->floor), other = std::min(other, beside->other);
    const std::string place = " m of the " + leg.tag + ", where " + indexed_key("floor", other, "") + " has them";
    const auto at = [&](double s) { return text(std::round(leg.place(s) * 1e4) * 1e-4); };
    if (b.crossed)
      return faults.add(
          {indexed_key("floor", later, "corners"), "puts beams across those from " + at(b.low.at) + " to " + at(b.high.at) + place});
    if (b.high.at - b.low.at < least - kPlanTolerance)
      return faults.add({indexed_key("floor", later, "spacing"), "puts beams beside those at " + at(b.low.at) + place + ", with " +
                                                                     at(b.high.at - b.low.at) +
                                                                     " m between their sides; none, or at least " + text(least) +
                                                                     " m, a fifth of a brick: change spacing or corners"});
  }
}

/// Checks the bricks between beams and behind them.
void check_beside(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, int course, Interval height, Faults& faults) {
  if (std::ranges::none_of(leg.pockets, [&](const Pocket& p) { return p.height.overlaps(height); })) return;
  const double least = least_piece(wall);
  const std::vector<Span> spans = spans_of(plan, leg, course, height);
  for (const Wythe& wythe : wythes_of(wall, plan.bricks[leg.wall], course)) {
    const std::vector<FilledPlace> beams =
        beams_in_layer(leg, height, metres(wythe.depth.low) - leg.half, metres(wythe.depth.high) - leg.half);
    check_spans(wall, plan, leg, parted(spans, beams), faults);
    check_each_other(beams, least, leg, faults);
    for (const FilledPlace& b : beams) {
      for (const auto& [from, to] : b.rest) {
        if (to - from < least - kPlanTolerance)
          faults.add({indexed_key("floor", b.floor, "bearing"), "leaves bricks of " + text(std::round((to - from) * 1e4) * 1e-4) +
                                                                    " m behind the beams in the " + leg.tag + "; at least " + text(least) +
                                                                    " m, a fifth of a brick, or none"});
      }
    }
  }
}

}  // namespace

geometry::Polyhedron across(const Leg& leg, const geometry::Polygon& section, double from, double to) {
  std::vector<std::array<double, 2>> corners;
  for (const geometry::Point2 p : section) corners.push_back({p.s, p.t});
  geometry::Polyhedron shape = geometry::make_prism(corners, -to, -from);
  for (Vec3& v : shape.vertices) {
    const Vec3 plan = leg.at(v.y, -v.x);
    v = {plan.x, plan.y, v.z};
  }
  return shape;
}

geometry::Polyhedron upright(const std::array<Vec3, 4>& plan, Interval height) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {plan[i].x, plan[i].y, metres(height.low)};
    corners[i + 4] = {plan[i].x, plan[i].y, metres(height.high)};
  }
  return geometry::make_hexahedron(corners);
}

std::vector<PlanBrick> lay_wall_course(const WallSpec& wall, const WallsPlan& plan, const Leg& leg, int course) {
  const Interval height = plan.courses[plan.group[leg.wall]][static_cast<std::size_t>(course)];
  const std::vector<Field> fields = fields_of(wall, plan, leg);
  const std::vector<Span> spans = spans_of(plan, leg, course, height);
  std::vector<PlanBrick> bricks;
  for (const Wythe& wythe : wythes_of(wall, plan.bricks[leg.wall], course)) {
    const Layer layer(wall, leg, fields, wythe, height);
    if (height.low >= leg.eaves) {
      for (const Span& s : spans) layer.lay_in_hills(s, bricks);
      continue;
    }
    const bool whole_ring = leg.ring && spans.size() == 1 && spans[0].low.opening == kNobody && spans[0].low.meeting == kNobody;
    if (!whole_ring) {
      const std::vector<FilledPlace> beams =
          beams_in_layer(leg, height, metres(wythe.depth.low) - leg.half, metres(wythe.depth.high) - leg.half);
      for (const Span& s : parted(spans, beams)) layer.lay(s, bricks);
      fill_beside(leg, height, beams, bricks);
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

double lost_in_bends(const WallSpec& wall, const WallsPlan& plan, const Leg& leg) {
  if (leg.facets.size() < 2) return 0.0;
  const Courses& courses = plan.courses[plan.group[leg.wall]];
  double line = 0.0, laid = 0.0;
  for (int c = 0; c < std::min(2, static_cast<int>(courses.size())); ++c) {
    const Interval height = courses[static_cast<std::size_t>(c)];
    if (!leg.height.overlaps(height)) continue;
    for (const Span& s : spans_of(plan, leg, c, height)) line += (s.high.cut.at - s.low.cut.at) * wall.thickness;
    for (const PlanBrick& b : lay_wall_course(wall, plan, leg, c))
      laid += 0.5 * norm(cross(b.corners[2] - b.corners[0], b.corners[3] - b.corners[1]));
  }
  return line > 0.0 ? 1.0 - laid / line : 0.0;
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
      if (faults.count() == known) check_beside(wall, plan, leg, static_cast<int>(c), courses[c], faults);
      if (faults.count() == known) check_bricks(wall, leg, lay_wall_course(wall, plan, leg, static_cast<int>(c)), faults);
    }
  }
  faults.raise();
}

}  // namespace voussoir::cases
