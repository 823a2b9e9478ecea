// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace voussoir::solver {

/// Which of the points are the corners of their convex hull, counter-clockwise (Andrew 1979). Of points on a line its two ends, of points
/// at one place one of them. A corner that lies within 1e-9 of the hull's size of the line between its neighbours is left out: no set of
/// points on a line, however it is turned or moved, loses an end by round-off.
std::vector<std::size_t> hull_corners(const std::vector<geometry::Point2>& points);

}  // namespace voussoir::solver
