// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/walls/wall_plan.h"

/// Between which walls floors and roofs span. Internal to cases/.
namespace voussoir::cases {

/// "outer 2" of the leg "outer 2 wall": the name of a side in the case.
std::string side_name(const Leg& leg);

/// The leg of a side. \throw InputError at `key`: no such side, or the name of a wall with several
std::size_t find_side(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::string& name, const std::string& key);

/// What spans: the words of its keys. \param list  "floor" or "roof"
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

/// The outline of a facet of a leg, up to the far faces of the walls in which it ends.
geometry::Polygon outline_of(const Leg& leg, std::size_t facet);

}  // namespace voussoir::cases
