// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/walls/spans/wall_floors.h"

#include <algorithm>
#include <cmath>

#include "cases/house/floors/house_floors.h"
#include "cases/house/house_parts.h"
#include "cases/names.h"
#include "cases/walls/spans/wall_bays.h"
#include "cases/walls/spans/wall_levels.h"
#include "cases/walls/wall_courses.h"
#include "cases/walls/wall_layout.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

constexpr double kNoArea = 1e-8;    // m2, as of geometry's joints
constexpr double kParallel = 1e-6;  // rad

std::string key_of(std::size_t floor, const char* field) { return Spanning{"floor", floor}.key(field); }

class FloorLayer {
 public:
  FloorLayer(const std::vector<WallSpec>& walls, const WallFloor& floor, std::size_t index, WallsPlan& plan)
      : walls_(walls), floor_(floor), index_(index), plan_(plan) {}

  void lay() {
    Faults faults;
    faults.attempt([&] {
      width_ = positive_length(floor_.beams.beam[0], key("beam")), height_ = positive_length(floor_.beams.beam[1], key("beam"));
      spacing_ = positive_length(floor_.beams.spacing, key("spacing")), bearing_ = positive_length(floor_.beams.bearing, key("bearing"));
    });
    faults.attempt([&] { laid_.bay = find_bay(walls_, plan_, {"floor", index_}, floor_.walls, floor_.direction, floor_.corners); });
    faults.raise();
    faults.attempt([&] { check_bearing(); });
    faults.attempt([&] { set_level(); });
    faults.raise();
    find_walls_between();
    lay_beams();
    for (const auto& room : laid_.rooms) {
      for (const BayBeam& beam : room) faults.attempt([&] { add_pockets(beam); });
    }
    faults.raise();
    plan_.floors[index_] = laid_;
  }

 private:
  [[nodiscard]] std::string key(const char* field) const { return key_of(index_, field); }
  [[nodiscard]] const Leg& side(std::size_t k) const { return plan_.legs[laid_.bay.faces[k].leg]; }
  [[nodiscard]] double least() const { return std::max(least_piece(walls_[side(0).wall]), least_piece(walls_[side(1).wall])); }

  void check_bearing() const {
    for (std::size_t k = 0; k < 2; ++k) {
      const double thickness = 2.0 * side(k).half;
      if (floor_.beams.bearing > thickness + 1e-9)
        throw InputError(key("bearing"),
                         text(floor_.beams.bearing) + " m is deeper than the " + side(k).tag + "; at most " + text(thickness) + " m");
    }
    if (spacing_ < width_ + ticks(least()))
      throw InputError(key("spacing"), text(floor_.beams.spacing) + " m leaves less than a fifth of a brick between beams; at least " +
                                           metres_text(width_ + ticks(least())) + " m");
  }

  void set_level() {
    const Tick top = std::min(eaves(walls_[side(0).wall]), eaves(walls_[side(1).wall]));
    const Tick level = floor_.level ? ticks(*floor_.level) : top;
    laid_.height = {level - height_, level};
    std::array<Interval, 2> stands;
    Tick lowest = 1;
    for (std::size_t k = 0; k < 2; ++k) {
      stands[k] = {side(k).height.low, eaves(walls_[side(k).wall])};
      lowest = std::max(lowest, plan_.bricks[side(k).wall].brick_height / 5);
    }
    laid_.levels = beam_levels(stands, height_, lowest), laid_.undersides = beam_undersides(stands, level, lowest);
    if (std::ranges::any_of(laid_.levels, [&](Interval i) { return i.low <= level && level <= i.high; })) return;
    std::string stand;
    for (std::size_t k = 0; k < 2; ++k) stand += "; the " + side(k).tag + " stands " + from_to(stands[k]);
    throw InputError(key(floor_.level ? "level" : "beam"),
                     text(floor_.level ? *floor_.level : floor_.beams.beam[1]) + " m: beams would lie " + from_to(laid_.height) +
                         " above the base" + stand +
                         "; beams lie in a wall, at its foot or on its top, and no course beside them is lower than a fifth of a " +
                         "brick; " + (laid_.levels.empty() ? "no level fits both" : "allowed levels: " + ranges_text(laid_.levels)));
  }

  /// Ground between two planes of beams, from the outer face of one wall to that of the other: (x, y).
  [[nodiscard]] geometry::Polygon ground(double low, double high) const {
    const Bay& bay = laid_.bay;
    geometry::Polygon all;
    for (const auto& [u, k] : {std::pair{low, std::size_t{0}}, {high, std::size_t{0}}, {high, std::size_t{1}}, {low, std::size_t{1}}}) {
      const Vec3 p = bay.at(u, v_of(plan_, bay, {bay.faces[k].leg, -bay.faces[k].d}, u));
      all.push_back({p.x, p.y});
    }
    if (cross(bay.across, bay.along).z < 0.0) std::ranges::reverse(all);
    return all;
  }

