// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>

#include "cases/case.h"
#include "geometry/polyhedron.h"
#include "io/output/drawing/svg.h"

/// What a drawing says about lengths and directions. Points of the sheet in user units, y downwards.
namespace voussoir::io {

/// Where a view of a drawing puts a point of the model [m].
using Projection = std::function<geometry::Point2(Vec3)>;

/// A length in words, without its unit: "0.25".
std::string metres_text(double metres);

/// A line from `a` to `b` with strokes at its ends and its length in m in words beside its middle: above it where it lies across, else to
/// its right. \param metres  the length
void draw_dimension(Svg& svg, geometry::Point2 a, geometry::Point2 b, double metres);

/// Of the openings in one wall: width, height and sill within the opening; below the wall the pieces between corners and openings.
/// \param wall  front | rear | left | right \param box  of the model \param below  distance of the pieces from the foot of the wall.
/// Nothing for houses that are turned or stand several in a case.
void draw_opening_dimensions(Svg& svg, const cases::Case& c, const std::string& wall, const geometry::Box3& box, const Projection& at,
                             double below);

/// Thickness of the walls in a plan. \param z  of the section [m]
void draw_thicknesses(Svg& svg, const cases::Case& c, double z, const Projection& at);

/// Those of the axes x, y, z that lie in the picture, as arrows from `corner`. \param right, up  of the view, in the model
void draw_axes(Svg& svg, geometry::Point2 corner, Vec3 right, Vec3 up);

/// A bar of some metres. \param scale  units per metre
void draw_scale_bar(Svg& svg, geometry::Point2 left, double scale);

}  // namespace voussoir::io
