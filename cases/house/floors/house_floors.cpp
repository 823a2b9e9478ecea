// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/house/floors/house_floors.h"

#include <algorithm>

#include "cases/house/house_parts.h"
#include "cases/house/house_wall.h"
#include "cases/house/walls/ground.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// The walls along which no beam ends: those parallel to the beams.
BeamEnds sides_of(const Floor& floor) {
  return floor.along == PlanAxis::y ? BeamEnds{Side::left, Side::right} : BeamEnds{Side::front, Side::rear};
}

void check_storey(const House& house, std::size_t index) {
  const int storey = house.floors[index].storey, most = static_cast<int>(house.storeys.size()) + 1;
  if (storey < 1 || storey > most)
    throw InputError(floor_key(index, "storey"),
                     "there is no storey " + std::to_string(storey) + "; allowed: 1 to " + std::to_string(most));
  for (std::size_t other = 0; other < index; ++other) {
    if (house.floors[other].storey == storey)
      throw InputError(floor_key(index, "storey"), "storey " + std::to_string(storey) + " has " + floor_key(other) + " already");
  }
}

/// The clear widths of rooms, across the beams.
std::vector<Interval> rooms_beside(const Floor& floor, const HousePlan& plan, int storey) {
  const bool beams_along_x = floor.along == PlanAxis::x;
  std::vector<Interval> walls;
  for (const WallPlan& wall : plan.walls) {
    if (wall.inner >= 0 && wall.storey == storey && wall.along_x == beams_along_x) walls.push_back({wall.at, wall.at + wall.thickness});
  }
  std::ranges::sort(walls, {}, &Interval::low);
  const BeamEnds sides = sides_of(floor);
  std::vector<Interval> rooms;
  Tick from = plan.wall(sides.low, storey).thickness;
  for (const Interval wall : walls) {
    rooms.push_back({from, wall.low});
    from = wall.high;
  }
  rooms.push_back({from, plan.outer[beams_along_x ? 1 : 0] - plan.wall(sides.high, storey).thickness});
  return rooms;
}

/// Refuses a bearing that leaves less than half a brick's width, as fitted to the wall, of a brick behind the beams.
void check_piece_behind(const Floor& floor, std::size_t index, const WallPlan& wall, Tick depth, const HousePlan& plan) {
  const Tick behind = wall.thickness - depth;
  for (const int course : {0, 1}) {
    for (const Wythe& layer : wythes(plan, wall, course)) {
      const Tick piece = behind - layer.depth.low, least = std::min(plan.brick_width, layer.depth.length()) / 2;
      if (piece <= 0 || piece >= least || behind >= layer.depth.high) continue;
      throw InputError(floor_key(index, "bearing"), text(floor.bearing) + " m makes pockets that cut bricks of the " + name(wall.side) +
                                                        " wall to " + metres_text(piece) +
                                                        " m behind the beams; a cut brick has at least " + metres_text(least) +
                                                        " m, half its width; nearest that fit: " + metres_text(depth + piece) + " or " +
                                                        metres_text(depth + piece - least) + " m");
    }
  }
}

/// Depth of the pockets of a floor in a wall under it; nothing where the beams run parallel to the wall.
std::optional<Interval> pocket_depth(const Floor& floor, std::size_t index, const WallPlan& wall, const HousePlan& plan) {
  if (wall.pier >= 0 || wall.along_x == (floor.along == PlanAxis::x)) return std::nullopt;
  if (wall.inner >= 0) return Interval{0, wall.thickness};
  const Tick depth = positive_length(floor.bearing, floor_key(index, "bearing"));
  if (depth > wall.thickness)
    throw InputError(floor_key(index, "bearing"), text(floor.bearing) + " m is deeper than the " + name(wall.side) + " wall; at most " +
                                                      metres_text(wall.thickness) + " m");
  check_piece_behind(floor, index, wall, depth, plan);
  return Interval{wall.thickness - depth, wall.thickness};
}

/// Refuses pockets at piers: a pier runs through its wall in every second course.
void check_piers(const House& house, const Hole& pocket, const WallPlan& wall, const HousePlan& plan) {
  for (const WallPlan& pier : plan.walls) {
    const bool here = wall.outer() && pier.pier >= 0 && pier.side == wall.side && pier.height.overlaps(pocket.height);
    if (!here || !pocket.along.overlaps({pier.at, pier.at + pier.thickness})) continue;
    const auto index = static_cast<std::size_t>(pier.pier);
    throw InputError(indexed_key("house.pier", index, "from"), text(house.piers[index].from) + " m puts the pier where a beam of " +
                                                                   indexed_key("house.floor", static_cast<std::size_t>(pocket.floor), "") +
                                                                   " ends, from " + metres_text(pocket.along.low) + " to " +
                                                                   metres_text(pocket.along.high) + " m of the " + wall_name(house, wall) +
                                                                   "; move one of them, or end the pier below");
  }
}

void add_pocket(const House& house, const Hole& pocket, WallPlan& wall, const HousePlan& plan) {
  check_piers(house, pocket, wall, plan);
  for (const Hole& other : wall.holes) {
    if (other.floor >= 0 || !other.along.overlaps(pocket.along) || !other.height.overlaps(pocket.height)) continue;
    const auto index = static_cast<std::size_t>(pocket.floor);
    throw InputError(floor_key(index, "beam"), "a beam from " + metres_text(pocket.along.low) + " to " + metres_text(pocket.along.high) +
                                                   " m of the " + wall_name(house, wall) + ", " + metres_text(pocket.height.low) +
                                                   " m above the ground, lies in " + hole_key(other) +
                                                   "; lower that, or move the beams (spacing)");
  }
  wall.holes.push_back(pocket);
}