  [[nodiscard]] bool is_side(std::size_t leg) const { return leg == laid_.bay.faces[0].leg || leg == laid_.bay.faces[1].leg; }

  /// Parts the other walls in the bay: those that meet one of its two walls bound rooms, others lie across the beams.
  void find_walls_between() {
    const Bay& bay = laid_.bay;
    const geometry::Polygon between = ground(bay.low, bay.high);
    for (std::size_t i = 0; i < plan_.legs.size(); ++i) {
      const Leg& leg = plan_.legs[i];
      if (is_side(i) || !leg.height.overlaps(laid_.height) || stands_upon_side(i)) continue;
      for (std::size_t f = 0; f < leg.facets.size(); ++f) {
        const geometry::Polygon common = geometry::intersection(outline_of(leg, f), between);
        if (geometry::region(common).area < kNoArea) continue;
        double low = bay.high, high = bay.low;
        bool meets = leg.facets.size() > 1 || std::abs(dot(leg.facets[f].across, bay.along)) < 0.5;
        for (const geometry::Point2 p : common) {
          const Vec3 q = Vec3{p.s, p.t, 0.0} - bay.from;
          const double u = dot(q, bay.across), v = dot(q, bay.along);
          low = std::min(low, u), high = std::max(high, u);
          meets = meets || v < v_of(plan_, bay, bay.faces[0], u) + kPlanTolerance || v > v_of(plan_, bay, bay.faces[1], u) - kPlanTolerance;
        }
        laid_.between.push_back(i);
        if (meets && high - low > widest_) widest_ = high - low, widest_name_ = leg.tag;
        if (meets)
          beside_.push_back({ticks(low), ticks(high)});
        else
          across_.push_back(i);
      }
    }
    std::ranges::sort(beside_, {}, &Interval::low);
  }

  /// Notes a leg that stands upon a side, along it.
  bool stands_upon_side(std::size_t i) {
    const Leg& leg = plan_.legs[i];
    for (std::size_t k = 0; k < 2 && leg.facets.size() == 1; ++k) {
      const Leg& under = side(k);
      const Facet &f = leg.facets[0], &g = under.facets[0];
      if (leg.height.low != under.eaves || std::abs(cross(f.along, g.along).z) > kParallel) continue;
      if (geometry::region(geometry::intersection(outline_of(leg, 0), outline_of(under, 0))).area < kNoArea) continue;
      const double face = laid_.bay.faces[k].d;
      const Vec3 inwards = (face > 0.0 ? 1.0 : -1.0) * g.across;
      const double inner = dot(f.across, inwards) > 0.0 ? leg.half : -leg.half;
      laid_.upon.push_back({i, k, inner, dot(under.at(0.0, face) - leg.at(0.0, inner), inwards)});
      return true;
    }
    return false;
  }

  void lay_beams() {
    const Bay& bay = laid_.bay;
    const Tick margin = ticks(least()) + 1;
    Tick from = ticks(bay.low);
    const auto add_room = [&](Tick to) {
      if (to - from <= 2 * margin) return;
      std::vector<BayBeam>& room = laid_.rooms.emplace_back();
      for (const Interval beam : beams_in({from + margin, to - margin}, width_, spacing_)) room.push_back(beam_at(beam));
      if (room.empty()) laid_.rooms.pop_back();
    };
    for (const Interval wall : beside_) {
      add_room(wall.low);
      from = std::max(from, wall.high);
    }
    add_room(ticks(bay.high));
    if (laid_.rooms.empty())
      throw InputError(key("beam"), "no beam " + text(floor_.beams.beam[0]) + " m wide fits along the " + side(0).tag + " and the " +
                                        side(1).tag + ": they face each other over " + text(std::round((bay.high - bay.low) * 1e4) * 1e-4) +
                                        " m, and a beam has a fifth of a brick free on either side" +
                                        (beside_.empty() ? "" : "; other walls take up part of that length, such as the " + widest_name_));
    for (const auto& room : laid_.rooms) {
      for (const BayBeam& beam : room) check_elements(beam);
    }
  }

