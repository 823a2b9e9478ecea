// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "cases/house/house_parts.h"
#include "cases/house/walls/ground.h"
#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::cases {
namespace {

/// Lengths of the reinforcement, each checked.
struct Sections {
  Tick column_x = 0, column_y = 0;
  Tick beam_width = 0, beam_height = 0;
  Interval column;  // heights
};

/// A column, and the key that defines its position.
struct Column {
  Interval x, y;
  std::string key;
};

Sections sections_of(const Reinforcement& r, const HousePlan& plan) {
  Sections s;
  s.column_x = positive_length(r.column[0], "house.reinforcement.column");
  s.column_y = positive_length(r.column[1], "house.reinforcement.column");
  s.beam_width = positive_length(r.ring_beam[0], "house.reinforcement.ring_beam");
  s.beam_height = positive_length(r.ring_beam[1], "house.reinforcement.ring_beam");
  if (r.ring_beam_place == RingPlace::middle) {
    s.column = {0, plan.height};
  } else if (s.beam_height >= plan.height) {
    throw InputError("house.reinforcement.ring_beam",
                     text(r.ring_beam[1]) + " m is not below the height of the walls, " + text(metres(plan.height)) + " m");
  }
  const std::array inner{plan.outer[0] - 2 * plan.wall(Side::left).thickness, plan.outer[1] - 2 * plan.wall(Side::front).thickness};
  const Tick room = std::min(inner[0], inner[1]) - plan.shortest_piece();
  const Tick thinnest = std::min(plan.wall(Side::left).thickness, plan.wall(Side::front).thickness);
  if (r.ring_beam_place == RingPlace::middle && s.beam_width > thinnest) {
    throw InputError("house.reinforcement.ring_beam", text(r.ring_beam[0]) + " m is wider than a wall under it; at most " +
                                                          text(metres(thinnest)) + " m, the thickness of the thinnest wall");
  }
  if (r.ring_beam_place == RingPlace::inside && room < 2 * s.beam_width) {
    throw InputError("house.reinforcement.ring_beam",
                     text(r.ring_beam[0]) + " m leaves no room between the beams; at most " + text(metres(room / 2)) + " m");
  }
  if (s.column_x > inner[0] || s.column_y > inner[1]) {
    throw InputError("house.reinforcement.column", text(r.column[0]) + " x " + text(r.column[1]) + " m does not fit between the walls, " +
                                                       text(metres(inner[0])) + " x " + text(metres(inner[1])) + " m apart");
  }
  if (r.ring_beam_place == RingPlace::inside) s.column = {0, plan.height - s.beam_height};
  return s;
}

/// The column at one wall; `section` is its size along the wall, `depth` perpendicular to the wall.
Column column_at(const HousePlan& plan, const WallPlan& wall, Tick axis, Tick section, Tick depth, std::string key) {
  const Interval along{axis - section / 2, axis - section / 2 + section};
  const HouseBox box = in_house(plan, wall, along, {wall.thickness, wall.thickness + depth}, {});
  return {box.x, box.y, std::move(key)};
}

/// The nearest position of an axis clear of the openings of a wall, as the end of a message.
std::string advice(const WallPlan& wall, Tick axis, Tick section, Interval height, Interval room) {
  const auto fits = [&](Tick place) {
    const Interval along{place - section / 2, place - section / 2 + section};
    return along.low >= room.low && along.high <= room.high && std::none_of(wall.holes.begin(), wall.holes.end(), [&](const Hole& h) {
             return !h.lintel && h.along.overlaps(along) && h.height.overlaps(height);
           });
  };
  std::vector<Tick> places;
  for (const Hole& hole : wall.holes) {
    places.push_back(hole.along.low - (section - section / 2));
    places.push_back(hole.along.high + section / 2);
  }
  std::erase_if(places, [&](Tick place) { return !fits(place); });
  if (places.empty()) return "; move it or leave it out";
  const auto nearest =
      std::min_element(places.begin(), places.end(), [&](Tick a, Tick b) { return std::abs(a - axis) < std::abs(b - axis); });
  return "; nearest that fits: " + text(metres(*nearest)) + " m";
}

void check_place(const WallPlan& wall, double given, Tick axis, Tick section, Interval height, const std::string& key) {
  const Interval room{wall.corner, wall.length - wall.corner};
  const Interval along{axis - section / 2, axis - section / 2 + section};
  const std::string at = text(given) + " m puts a column ";
  if (along.low < room.low || along.high > room.high) {
    throw InputError(key, at + "outside the room; allowed: " + text(metres(room.low + section / 2)) + " to " +
                              text(metres(room.high - (section - section / 2))) + " m");
  }
  for (const Hole& hole : wall.holes) {
    if (hole.lintel || !hole.along.overlaps(along) || !hole.height.overlaps(height)) continue;
    throw InputError(key, at + "in front of " + hole_key(hole) + " (" + from_to(hole.along) + ") in the " + name(wall.side) + " wall" +
                              advice(wall, axis, section, height, room));
  }
}

void place_columns(const House& house, const HousePlan& plan, const Sections& s, bool bearing, std::vector<Column>& columns) {
  const Reinforcement& r = *house.reinforcement;
  const std::vector<double>& axes = bearing ? r.bearing : r.nonbearing;
  const Tick section = bearing ? s.column_x : s.column_y, depth = bearing ? s.column_y : s.column_x;
  for (const Side side : bearing ? std::array{Side::front, Side::rear} : std::array{Side::right, Side::left}) {
    const WallPlan& wall = plan.wall(side);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const std::string key = indexed_key(bearing ? "house.reinforcement.bearing" : "house.reinforcement.nonbearing", i, "");
      const Tick axis = positive_length(axes[i], key);
      check_place(wall, axes[i], axis, section, s.column, key);
      Column column = column_at(plan, wall, axis, section, depth, key);
      for (const Column& other : columns) {
        if (!column.x.overlaps(other.x) || !column.y.overlaps(other.y)) continue;
        throw InputError(key, text(axes[i]) + " m puts a column where that of " + other.key + " stands (x " + from_to(other.x) + ", y " +
                                  from_to(other.y) + ")");
      }
      columns.push_back(std::move(column));
    }
  }
}

