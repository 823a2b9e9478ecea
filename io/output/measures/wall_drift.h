// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/output/measures/building.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {

/// Which way a wall's top is displaced.
enum class DriftDirection { out_of_plane, in_plane };

/// Drift of a wall: displacement of its top, relative to its foot, over its height: normal to its plane, outward positive, or in its plane,
/// along x or y, whichever the wall runs along.
/// The top is cut into pieces of about 1 m, and the piece that is displaced most counts, by the mean over its elements that are part of the
/// wall still: they have not fallen, are no more than 1 m in plan from where the middle (median) element of their piece has gone, and no
/// farther from their own place than the wall is high. So a panel that leans between its neighbours is seen, and a brick that flew off is
/// not, even if it rose. Nothing of a wall that does not stand: at least half of its uppermost course is gone.
/// \param fallen  1 for each element that has
std::optional<double> wall_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                 const std::vector<std::uint8_t>& fallen, DriftDirection direction = DriftDirection::out_of_plane);

}  // namespace voussoir::io