  [[nodiscard]] BayBeam beam_at(Interval across) const {
    const Bay& bay = laid_.bay;
    BayBeam beam{across, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const WallFace end{bay.faces[k].leg, back_of(k)};
      beam.ends[k] = {v_of(plan_, bay, end, metres(across.low)), v_of(plan_, bay, end, metres(across.high))};
    }
    return beam;
  }
  /// d of the plane in which beams end in a side.
  [[nodiscard]] double back_of(std::size_t k) const {
    const double face = laid_.bay.faces[k].d;
    return face > 0.0 ? face - floor_.beams.bearing : face + floor_.beams.bearing;
  }

  void check_elements(const BayBeam& beam) const {
    const double length = 0.5 * (beam.ends[1][0] + beam.ends[1][1] - beam.ends[0][0] - beam.ends[0][1]);
    const Tick element = element_length(floor_.beams.element, ticks(length), key("element"));
    const double skew = std::max(std::abs(beam.ends[0][0] - beam.ends[0][1]), std::abs(beam.ends[1][0] - beam.ends[1][1]));
    const double shortest = metres(std::min(element, ticks(length)));
    if (shortest < skew - 1e-9)
      throw InputError(key("element"), text(floor_.beams.element) + " m is too short for ends as oblique as these; at least " +
                                           text(std::ceil(skew * 1e3) * 1e-3) + " m");
  }

  void add_pockets(const BayBeam& beam) {
    for (std::size_t k = 0; k < 2; ++k) {
      const double face = laid_.bay.faces[k].d, back = back_of(k);
      add_pocket(beam, laid_.bay.faces[k].leg, std::min(face, back), std::max(face, back));
    }
    const geometry::Polygon under = ground(metres(beam.across.low), metres(beam.across.high));
    const auto is_met = [&](const Leg& leg) { return geometry::region(geometry::intersection(outline_of(leg, 0), under)).area > kNoArea; };
    for (const std::size_t i : across_) {
      if (const Leg& leg = plan_.legs[i]; is_met(leg)) add_pocket(beam, i, -leg.half, leg.half);
    }
    for (const WallUpon& w : laid_.upon) {
      const Leg& leg = plan_.legs[w.leg];
      const double reach = std::min(floor_.beams.bearing - w.setback, 2.0 * leg.half);
      const double back = w.inner > 0.0 ? w.inner - reach : w.inner + reach;
      if (reach > kPlanTolerance && is_met(leg)) add_pocket(beam, w.leg, std::min(w.inner, back), std::max(w.inner, back));
    }
  }

  void add_pocket(const BayBeam& beam, std::size_t in, double from, double to) {
    Leg& leg = plan_.legs[in];
    if (!leg.height.overlaps(laid_.height)) return;
    Pocket p{
        cut_at(leg, laid_.bay, metres(beam.across.low)), cut_at(leg, laid_.bay, metres(beam.across.high)), from, to, laid_.height, index_};
    if (p.low.at > p.high.at) std::swap(p.low, p.high);
    const double low = std::min(p.low(from), p.low(to)), high = std::max(p.high(from), p.high(to));
    if (const auto words = in_the_way_of(walls_[leg.wall], plan_, leg, p))
      throw InputError(key("spacing"), text(floor_.beams.spacing) + " m puts a beam into the " + leg.tag + " from " +
                                           text(std::round(leg.place(low) * 1e4) * 1e-4) + " to " +
                                           text(std::round(leg.place(high) * 1e4) * 1e-4) + " m along the line of the wall, and " + *words +
                                           "; at least " + text(least_piece(walls_[leg.wall])) +
                                           " m, a fifth of a brick, lie between them: change spacing, corners or level");
    leg.pockets.push_back(p);
  }

  const std::vector<WallSpec>& walls_;
  const WallFloor& floor_;
  std::size_t index_;
  WallsPlan& plan_;
  BayFloor laid_;
  Tick width_ = 0, height_ = 0, spacing_ = 0, bearing_ = 0;
  std::vector<Interval> beside_;     // ranges of u that walls beside rooms fill, ascending
  std::vector<std::size_t> across_;  // legs that beams go through
  double widest_ = 0.0;              // m of u, of the leg beside rooms that fills most
  std::string widest_name_;
};

std::string loaded_name(const WallFloor& floor) {
  return floor.material + " of floor " + floor.name + " with " + text(floor.beams.load) + " kg/m2";
}

/// Ends of the elements of a beam: v at its lower and its higher u.
std::vector<std::array<double, 2>> element_ends(const BayBeam& beam, double element) {
  const double start = 0.5 * (beam.ends[0][0] + beam.ends[0][1]), end = 0.5 * (beam.ends[1][0] + beam.ends[1][1]);
  std::vector<std::array<double, 2>> all{beam.ends[0]};
  for (const Interval part : cut_member({0, ticks(end - start)}, ticks(element)))
    all.push_back({start + metres(part.high), start + metres(part.high)});
  all.back() = beam.ends[1];
  return all;
}

}  // namespace

