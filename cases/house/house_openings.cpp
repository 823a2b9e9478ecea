// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/house_openings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>

#include "cases/house/floors/house_floors.h"
#include "cases/house/house_courses.h"
#include "cases/house/house_wall.h"
#include "cases/house/walls/arches.h"
#include "cases/house/walls/ground.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

std::string opening_key(std::size_t opening, const char* field = "") { return indexed_key("house.opening", opening, field); }

WallPlan& wall_of(const House& house, std::size_t index, HousePlan& plan) {
  const Opening& opening = house.openings[index];
  const int storeys = static_cast<int>(plan.storeys.size());
  if (opening.storey < 1 || opening.storey > storeys)
    throw InputError(opening_key(index, "storey"),
                     "there is no storey " + std::to_string(opening.storey) + "; allowed: 1 to " + std::to_string(storeys));
  for (WallPlan& wall : plan.walls) {
    if (wall.storey != opening.storey - 1 || opening.wall + " wall" != wall_name(house, wall)) continue;
    if (!wall.built) throw InputError(opening_key(index, "wall"), quoted(opening.wall) + " is not built; see house.walls");
    return wall;
  }
  std::vector<std::string> names{"front", "rear", "left", "right"};
  for (const WallPlan& wall : plan.walls) {
    if (wall.inner >= 0 && wall.storey == opening.storey - 1) names.push_back(nth(house.inner_walls, wall.inner).name);
  }
  std::string allowed;
  for (const std::string& name : names) allowed += (allowed.empty() ? "" : ", ") + name;
  throw InputError(opening_key(index, "wall"), quoted(opening.wall) + " is no wall" +
                                                   (storeys > 1 ? " of storey " + std::to_string(opening.storey) : "") + "; " +
                                                   did_you_mean(opening.wall, names) + "allowed: " + allowed);
}

/// The range of a wall in which a hole may lie: between the inner corners, since the meeting wall has every second course of the corner.
Interval between_corners(const WallPlan& wall) { return {wall.corner, wall.length - wall.corner}; }

/// Refuses a hole at inner walls that end in this wall or cross it, and at piers: they run through in every second course.
void refuse_crossing(const House& house, const Hole& hole, const char* field, double value, const WallPlan& wall, const HousePlan& plan) {
  for (const WallPlan& other : plan.walls) {
    const bool here = other.inner >= 0 || (other.pier >= 0 && wall.outer() && other.side == wall.side);
    if (!here || other.storey != wall.storey || other.along_x == wall.along_x) continue;
    const Interval crossing{other.at, other.at + other.thickness};
    if (!hole.along.overlaps(crossing)) continue;
    throw InputError(opening_key(hole.opening, field), text(value) + " m puts the " +
                                                           (hole.lintel ? "lintel"
                                                            : hole.arch ? "arch"
                                                                        : "opening") +
                                                           " (" + from_to(hole.along) + ") where the " + wall_name(house, other) +
                                                           " meets the " + wall_name(house, wall) + ", " + from_to(crossing));
  }
}

Interval along_of(const House& house, std::size_t index, const HousePlan& plan, const WallPlan& wall) {
  const Opening& opening = house.openings[index];
  const Interval room = between_corners(wall);
  const Tick width = positive_length(opening.width, opening_key(index, "width"));
  if (width > room.length()) {
    throw InputError(opening_key(index, "width"), text(opening.width) + " m is wider than the " + wall_name(house, wall) +
                                                      " between its corners (" + metres_text(room.length()) + " m)");
  }
  const Tick from = std::isfinite(opening.from) && std::abs(opening.from) < 1e4 ? ticks(opening.from) : Tick{-1};
  const Interval along{from, from + width};
  if (along.low < room.low || along.high > room.high) {
    throw InputError(opening_key(index, "from"), text(opening.from) + " m puts the opening outside the " + wall_name(house, wall) +
                                                     ", whose inner corners are at " + metres_text(room.low) + " and " +
                                                     metres_text(room.high) + " m; allowed: " + metres_text(room.low) + " to " +
                                                     metres_text(room.high - width) + " m");
  }
  refuse_crossing(house, {along, {}, index, false}, "from", opening.from, wall, plan);
  return along;
}