/// Builds timber members, divided into elements along their length.
class Carpenter {
 public:
  Carpenter(const Reinforcement& r, HouseParts& parts) : r_(r), parts_(parts) {}

  /// Adds a member along x (0), y (1) or z (2).
  void add(PartKind kind, const std::string& tag, HouseBox box, int along) {
    Interval& length = along == 0 ? box.x : along == 1 ? box.y : box.z;
    const Interval whole = length;
    const Tick element = element_length(r_.element, whole.length(), "house.reinforcement.element");
    Block prototype;
    prototype.kind = kind;
    prototype.tag = tag;
    prototype.material = parts_.timber;
    prototype.member = parts_.members++;
    length = {0, std::min(element, whole.length())};
    prototype.segment_size = segment_size_of(box.x.length(), box.y.length(), box.z.length());
    for (const Interval part : cut_member(whole, element)) {
      length = part;
      prototype.whole = part.length() == element;
      parts_.blocks.push_back(box_block(box, prototype));
    }
  }

 private:
  const Reinforcement& r_;
  HouseParts& parts_;
};

/// Adds ring beams on the walls, over the middles of the walls. Beams along x run through the corners.
void add_ring_beams_upon(const HousePlan& plan, const Sections& s, Carpenter& carpenter) {
  const Interval z{plan.height, plan.height + s.beam_height};
  for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
    const WallPlan& wall = plan.wall(side);
    const Tick depth = (wall.thickness - s.beam_width) / 2;
    const Tick from = (wall.corner - s.beam_width) / 2 + (wall.along_x ? 0 : s.beam_width);
    const HouseBox box = in_house(plan, wall, {from, wall.length - from}, {depth, depth + s.beam_width}, z);
    carpenter.add(PartKind::ring_beam, std::string(name(side)) + " ring beam", box, wall.along_x ? 0 : 1);
  }
}

/// Adds ring beams at the inner faces. Beams along x run through the inner corners.
void add_ring_beams(const HousePlan& plan, const Sections& s, Carpenter& carpenter) {
  const Interval z{plan.height - s.beam_height, plan.height};
  for (const Side side : {Side::front, Side::right, Side::rear, Side::left}) {
    const WallPlan& wall = plan.wall(side);
    const Tick from = wall.corner + (wall.along_x ? 0 : s.beam_width);
    const HouseBox box = in_house(plan, wall, {from, wall.length - from}, {wall.thickness, wall.thickness + s.beam_width}, z);
    carpenter.add(PartKind::ring_beam, std::string(name(side)) + " ring beam", box, wall.along_x ? 0 : 1);
  }
}

}  // namespace

void build_reinforcement(const House& house, const HousePlan& plan, HouseParts& parts) {
  if (std::any_of(plan.walls.begin(), plan.walls.end(), [](const WallPlan& w) { return !w.built; }))
    throw InputError("house.reinforcement", "a ring beam goes round four walls; house.walls leaves out some");
  if (!house.storeys.empty() || !house.inner_walls.empty() || !house.floors.empty()) {
    const bool columns = !house.reinforcement->bearing.empty() || !house.reinforcement->nonbearing.empty();
    if (columns || house.reinforcement->ring_beam_place == RingPlace::inside)
      throw InputError("house.reinforcement",
                       "columns and ring beams inside the walls go with a house of one storey and one room, without "
                       "floors; a ring beam upon the walls (ring_beam_place = \"middle\") goes with any");
  }
  const bool upon_walls = house.reinforcement->ring_beam_place == RingPlace::middle;
  if (upon_walls && house.roof.kind != RoofKind::none && house.roof.kind != RoofKind::flat)
    throw InputError("house.reinforcement.ring_beam_place",
                     "\"middle\" does not go with this roof, whose feet and gables start where the ring would lie; allowed: \"inside\", "
                     "or house.roof.kind \"none\" or \"flat\"");
  const Sections s = sections_of(*house.reinforcement, plan);
  std::vector<Column> columns;
  place_columns(house, plan, s, true, columns);
  place_columns(house, plan, s, false, columns);
  Carpenter carpenter(*house.reinforcement, parts);
  for (std::size_t i = 0; i < columns.size(); ++i)
    carpenter.add(PartKind::column, "column " + std::to_string(i), {columns[i].x, columns[i].y, s.column}, 2);
  upon_walls ? add_ring_beams_upon(plan, s, carpenter) : add_ring_beams(plan, s, carpenter);
}

}  // namespace voussoir::cases
