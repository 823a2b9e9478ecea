// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "cases/house/house_plan.h"
#include "cases/walls/wall_case.h"
#include "geometry/polygon.h"
#include "geometry/vec3.h"

/// The plan of walls: straight parts, places where they meet, openings, courses. Internal to cases/.
///
/// A leg is a part of a wall from corner to corner. Its own coordinates: s along its middle line, d across from the middle line to the
/// left, height. All blocks are upright prisms, so a course is a division of the plan into convex polygons.
namespace voussoir::cases {

constexpr double kPlanTolerance = 1e-6;  // m: less is nothing; geometry takes planes so near for one

/// A straight part of a leg. Points and directions have z = 0.
struct Facet {
  Vec3 from;            // m, on the middle line
  Vec3 along, across;   // unit vectors; across: to the left
  double start = 0.0;   // m, of s
  double length = 0.0;  // m
  double place = 0.0;   // m, of its start along the wall's line from the first point
};

/// A plane across a leg: s = at + slope * d.
struct LegCut {
  double at = 0.0, slope = 0.0;
  [[nodiscard]] double operator()(double d) const noexcept { return at + slope * d; }
};

/// Which end of a leg a meeting is at.
enum class LegEnd { low, high, none };

/// The strip of another leg across a leg.
struct Station {
  std::size_t meeting = 0;  // index into WallsPlan::meetings
  bool host = false;        // whether this leg is the host of the meeting
  LegEnd end = LegEnd::none;
  LegCut low, high;
};

/// A place where two legs meet. The host runs through in even courses; in odd ones the guests at one place do so in turn.
struct Meeting {
  std::size_t host = 0, guest = 0;  // legs
  bool toothed = true;              // false: the host runs through in all courses
  int turn = 0, turns = 1;          // of the guest, among all at its place
};

/// What a part of a leg without bricks is: an opening, the seat of its lintel, or the frame of its arch.
enum class HoleKind { opening, lintel, arch };

/// A part of a leg without bricks.
struct LegHole {
  double low = 0.0, high = 0.0;  // m, of s
  Interval height;               // above the base
  std::size_t opening = 0;       // of the wall
  HoleKind kind = HoleKind::opening;
};

/// A part of a leg that the end of a beam fills, from a face inwards or from face to face.
struct Pocket {
  LegCut low, high;
  double from = 0.0, to = 0.0;  // m, of d
  Interval height;              // above the base
  std::size_t floor = 0;        // of the case
};

/// A part of a leg that rises above the height of its wall: a gable, a parapet. Bricks of its courses are cut to it.
struct Hill {
  geometry::Polygon under;      // (s, height above the base) [m], convex, counter-clockwise, from the height of the wall up
  double from = 0.0, to = 0.0;  // m, range of s
  double crown = 0.0;           // m
  Tick last = 0;                // where its uppermost course begins, which reaches to the crown
  std::string key;              // of the case
};

struct Leg {
  std::size_t wall = 0;  // of the case
  std::string tag;       // "street wall"; of several legs "street 2 wall"; not along x or y: "street 2 walling", for
                         // drift is measured of walls along x or y
  double half = 0.0;     // m, half the thickness
  double line = 0.0;     // m, d of the wall's line
  bool ring = false;     // closed without a corner: s goes on at 0
  std::vector<Facet> facets;
  std::vector<Station> stations;  // ascending
  std::vector<LegHole> holes;     // ascending
  std::vector<Pocket> pockets;
  std::vector<Hill> hills;    // ascending
  Tick eaves = 0;             // above the base: the height of its wall
  int storey = 1;             // number of its lowest storey
  std::vector<Tick> storeys;  // above the base, ascending: where its others begin
  Interval height;            // above the base, up to the highest of its hills

  [[nodiscard]] double length() const noexcept { return facets.back().start + facets.back().length; }
  /// The point (s, d) in plan; across a bend d runs along the bisector.
  [[nodiscard]] Vec3 at(double s, double d) const noexcept;
  /// The place along the wall's line from its first point, as in the case [m]. \param s  may lie beyond the ends
  [[nodiscard]] double place(double s) const noexcept;
  [[nodiscard]] const Station* end(LegEnd which) const noexcept;
  /// The highest that bricks reach between two places [m, of s], above the base.
  [[nodiscard]] double highest(double from, double to) const noexcept;
  /// The lowest top of the leg between two places [m, of s], above the base.
  [[nodiscard]] double lowest_top(double from, double to) const noexcept;
};

/// A course of the walls that are joined; all of them have the same.
using Courses = std::vector<Interval>;

/// A face of a leg: d is constant.
struct WallFace {
  std::size_t leg = 0;
  double d = 0.0;  // m
};

/// The ground between two faces. Its own coordinates: u across the beams, along the first wall; v along them, from the first to the second.
struct Bay {
  Vec3 from, across, along;       // origin, unit vectors of u and v; z = 0
  std::array<WallFace, 2> faces;  // those that look at each other
  double low = 0.0, high = 0.0;   // m, range of u in which both lie

  [[nodiscard]] Vec3 at(double u, double v) const noexcept { return from + u * across + v * along; }
};

/// A beam in plan: its range of u, and v of its ends at the lower and the higher u.
struct BayBeam {
  Interval across;
  std::array<std::array<double, 2>, 2> ends{};  // m, by end, by side
};

/// A wall that stands upon one of the two between which a floor spans, along it. Where it is thinner, beams lie on the ledge before it.
struct WallUpon {
  std::size_t leg = 0, side = 0;
  double inner = 0.0;    // m, d of its face to the bay
  double setback = 0.0;  // m, of that face behind the inner face of the side; negative: before it
};

struct BayFloor {
  Bay bay;
  Interval height;                          // above the base
  std::vector<std::vector<BayBeam>> rooms;  // between the walls that meet the two
  std::vector<std::size_t> between;         // legs that bound rooms, or that beams go through
  std::vector<WallUpon> upon;
  std::vector<Interval> levels, undersides;  // above the base, ascending: where the beams may end above, and below at the level of the case
};

struct WallsPlan {
  std::vector<Leg> legs;
  std::vector<Meeting> meetings;
  std::vector<std::size_t> group;  // by wall: walls that meet have the same
  std::vector<Courses> courses;    // by group
  std::vector<HousePlan> bricks;   // by wall: size of its bricks and its bond, for wythes()
  std::vector<BayFloor> floors;    // by floor of the case
  std::vector<Bay> roofs;          // by roof of the case
  std::vector<Bay> vaults;         // by vault of the case; empty unless it is a barrel
  bool storeys = false;            // whether any wall has a second storey
};

/// Checks all walls, and what spans between them, and lays out their plan. \throw InputError, or InputErrors with all that is at fault
WallsPlan plan_walls(const std::vector<WallSpec>& walls, const WallSpans& spans = {});

/// The heights up to which the other leg of a station rises there.
Interval height_there(const WallsPlan& plan, const Station& s);

/// Key of a wall: "wall[1].points".
std::string wall_key(std::size_t wall, const char* field);

/// Least length of a piece of a wall [m]: a fifth of a brick.
double least_piece(const WallSpec& wall) noexcept;

/// The layers of a course from the right face to the left: cases/house/house_wall.h.
struct Wythe;
std::vector<Wythe> wythes_of(const WallSpec& wall, const HousePlan& bricks, int course);

}  // namespace voussoir::cases