Interval height_of(const House& house, std::size_t index, const WallPlan& wall) {
  const Opening& opening = house.openings[index];
  const Tick sill = opening.sill == 0.0 ? 0 : positive_length(opening.sill, opening_key(index, "sill"));
  const Tick height = positive_length(opening.height, opening_key(index, "height"));
  const Tick top = wall.height.length();
  if (sill >= top) {
    throw InputError(opening_key(index, "sill"), text(opening.sill) + " m is not below the top of the wall (" + metres_text(top) + " m)");
  }
  if (sill + height > top) {
    throw InputError(opening_key(index, "height"), text(opening.height) + " m above a sill at " + text(opening.sill) +
                                                       " m is over the height of the wall (" + metres_text(top) + " m); at most " +
                                                       metres_text(top - sill) + " m");
  }
  return {wall.height.low + sill, wall.height.low + sill + height};
}

/// Range of a lintel, centred on the opening.
Interval lintel_span(const Opening& opening) noexcept {
  const Tick from = ticks(opening.from);
  const Tick length = ticks(opening.lintel->length);
  const Tick low = from - (length - ticks(opening.width)) / 2;
  return {low, low + length};
}

Hole lintel_hole(const House& house, const Hole& under, const HousePlan& plan, const WallPlan& wall) {
  const std::size_t index = under.opening;
  const Opening& opening = house.openings[index];
  const Lintel& lintel = *opening.lintel;
  const Interval room = between_corners(wall);
  const Tick length = positive_length(lintel.length, opening_key(index, "lintel.length"));
  const Tick height = positive_length(lintel.height, opening_key(index, "lintel.height"));
  element_length(lintel.element, length, opening_key(index, "lintel.element"));
  if (length > room.length()) {
    throw InputError(opening_key(index, "lintel.length"), text(lintel.length) + " m is longer than the " + wall_name(house, wall) +
                                                              " between its corners (" + metres_text(room.length()) + " m)");
  }
  if (length <= under.along.length()) {
    throw InputError(opening_key(index, "lintel.length"),
                     text(lintel.length) + " m finds no support beside the opening; more than its width, " + text(opening.width) + " m");
  }
  if (under.height.high + height > wall.height.high) {
    throw InputError(opening_key(index, "lintel.height"),
                     text(lintel.height) + " m above the opening (top at " + metres_text(under.height.high - wall.height.low) +
                         " m) is over the height of the wall (" + metres_text(wall.height.length()) + " m)");
  }
  const Interval along = lintel_span(opening);
  if (along.low < room.low || along.high > room.high) {
    const Tick spare = std::min(under.along.low - room.low, room.high - under.along.high);
    throw InputError(opening_key(index, "lintel.length"), text(lintel.length) + " m makes the lintel reach " + from_to(along) +
                                                              ", into a corner of the " + wall_name(house, wall) + " (inner corners at " +
                                                              metres_text(room.low) + " and " + metres_text(room.high) + " m); at most " +
                                                              metres_text(under.along.length() + 2 * spare) + " m here");
  }
  refuse_crossing(house, {along, {}, index, true}, "lintel.length", lintel.length, wall, plan);
  return {along, {under.height.high, under.height.high + height}, index, true, {0, wall.thickness}};
}

