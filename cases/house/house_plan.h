// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/house/house_case.h"
#include "cases/input_error.h"

/// The checked plan of a house in exact lengths, shared by the builders of its parts (house_wall, house_roof). Internal to cases/.
namespace voussoir::cases {

/// A length in whole nanometres. Planes that should coincide do so exactly, and a fit to the grid is a zero remainder instead of a
/// tolerance.
using Tick = std::int64_t;

Tick ticks(double metres) noexcept;
/// The double nearest to the decimal length [m]: the same bits wherever a plane is written.
double metres(Tick t) noexcept;

/// The length in metres, for messages.
std::string metres_text(Tick t);

struct Interval {
  Tick low = 0, high = 0;
  [[nodiscard]] constexpr Tick length() const noexcept { return high - low; }
  [[nodiscard]] constexpr bool overlaps(Interval o) const noexcept { return low < o.high && o.low < high; }
  friend constexpr bool operator==(Interval, Interval) = default;
};
/// Text "from 0.2 to 1.2 m".
std::string from_to(Interval i);

/// Outer walls in the order in which a course goes round the house.
enum class Side : std::uint8_t { front, right, rear, left };
const char* name(Side side) noexcept;

/// A part of a wall without bricks: an opening, the seat of its lintel, the pocket of a beam, an arch, or ground. `opening` indexes
/// House::openings.
struct Hole {
  Interval along, height;
  std::size_t opening = 0;
  bool lintel = false;
  Interval depth{};          // through the wall
  std::int32_t floor = -1;   // index into House::floors of a pocket
  std::int32_t ground = -1;  // index into House::ground, for ground in place of the wall's foot
  bool arch = false;         // the frame of an arch, without the space under its soffit
};

/// A place where another wall meets or crosses a wall, or a pier stands at it.
struct Crossing {
  Interval along, height;
};

/// One wall of one storey in plan; or a pier, a short wall perpendicular to another. Its own coordinates: along (x or y of the house),
/// depth (from the outer face; of an inner wall and a pier from the face nearer to the origin), height.
struct WallPlan {
  Side side = Side::front;  // of an outer wall; for a pier: the wall at which it stands
  std::int32_t inner = -1;  // index into House::inner_walls
  std::int32_t pier = -1;   // index into House::piers
  int storey = 0;           // from 0
  bool along_x = false;     // where walls meet, walls along x run through in even courses
  Tick at = 0;              // position of depth 0 of an inner wall or a pier
  Tick from = 0;            // beginning along the wall; below 0: a pier out of the front or the left wall
  Tick length = 0;          // outer length
  Tick thickness = 0;
  Tick corner = 0;  // thickness of the outer walls that it meets
  Tick leaf = 0;    // thickness of its outer leaf; 0: a wall of one leaf
  Interval height;
  bool built = true;
  std::array<bool, 2> meets{true, true};  // whether an outer wall is at its low and its high end
  std::vector<Crossing> crossings;        // walls and piers that run through in every second course, ascending
  std::vector<Hole> holes;

  /// Whether the wall is a side of the house; neither an inner wall nor a pier.
  [[nodiscard]] bool outer() const noexcept { return inner < 0 && pier < 0; }
};

/// The beams of House::floors[i]: range along the beams, heights, and by room the range of each beam across.
struct FloorPlan {
  Interval length, height;
  std::vector<std::vector<Interval>> rooms;
};

struct HousePlan {
  Tick brick_length = 0, brick_width = 0, brick_height = 0;  // including mortar
  Bond bond = Bond::english;
  Tick height = 0;                   // of all storeys together
  std::vector<Interval> courses;     // heights, common to all walls
  std::array<Tick, 2> outer{};       // along x and y
  std::vector<Interval> storeys;     // heights
  std::vector<WallPlan> walls;       // storey by storey: outer walls by Side, then inner walls; piers after all storeys
  std::vector<FloorPlan> floors;     // by House::floors
  std::vector<bool> opening_stands;  // by House::openings: its heights are within its wall
  int quarter_turns = 0;             // 0 to 3
  Faults faults;                     // what of the house does not fit; what depends on it alone is left out, and a length that does not fit
                                     // the bricks is laid out as the nearest one that does

  /// An outer wall of a storey.
  [[nodiscard]] const WallPlan& wall(Side side, int storey) const noexcept;
  /// The outer wall of the uppermost storey, on which the roof lies.
  [[nodiscard]] const WallPlan& wall(Side side) const noexcept { return wall(side, static_cast<int>(storeys.size()) - 1); }
  /// The outer wall of the storey that contains a height.
  [[nodiscard]] const WallPlan& wall_at(Side side, Tick at) const noexcept;
  [[nodiscard]] int course_count() const noexcept { return static_cast<int>(courses.size()); }
  /// Least height of a course: half a brick.
  [[nodiscard]] Tick lowest_course() const noexcept { return (brick_height + 1) / 2; }
  /// Least length of a piece of wall: half a brick.
  [[nodiscard]] Tick shortest_piece() const noexcept { return brick_length / 2; }
};

/// "front wall", "middle wall", "front pier": without the storey.
std::string wall_name(const House& house, const WallPlan& wall);
/// The tag of a wall's bricks: "front wall", in a house of several storeys "front wall, storey 1". \param what  "wall", "gable"
std::string wall_tag(const House& house, const WallPlan& wall, const char* what = "wall");

/// Checks all keys of a house, and lays out walls and holes.
/// \throw InputError with the key at fault.
HousePlan plan_house(const House& house);

/// The same, with faults in HousePlan::faults where what is beside them can be laid out all the same.
/// \throw InputError where it cannot
HousePlan plan_as_far_as_possible(const House& house);

/// Length, width and height of a brick including mortar [m].
std::array<double, 3> brick_with_mortar(const House& house) noexcept;

/// The parts of a layer of a wall that a course fills with bricks, ascending. Where walls meet or cross, walls along x run through in even
/// courses, the others in odd courses; a wall that meets none runs to its end in all courses. Empty for a wall that is not built, or not in
/// this storey.
std::vector<Interval> free_spans(const HousePlan& plan, const WallPlan& wall, int course, Interval depth);

/// A positive length as ticks. \throw InputError at `key` if it is not above zero, or beyond 10 km.
Tick positive_length(double value, const std::string& key);

/// Element length of a member of the length `member`. \throw InputError at `key` if it is not above zero, or would give more than a
/// thousand elements.
Tick element_length(double value, Tick member, const std::string& key);

/// Divides a timber member into elements of the length `element` from its low end. A remainder of half an element or more is a separate
/// element; a shorter remainder shares its length with the last whole element, so that no sliver limits the time step.
std::vector<Interval> cut_member(Interval member, Tick element);

}  // namespace voussoir::cases
