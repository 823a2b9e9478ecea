// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/output/measures/building/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Direction of the displacement of a wall's top.
enum class DriftDirection { out_of_plane, in_plane };

/// Drift of a wall: displacement of its top, relative to its foot, over its height: normal to its plane, outward positive, or in its plane,
/// along the axis x or y of the wall.
/// The top is divided into pieces of about 1 m. The drift is that of the piece displaced most, as the mean over its elements that are still
/// part of the wall: not fallen, at most 1 m in plan from the displaced median element of their piece, and displaced by no more than the
/// wall's height. Thus a panel leaning between its neighbours counts, and a brick that flew off does not, even if it rose. Nothing for a
/// wall that does not stand, i.e. has lost at least half of its uppermost course.
/// \param fallen  by element, 1: fallen
std::optional<double> wall_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                 const std::vector<std::uint8_t>& fallen, DriftDirection direction = DriftDirection::out_of_plane);

/// Storey drift of a wall: mean displacement of its whole uppermost course along the wall, less that of its lowest course, over its height;
/// positive to the right as seen from outside, of an inner wall along +x or +y. Of elements that are still part of the wall, as in
/// wall_drift. Nothing for a wall that does not stand.
std::optional<double> storey_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                   const std::vector<std::uint8_t>& fallen);

}  // namespace voussoir::io