/// The frame of an arch, checked to lie between the corners of its wall and clear of other walls.
Hole frame_of_arch(const House& house, const Hole& under, const HousePlan& plan, const WallPlan& wall) {
  const Hole hole = arch_hole(house, under, plan, wall);
  const Interval room = between_corners(wall);
  const double springer = house.openings[under.opening].arch->springer;
  if (hole.along.low < room.low || hole.along.high > room.high) {
    const Tick spare = std::min(under.along.low - room.low, room.high - under.along.high);
    throw InputError(opening_key(under.opening, "arch.springer"),
                     text(springer) + " m makes the arch reach " + from_to(hole.along) + ", into a corner of the " +
                         wall_name(house, wall) + " (inner corners at " + metres_text(room.low) + " and " + metres_text(room.high) +
                         " m); at most " + metres_text(spare) + " m here");
  }
  refuse_crossing(house, hole, "arch.springer", springer, wall, plan);
  return hole;
}

/// What to do about an opening that goes down to the ground where a part of the base lies.
std::string way_round_ground(const Hole& a, const Hole& b) {
  const Hole &ground = a.ground >= 0 ? a : b, &opening = a.ground >= 0 ? b : a;
  if (ground.ground < 0 || opening.ground >= 0) return {};
  return "; end " + hole_key(ground) + " beside the opening (leave the doorway out), or give the opening a sill of at least " +
         metres_text(ground.height.length()) + " m";
}

void add_hole(const House& house, const Hole& hole, WallPlan& wall) {
  for (const Hole& other : wall.holes) {
    if (!hole.along.overlaps(other.along) || !hole.height.overlaps(other.height)) continue;
    throw InputError(hole_key(hole), "overlaps " + hole_key(other) + " in the " + wall_name(house, wall) + ": " + from_to(hole.along) +
                                         " (heights " + from_to(hole.height) + ") against " + from_to(other.along) + " (heights " +
                                         from_to(other.height) + ")" + way_round_ground(hole, other));
  }
  wall.holes.push_back(hole);
}

/// Whether an inner wall of the case has the name, and so an opening in it is not at fault if the wall could not be laid out.
bool names_inner_wall(const House& house, const std::string& wall) {
  return std::ranges::any_of(house.inner_walls, [&](const InnerWall& inner) { return inner.name == wall; });
}

void add_opening(const House& house, std::size_t index, HousePlan& plan) {
  const Opening& opening = house.openings[index];
  WallPlan* wall = nullptr;
  Interval along, height;
  Faults no_wall;
  if (!no_wall.attempt([&] { wall = &wall_of(house, index, plan); })) {
    if (!plan.faults.any() || !names_inner_wall(house, opening.wall)) no_wall.raise();
    return;
  }
  const bool stands = plan.faults.attempt([&] { height = height_of(house, index, *wall); });
  plan.opening_stands[index] = stands;
  if (!plan.faults.attempt([&] { along = along_of(house, index, plan, *wall); }) || !stands) return;
  const Hole hole{along, height, index, false, {0, wall->thickness}};
  add_hole(house, hole, *wall);
  if (opening.lintel) {
    const auto lintel = [&] { add_hole(house, lintel_hole(house, hole, plan, *wall), *wall); };
    plan.opening_stands[index] = plan.faults.attempt(lintel);
  }
  if (opening.arch) {
    const auto arch = [&] { add_hole(house, frame_of_arch(house, hole, plan, *wall), *wall); };
    plan.opening_stands[index] = plan.faults.attempt(arch) && plan.opening_stands[index];
  }
}

void add_holes(const House& house, HousePlan& plan) {
  plan.faults.attempt([&] { add_ground_holes(house, plan); });
  plan.opening_stands.assign(house.openings.size(), false);
  for (std::size_t i = 0; i < house.openings.size(); ++i) plan.faults.attempt([&] { add_opening(house, i, plan); });
  for (WallPlan& wall : plan.walls) {
    std::sort(wall.holes.begin(), wall.holes.end(), [](const Hole& a, const Hole& b) { return a.along.low < b.along.low; });
  }
}