void check_walls(const House& house, std::size_t index, const HousePlan& plan) {
  const BeamEnds ends = ends_of(house.floors[index]);
  for (const Side side : {ends.low, ends.high}) {
    if (!plan.wall(side, 0).built)
      throw InputError(floor_key(index), "its beams rest on the " + std::string(name(side)) + " wall, which house.walls leaves out");
  }
}

/// Plans a floor without its pockets.
FloorPlan lay_beams(const House& house, std::size_t index, const HousePlan& plan) {
  const Floor& floor = house.floors[index];
  const int storey = floor.storey - 1;
  const Interval walls = nth(plan.storeys, storey);
  const Tick width = positive_length(floor.beam[0], floor_key(index, "beam")),
             height = positive_length(floor.beam[1], floor_key(index, "beam"));
  const Tick spacing = positive_length(floor.spacing, floor_key(index, "spacing"));
  if (height >= walls.length())
    throw InputError(floor_key(index, "beam"),
                     text(floor.beam[1]) + " m is not less than the height of the storey, " + metres_text(walls.length()) + " m");
  if (spacing < width + plan.shortest_piece())
    throw InputError(floor_key(index, "spacing"), text(floor.spacing) + " m leaves less than half a brick between beams; at least " +
                                                      metres_text(width + plan.shortest_piece()) + " m");
  FloorPlan laid;
  laid.height = {walls.high - height, walls.high};
  const BeamEnds ends = ends_of(floor);
  const Tick bearing = positive_length(floor.bearing, floor_key(index, "bearing"));
  laid.length = {plan.wall(ends.low, storey).thickness - bearing,
                 plan.outer[floor.along == PlanAxis::x ? 0 : 1] - plan.wall(ends.high, storey).thickness + bearing};
  element_length(floor.element, laid.length.length(), floor_key(index, "element"));
  bool any = false;
  for (const Interval room : rooms_beside(floor, plan, storey)) {
    laid.rooms.push_back(beams_in({room.low + plan.shortest_piece(), room.high - plan.shortest_piece()}, width, spacing));
    any = any || !laid.rooms.back().empty();
  }
  if (!any) throw InputError(floor_key(index, "beam"), text(floor.beam[0]) + " m is too wide for the rooms of the storey");
  return laid;
}

/// Adds the pockets of a floor's beams to the walls.
void add_pockets(const House& house, std::size_t i, const FloorPlan& laid, HousePlan& plan) {
  const Floor& floor = house.floors[i];
  for (WallPlan& wall : plan.walls) {
    if (wall.storey != floor.storey - 1) continue;
    const std::optional<Interval> depth = pocket_depth(floor, i, wall, plan);
    if (!depth) continue;
    for (const std::vector<Interval>& room : laid.rooms) {
      for (const Interval beam : room) add_pocket(house, {beam, laid.height, 0, false, *depth, static_cast<std::int32_t>(i)}, wall, plan);
    }
  }
}

}  // namespace

std::vector<Interval> beams_in(Interval room, Tick width, Tick spacing) {
  std::vector<Interval> beams;
  if (room.length() < width) return beams;
  const Tick count = (room.length() - width) / spacing + 1;
  Tick low = room.low + (room.length() - width - (count - 1) * spacing) / 2;
  for (Tick i = 0; i < count; ++i, low += spacing) beams.push_back({low, low + width});
  return beams;
}

double floor_load_density(const Floor& floor, const std::string& key) {
  if (!(floor.load >= 0.0 && floor.load < 1e5)) throw InputError(key, text(floor.load) + " kg/m2 is out of range; allowed: 0 to 100000");
  return floor.load * floor.spacing / (floor.beam[0] * floor.beam[1]);
}

std::string floor_key(std::size_t floor, const char* field) { return indexed_key("house.floor", floor, field); }

BeamEnds ends_of(const Floor& floor) noexcept {
  return floor.along == PlanAxis::y ? BeamEnds{Side::front, Side::rear} : BeamEnds{Side::left, Side::right};
}

void plan_floors(const House& house, HousePlan& plan) {
  plan.floors.clear();
  for (std::size_t i = 0; i < house.floors.size(); ++i) {
    FloorPlan& laid = plan.floors.emplace_back();
    const bool lies = plan.faults.attempt([&] {
      check_storey(house, i);
      check_walls(house, i, plan);
      laid = lay_beams(house, i, plan);
    });
    // Faults of pockets are told beside those of the courses, which the beams decide.
    if (lies) plan.faults.attempt([&] { add_pockets(house, i, laid, plan); });
  }
}

void build_floors(const House& house, const HousePlan& plan, HouseParts& parts) {
  for (std::size_t i = 0; i < house.floors.size(); ++i) {
    const Floor& floor = house.floors[i];
    const FloorPlan& laid = plan.floors[i];
    const Tick element = ticks(floor.element);
    Block prototype;
    prototype.kind = PartKind::floor_beam;
    prototype.material = parts.floors[i];
    prototype.floor = static_cast<std::int32_t>(i);
    prototype.segment_size = segment_size_of(ticks(floor.beam[0]), ticks(floor.beam[1]), std::min(element, laid.length.length()));
    int number = 0;
    for (const std::vector<Interval>& room : laid.rooms) {
      for (const Interval beam : room) {
        prototype.tag = "floor " + std::to_string(floor.storey) + " beam " + std::to_string(number++);
        prototype.member = parts.members++;
        for (const Interval part : cut_member(laid.length, element)) {
          prototype.whole = part.length() == element;
          const bool x = floor.along == PlanAxis::x;
          parts.blocks.push_back(box_block({x ? part : beam, x ? beam : part, laid.height}, prototype));
        }
      }
    }
  }
}

}  // namespace voussoir::cases
