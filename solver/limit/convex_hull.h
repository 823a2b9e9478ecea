// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace voussoir::solver {

/// Indices of the points that are corners of their convex hull, counter-clockwise (Andrew 1979). For points on a line its two ends, for
/// coinciding points one of them. A corner within 1e-9 of the hull's size of the line between its neighbours is left out, so that points on
/// a line keep both ends in spite of round-off, however the line is rotated or moved.
std::vector<std::size_t> hull_corners(const std::vector<geometry::Point2>& points);

}  // namespace voussoir::solver