void plan_wall_floors(const std::vector<WallSpec>& walls, const std::vector<WallFloor>& floors, WallsPlan& plan) {
  Faults faults;
  plan.floors.resize(floors.size());
  for (std::size_t i = 0; i < floors.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (floors[k].name == floors[i].name)
        faults.add({key_of(i, "name"), quoted(floors[i].name) + " is already the name of " + key_of(k, "")});
    }
    faults.attempt([&] { FloorLayer(walls, floors[i], i, plan).lay(); });
  }
  faults.raise();
}

std::vector<NamedMaterial> loaded_floor_materials(const std::vector<WallFloor>& floors, std::span<const NamedMaterial> materials) {
  std::vector<NamedMaterial> all;
  Faults faults;
  for (std::size_t i = 0; i < floors.size(); ++i) {
    faults.attempt([&] {
      const std::int32_t bare = find_material(materials, floors[i].material, key_of(i, "material"));
      const double added = floor_load_density(floors[i].beams, key_of(i, "load"));
      if (added == 0.0) return;
      all.push_back({loaded_name(floors[i]), nth(materials, bare).value, bare});
      all.back().value.density += added;
    });
  }
  faults.raise();
  return all;
}

void add_floor_beams(const WallsPlan& plan, const std::vector<WallFloor>& floors, std::span<const NamedMaterial> materials,
                     std::int32_t& members, std::vector<Block>& blocks) {
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const WallFloor& floor = floors[i];
    const BayFloor& laid = plan.floors[i];
    const Floor& beams = floor.beams;
    Block block;
    block.kind = PartKind::floor_beam;
    block.span = static_cast<std::int32_t>(i);
    block.material = beams.load > 0.0 ? find_material(materials, loaded_name(floor), key_of(i, "load"))
                                      : find_material(materials, floor.material, key_of(i, "material"));
    int number = 0;
    for (const auto& room : laid.rooms) {
      for (const BayBeam& beam : room) {
        const std::vector<std::array<double, 2>> ends = element_ends(beam, beams.element);
        const double shortest = std::min(beams.element, ends.back()[0] - ends.front()[0]);
        block.segment_size = segment_size_of(ticks(beams.beam[0]), ticks(beams.beam[1]), ticks(shortest));
        block.tag = floor.name + " beam " + std::to_string(number++);
        block.member = members++;
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
          block.shape = upright(in_bay(laid.bay, {metres(beam.across.low), metres(beam.across.high)}, ends[k], ends[k + 1]), laid.height);
          block.whole =
              std::abs(ends[k + 1][0] - ends[k][0] - beams.element) < 1e-9 && std::abs(ends[k + 1][1] - ends[k][1] - beams.element) < 1e-9;
          blocks.push_back(block);
        }
      }
    }
  }
}

PlannedDeck wall_floor_deck(const WallsPlan& plan, const std::vector<WallFloor>& floors, std::size_t index, double foot) {
  const BayFloor& laid = plan.floors[index];
  const Bay& bay = laid.bay;
  const double z = metres(laid.height.low) + 0.9 * metres(laid.height.length()) + foot;
  PlannedDeck deck;
  for (const auto& room : laid.rooms) {
    std::vector<std::vector<Vec3>> rows;
    std::size_t fewest = static_cast<std::size_t>(-1);
    for (const BayBeam& beam : room) {
      const double u = 0.5 * metres(beam.across.low + beam.across.high);
      const double low = v_of(plan, bay, bay.faces[0], u), high = v_of(plan, bay, bay.faces[1], u);
      const std::vector<std::array<double, 2>> ends = element_ends(beam, floors[index].beams.element);
      std::vector<Vec3>& row = rows.emplace_back();
      for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double v = 0.25 * (ends[k][0] + ends[k][1] + ends[k + 1][0] + ends[k + 1][1]);
        if (v < low + kPlanTolerance || v > high - kPlanTolerance) continue;
        row.push_back(bay.at(u, v));
        row.back().z = z;
      }
      fewest = std::min(fewest, row.size());
    }
    for (std::vector<Vec3>& row : rows) row.resize(fewest);  // beams between walls that are not parallel: as far as the shortest
    add_panels(rows, *floors[index].beams.deck, deck);
  }
  if (deck.bars.empty())
    throw InputError(key_of(index, "deck"), "spans nothing: no room has two beams, each with two elements between the walls");
  return deck;
}

}  // namespace voussoir::cases