/// A piece of wall shorter than half a brick, and the hole beside the piece.
struct ShortPiece {
  Interval piece;
  const WallPlan* wall = nullptr;
  const Hole* hole = nullptr;
};

/// The hole at fault for a short piece: a pocket before an opening; of two openings the later one in the case.
const Hole* hole_beside(const WallPlan& wall, Interval piece, Interval height) {
  const Hole* found = nullptr;
  for (const Hole& hole : wall.holes) {
    const bool beside = hole.along.high == piece.low || hole.along.low == piece.high;
    if (!beside || !hole.height.overlaps(height)) continue;
    const auto rank = [](const Hole& h) { return std::tuple(h.floor, h.ground < 0, h.opening); };
    if (found == nullptr || rank(hole) > rank(*found)) found = &hole;
  }
  return found;
}

/// Short pieces in order, one for each hole that causes some, of an opening or lintel one on each side.
std::vector<ShortPiece> find_short_pieces(const HousePlan& plan) {
  std::vector<ShortPiece> found;
  const auto known = [&](const Hole* hole, Interval piece) {
    return std::ranges::any_of(found, [&](const ShortPiece& p) {
      const bool same_side = hole == nullptr || (p.piece.high <= hole->along.low) == (piece.high <= hole->along.low);
      return (p.hole == hole && same_side) || (hole != nullptr && p.hole != nullptr && hole->floor >= 0 && hole->floor == p.hole->floor);
    });
  };
  for (const WallPlan& wall : plan.walls) {
    for (int course = 0; course < plan.course_count(); ++course) {
      for (const Wythe& wythe : wythes(plan, wall, course)) {
        for (const Interval piece : free_spans(plan, wall, course, wythe.depth)) {
          if (piece.length() >= plan.shortest_piece()) continue;
          const Hole* hole = hole_beside(wall, piece, nth(plan.courses, course));
          if (!known(hole, piece)) found.push_back({piece, &wall, hole});
        }
      }
    }
  }
  return found;
}

/// Number of faults of openings and floors. Used on changed openings, so that advice in messages is valid.
std::size_t faults_with(const House& house, HousePlan plan) {
  for (WallPlan& wall : plan.walls) wall.holes.clear();
  plan.faults = {};
  add_holes(house, plan);
  plan_floors(house, plan);
  plan_courses(house, plan);
  std::set<const Hole*> holes;  // moving the short piece to the other side of an opening mends nothing
  for (const ShortPiece& piece : find_short_pieces(plan)) holes.insert(piece.hole);
  return plan.faults.count() + holes.size();
}

/// The nearest valid value of one length of the house, as the end of a message. `changes` are tried from the smallest.
std::string advice(const House& house, const HousePlan& plan, const std::function<double&(House&)>& length, std::array<Tick, 2> changes) {
  std::sort(changes.begin(), changes.end(), [](Tick a, Tick b) { return std::abs(a) < std::abs(b); });
  const std::size_t now = faults_with(house, plan);
  for (const Tick change : changes) {
    House other = house;
    double& value = length(other);
    value = metres(ticks(value) + change);
    if (faults_with(other, plan) < now) return "; nearest that fits: " + text(value) + " m";
  }
  return "; move or resize it";
}

