// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>

#include "cases/forward.h"
#include "geometry/polyhedron.h"
#include "io/output/drawing/svg.h"

/// Dimensions, axes and scale of a drawing. Points of the sheet are in user units, y downwards.
namespace voussoir::io {

/// Projection of a point of the model [m] to the sheet.
using Projection = std::function<geometry::Point2(Vec3)>;

/// A length without its unit: "0.25".
std::string metres_text(double metres);

/// Draws a line from `a` to `b` with strokes at its ends and its length in m beside its middle: above a horizontal line, to the right of
/// others. \param metres  the length
void draw_dimension(Svg& svg, geometry::Point2 a, geometry::Point2 b, double metres);

/// Draws the dimensions of the openings in one wall: width, height and sill within the opening; below the wall the lengths between corners
/// and openings. Draws nothing for rotated houses, or several in a case.
/// \param wall  front | rear | left | right \param box  of the model \param below  distance of the lower dimensions from the foot of the
/// wall
void draw_opening_dimensions(Svg& svg, const cases::Case& c, const std::string& wall, const geometry::Box3& box, const Projection& at,
                             double below);

/// Draws the thickness of the walls in a plan. \param z  height of the section [m]
void draw_thicknesses(Svg& svg, const cases::Case& c, double z, const Projection& at);

/// Draws as arrows from `corner` the axes x, y, z that lie in the picture plane. \param right,  up directions of the view in the model
void draw_axes(Svg& svg, geometry::Point2 corner, Vec3 right, Vec3 up);

/// Draws a scale bar. \param scale  units per metre
void draw_scale_bar(Svg& svg, geometry::Point2 left, double scale);

}  // namespace voussoir::io
