// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"

/// Points and weights of SegmentRule::rim: quadrature of a convex polygon with points at all its corners.
namespace voussoir::geometry {

/// Appends quadrature points in the coordinates of the polygon [m] and their weights [m2]. All weights are positive; they sum to the
/// polygon's area (about 1e-15 relative) and give its first and second moments exactly, since the rules are exact to the third degree.
///
/// Four corners (a rectangle, any convex quadrilateral): a product of two Gauss-Lobatto rules under the bilinear map of a square, row by
/// row. An edge of n = max(1, round(edge / size)) cells, of two opposite edges the longer, has panels of 4 points (3 for n < 4 and n = 5)
/// that share their ends: 3, 3, 3, 4, 5, 7, 7, 7, 10 points for n from 1 to 9, then 3 round((n − 1) / 3) + 1.
/// Three corners: a rule of 7 points (corners, middles of edges, centroid) on equal triangles with edges of about two cells. More corners:
/// the 7-point rule on each triangle from the centroid to an edge; coincident points become one.
///
/// Corners nearer than 1e-11 m to each other, or to the line through their neighbours, are ignored.
/// \pre convex, counter-clockwise, size > 0
void append_rim_points(const Polygon& polygon, double size, std::vector<Segment>& out);

/// Appends the corners of the polygon [m] as points with weights [m2] that are positive, sum to its area and give its first moments exactly
/// (SegmentRule::corners). A triangle from the centroid to an edge gives a third of its area to each of its corners; the third of the
/// centroid goes to all corners by Wachspress' coordinates, so that of a parallelogram all weights are equal.
/// Corners nearer than 1e-11 m to each other, or to the line through their neighbours, are ignored.
/// \pre convex, counter-clockwise
void append_corner_points(const Polygon& polygon, std::vector<Segment>& out);

/// The polygon with its edges moved inward by `inset` [m]; where nothing would be left, a copy of half the size about its centroid.
/// \pre the polygon has an area
Polygon moved_in(const Polygon& polygon, double inset);

/// Appends convex polygons that make up the part of `a` outside `b`. \pre both convex, counter-clockwise
void append_difference(const Polygon& a, const Polygon& b, std::vector<Polygon>& out);

}  // namespace voussoir::geometry