[[noreturn]] void refuse_short_piece(const House& house, const HousePlan& plan, const ShortPiece& found) {
  const Tick gap = found.piece.length();
  const Tick lack = plan.shortest_piece() - gap;
  const std::string problem = " leaves a piece of the " + wall_name(house, *found.wall) + " " + metres_text(gap) + " m long (" +
                              from_to(found.piece) + "); a piece is at least " + metres_text(plan.shortest_piece()) + " m, half a brick";
  if (found.hole == nullptr) throw InputError("house.inner_size", "this size" + problem);
  if (found.hole->ground >= 0) throw InputError(hole_key(*found.hole), "ends where it" + problem + "; move its end");
  if (found.hole->floor >= 0) {
    const auto floor = static_cast<std::size_t>(found.hole->floor);
    throw InputError(indexed_key("house.floor", floor, "spacing"),
                     text(house.floors[floor].spacing) + " m" + problem + "; choose another, or move what is beside the beam");
  }
  const std::size_t index = found.hole->opening;
  const Opening& opening = house.openings[index];
  // A change removes the piece, or makes it half a brick long.
  if (found.hole->lintel) {
    const auto length = [index](House& h) -> double& { return h.openings[index].lintel->length; };
    throw InputError(opening_key(index, "lintel.length"),  // both ends move: twice the change
                     text(opening.lintel->length) + " m" + problem + advice(house, plan, length, {2 * gap, -2 * lack}));
  }
  if (found.hole->arch) {
    const auto springer = [index](House& h) -> double& { return h.openings[index].arch->springer; };
    throw InputError(opening_key(index, "arch.springer"),
                     text(opening.arch->springer) + " m" + problem + advice(house, plan, springer, {gap, -lack}));
  }
  const bool piece_before = found.hole->along.low == found.piece.high;
  const auto from = [index](House& h) -> double& { return h.openings[index].from; };
  const std::array<Tick, 2> changes = piece_before ? std::array<Tick, 2>{-gap, lack} : std::array<Tick, 2>{gap, -lack};
  throw InputError(opening_key(index, "from"), text(opening.from) + " m" + problem + advice(house, plan, from, changes));
}

/// Whether a stretch of a wall is entirely open just above a height.
bool is_open_above(const WallPlan& wall, Interval along, Tick height) {
  Tick covered = along.low;
  for (const Hole& h : wall.holes) {  // ascending along the wall
    if (h.height.low <= height && height < h.height.high && h.along.low <= covered) covered = std::max(covered, h.along.high);
  }
  return covered >= along.high;
}

/// Whether masonry lies just above an opening: of its wall, of the same wall in the next storey, or of a gable.
bool has_masonry_above(const House& house, const HousePlan& plan, const WallPlan& wall, const Hole& opening) {
  const Tick top = opening.height.high;
  if (top < wall.height.high) return !is_open_above(wall, opening.along, top);
  for (const WallPlan& above : plan.walls) {
    const bool same = above.storey == wall.storey + 1 && above.pier < 0 && above.inner == wall.inner && above.side == wall.side;
    if (same && above.built) return !is_open_above(above, opening.along, top);
  }
  const RoofKind roof = house.roof.kind;
  const bool gabled = roof == RoofKind::vault || roof == RoofKind::gables || roof == RoofKind::pitched;
  return gabled && wall.outer() && !wall.along_x && wall.storey + 1 == static_cast<int>(plan.storeys.size());
}

}  // namespace

std::vector<InputError> unsupported_heads(const House& house) {
  std::vector<InputError> found;
  const HousePlan plan = plan_house(house);
  for (const WallPlan& wall : plan.walls) {
    if (!wall.built) continue;
    for (const Hole& h : wall.holes) {
      if (h.lintel || h.arch || h.floor >= 0 || h.ground >= 0) continue;
      const Opening& opening = house.openings[h.opening];
      if (opening.lintel || opening.arch || 2 * h.along.length() <= plan.brick_length) continue;
      if (!has_masonry_above(house, plan, wall, h)) continue;
      found.emplace_back(opening_key(h.opening),
                         "the opening in the " + wall_name(house, wall) + ", " + text(opening.width) +
                             " m wide, has masonry above it and nothing that carries it; give it a lintel or an arch");
    }
  }
  return found;
}

void plan_openings(const House& house, HousePlan& plan) {
  add_holes(house, plan);
  plan_floors(house, plan);
  plan_courses(house, plan);
  for (const ShortPiece& found : find_short_pieces(plan)) plan.faults.attempt([&] { refuse_short_piece(house, plan, found); });
}

}  // namespace voussoir::cases
