// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace voussoir::geometry {

/// A point in the plane of a face [m].
struct Point2 {
  double s = 0.0, t = 0.0;
  friend constexpr bool operator==(const Point2&, const Point2&) = default;
};

/// Corners of a convex polygon, counter-clockwise.
using Polygon = std::vector<Point2>;

struct Rectangle {
  Point2 low, high;
};

/// Area [m2] and centroid [m] of a polygon.
struct Region {
  double area = 0.0;
  Point2 centroid;
};

/// Area and centroid, computed relative to the first corner, so a small polygon far from the origin keeps its digits. Fewer than 3 corners:
/// area 0.
Region region(std::span<const Point2> polygon);

/// Bounding rectangle [m]. \pre the polygon is not empty
Rectangle bounds(std::span<const Point2> polygon);

/// The rectangle that equals the polygon exactly (four corners, sides along s and t), else nothing.
std::optional<Rectangle> as_rectangle(std::span<const Point2> polygon);

Polygon to_polygon(const Rectangle& r);

/// Keeps the part of the polygon with normal · p <= offset. `scratch` is overwritten.
void clip(Polygon& polygon, Point2 normal, double offset, Polygon& scratch);

/// Intersection of two convex polygons; empty where they share no area. Rectangles give a rectangle without round-off.
Polygon intersection(const Polygon& a, const Polygon& b);

}  // namespace voussoir::geometry
