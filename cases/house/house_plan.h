// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/case.h"

/// The checked plan of a house in exact lengths, shared by the rooms that build its parts (house_wall, house_roof). Internal to cases/.
namespace voussoir::cases {

/// A length in whole nanometres. Planes that should coincide do so exactly, and "fits the grid" is a remainder, not a tolerance.
using Tick = std::int64_t;

Tick ticks(double metres) noexcept;
/// The double nearest to the decimal length, the same bits wherever the same plane is written.
double metres(Tick t) noexcept;

/// Its metres in a message.
std::string metres_text(Tick t);

struct Interval {
  Tick low = 0, high = 0;
  [[nodiscard]] constexpr Tick length() const noexcept { return high - low; }
  [[nodiscard]] constexpr bool overlaps(Interval o) const noexcept { return low < o.high && o.low < high; }
  friend constexpr bool operator==(Interval, Interval) = default;
};
/// "from 0.2 to 1.2 m"
std::string from_to(Interval i);

/// Walls in the order in which a course goes round the house.
enum class Side : std::uint8_t { front, right, rear, left };
const char* name(Side side) noexcept;

/// A place in a wall without bricks: an opening, the seat of its lintel, the pocket of a beam, an arch, or ground. `opening` indexes
/// House::openings.
struct Hole {
  Interval along, height;
  std::size_t opening = 0;
  bool lintel = false;
  Interval depth{};          // through the wall
  std::int32_t floor = -1;   // into House::floors: a pocket
  std::int32_t ground = -1;  // into House::ground: in place of the wall's foot
  bool arch = false;         // the frame that an arch fills, but for the room under its soffit
};

/// Where another wall meets or crosses one, or a pier stands at it.
struct Crossing {
  Interval along, height;
};

/// One wall of one storey, a line of its plan; or a pier, a short wall out of another one. Its own coordinates: along (x or y of the
/// house), depth (from the outer face; of an inner wall and a pier from that nearer to the origin), height.
struct WallPlan {
  Side side = Side::front;  // of an outer wall; of a pier: the wall at which it stands
  std::int32_t inner = -1;  // into House::inner_walls
  std::int32_t pier = -1;   // into House::piers
  int storey = 0;           // from 0
  bool along_x = false;     // where walls meet, those along x run through even courses
  Tick at = 0;              // of an inner wall and a pier: depth 0
  Tick from = 0;            // where it begins; below 0: a pier out of the front or the left wall
  Tick length = 0;          // outer
  Tick thickness = 0;
  Tick corner = 0;  // thickness of the outer walls it meets
  Tick leaf = 0;    // thickness of its outer leaf; 0: a wall of one leaf
  Interval height;
  bool built = true;
  std::array<bool, 2> meets{true, true};  // an outer wall at its low and its high end
  std::vector<Crossing> crossings;        // what it gives way to in every second course, ascending
  std::vector<Hole> holes;

  /// One side of the house; neither an inner wall nor a pier.
  [[nodiscard]] bool outer() const noexcept { return inner < 0 && pier < 0; }
};

/// The beams of House::floors[i], by room; each lies `across` the walls' length.
struct FloorPlan {
  Interval length, height;
  std::vector<std::vector<Interval>> rooms;
};

struct HousePlan {
  Tick brick_length = 0, brick_width = 0, brick_height = 0;  // with mortar
  Bond bond = Bond::english;
  Tick height = 0;                // of all storeys
  std::vector<Interval> courses;  // heights, of all walls
  std::array<Tick, 2> outer{};    // along x and y
  std::vector<Interval> storeys;  // heights
  std::vector<WallPlan> walls;    // storey by storey: the outer ones by Side, then the inner ones; then piers
  std::vector<FloorPlan> floors;  // by House::floors
  int quarter_turns = 0;          // 0 to 3

  /// An outer wall of a storey.
  [[nodiscard]] const WallPlan& wall(Side side, int storey) const noexcept;
  /// That of the uppermost storey, on which the roof lies.
  [[nodiscard]] const WallPlan& wall(Side side) const noexcept { return wall(side, static_cast<int>(storeys.size()) - 1); }
  /// That in whose storey a height lies.
  [[nodiscard]] const WallPlan& wall_at(Side side, Tick height) const noexcept;
  [[nodiscard]] int course_count() const noexcept { return static_cast<int>(courses.size()); }
  /// No course is lower than half a brick.
  [[nodiscard]] Tick lowest_course() const noexcept { return (brick_height + 1) / 2; }
  /// No piece of a wall is shorter than half a brick.
  [[nodiscard]] Tick shortest_piece() const noexcept { return brick_length / 2; }
};

/// "front wall", "middle wall", "front pier": without its storey.
std::string wall_name(const House& house, const WallPlan& wall);
/// Tags its bricks: "front wall", in a house of several storeys "front wall, storey 1". \param what  "wall", "gable"
std::string wall_tag(const House& house, const WallPlan& wall, const char* what = "wall");

/// Checks everything a house can get wrong in itself, and lays out walls and holes.
/// \throw InputError with the key at fault.
HousePlan plan_house(const House& house);

/// Length, width and height of a brick with its mortar, m.
std::array<double, 3> brick_with_mortar(const House& house) noexcept;

/// The parts of a layer of a wall that a course fills with bricks, ascending. Where walls meet or cross, those along x run through in even
/// courses, the others in odd ones; where a wall meets none, it runs to its end in all courses. Nothing of a wall that is not built, or
/// not in this storey.
std::vector<Interval> free_spans(const HousePlan& plan, const WallPlan& wall, int course, Interval depth);

/// A positive length of the case as ticks. \throw InputError at `key` if it is not above zero, or beyond 10 km.
Tick positive_length(double value, const std::string& key);

/// A positive length that must be a multiple of `unit`. \throw InputError at `key` with the nearest length that fits.
Tick multiple_of(double value, Tick unit, const std::string& key, const char* unit_name);

/// The length of the elements of a member `member` long. \throw InputError at `key` if it is not above zero, or would make more than a
/// thousand of them.
Tick element_length(double value, Tick member, const std::string& key);

/// Divides a timber member into elements of the length `element` from its low end. A rest of half an element or more is an element of its
/// own; a shorter one shares its length with the last whole element, so that no sliver limits the time step.
std::vector<Interval> cut_member(Interval member, Tick element);

}  // namespace voussoir::cases
