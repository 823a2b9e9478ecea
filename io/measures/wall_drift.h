// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/measures/building.h"
#include "io/replay/placed_elements.h"

namespace voussoir::io {

/// Out-of-plane drift of a wall: displacement of its top normal to its plane, relative to its foot, over its height; outward is positive.
/// The top is cut into pieces of about 1 m, and the piece that is displaced most counts, by the mean over its elements that have not
/// fallen. So a panel that leans between its neighbours is seen and a loose brick is not. Nothing of a wall that does not stand: at least
/// half of its uppermost course has fallen. \param fallen  1 for each element that has
std::optional<double> wall_drift(const Wall& wall, const std::vector<Pose>& start, const std::vector<Pose>& poses,
                                 const std::vector<std::uint8_t>& fallen);

}  // namespace voussoir::io
