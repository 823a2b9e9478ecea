// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/walls/wall_plan.h"
#include "geometry/polyhedron.h"

/// Between which walls floors and roofs span. Internal to cases/.
namespace voussoir::cases {

constexpr double kLeastSine = 0.5 - 1e-9;  // of 30 degrees, between a wall and what it meets
constexpr double kSquare = 1e-6;           // rad, off a right angle

inline Vec3 left_of(Vec3 v) noexcept { return {-v.y, v.x, 0.0}; }

/// "outer 2" of the leg "outer 2 wall": the name of a side in the case.
std::string side_name(const Leg& leg);

/// The leg of a side. \throw InputError at `key`: no such side, or the name of a wall with several
std::size_t find_side(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::string& name, const std::string& key);

/// What spans: the words of its keys. \param list  "floor", "roof" or "vault"
struct Spanning {
  const char* list;
  std::size_t index;
  [[nodiscard]] std::string key(const char* field) const;
};

/// The top of a wall as the case gives it, without gables.
Tick eaves(const WallSpec& wall);

/// The bay between two sides. \param direction  of its v; none: square to the first side \param corners  that bound u; may be empty
/// \throw InputError: sides that do not exist, bend, do not face each other, or at an angle below 30 degrees with the direction
Bay find_bay(const std::vector<WallSpec>& walls, const WallsPlan& plan, const Spanning& what, const std::vector<std::string>& sides,
             const std::optional<std::array<double, 2>>& direction, const std::vector<std::array<double, 2>>& corners);

/// v at which the line of constant d of a leg crosses u [m].
double v_of(const WallsPlan& plan, const Bay& bay, WallFace line, double u);

/// The plane of constant u as a cut through a leg.
LegCut cut_at(const Leg& leg, const Bay& bay, double u);

/// The quadrangle between two ranges of u, counter-clockwise seen from above. \param begin, end  v at the lower and the higher u
std::array<Vec3, 4> in_bay(const Bay& bay, const std::array<double, 2>& u, const std::array<double, 2>& begin,
                           const std::array<double, 2>& end);

/// Bounds the range of u by a quadrilateral: what lies in it on both faces. \param slack  m, of all its edges
void bound(const WallsPlan& plan, const Spanning& what, const std::vector<std::array<double, 2>>& corners, double slack, Bay& bay);

/// Sets the range of u to that from end to end of both sides, with what other walls fill of it.
void reach_to_ends(const WallsPlan& plan, Bay& bay);

/// Refuses sides that are not parallel, or whose walls end at two heights. \param why  the end of both messages
void check_level_pair(const std::vector<WallSpec>& walls, const WallsPlan& plan, const Spanning& what, const Bay& bay,
                      const std::array<const char*, 2>& why);

/// What stands on a bay between parallel sides, in axes of its own: x along the ridge, y from the inner face of the first side, z up.
class BayAxes {
 public:
  BayAxes(const WallsPlan& plan, const Bay& bay);
  [[nodiscard]] double length() const noexcept { return length_; }  // m, range of x
  [[nodiscard]] double span() const noexcept { return span_; }      // m, between the inner faces
  [[nodiscard]] const Bay& bay() const noexcept { return *bay_; }
  [[nodiscard]] Vec3 in_case(Vec3 p) const noexcept;
  /// A solid, its cells in the usual order where the axes are left-handed, too.
  [[nodiscard]] geometry::Polyhedron in_case(geometry::Polyhedron shape) const;

 private:
  const Bay* bay_;
  double length_ = 0.0, from_ = 0.0, span_ = 0.0;  // from_: v of the first side's inner face
  bool mirrored_ = false;
};

/// Raises a side that stands square under a span to a line. \param key  names the side \param line  (y, z), from the first side to the
/// second; its ends are at the top of the walls \param what  it is raised to, for messages
void raise_to(const std::vector<WallSpec>& walls, const std::string& side, const std::string& key, const BayAxes& axes,
              const geometry::Polygon& line, const Spanning& what, WallsPlan& plan);

/// The outline of a facet of a leg, up to the far faces of the walls in which it ends.
geometry::Polygon outline_of(const Leg& leg, std::size_t facet);

/// Whether a point lies in the outline of a leg, its edge included.
bool lies_in(const Leg& leg, Vec3 p);

}  // namespace voussoir::cases
