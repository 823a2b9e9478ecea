// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "geometry/polygon.h"

/// Writes an SVG document shape by shape. Lengths in user units, y downwards.
namespace voussoir::io {

class Svg {
 public:
  Svg(double width, double height);

  /// Adds a closed polygon with thin edges. `fill` and `edge` are colours.
  void polygon(std::span<const geometry::Point2> corners, std::string_view fill, std::string_view edge = "#4a3728");
  void line(geometry::Point2 from, geometry::Point2 to, std::string_view colour, double width);
  void circle(geometry::Point2 centre, double radius, std::string_view fill);
  /// Adds a text. `anchor`: start, middle or end.
  void text(geometry::Point2 at, std::string_view words, double size, std::string_view anchor = "start", std::string_view colour = "#222");

  /// The complete document.
  [[nodiscard]] std::string finish() &&;

 private:
  std::string out_;
};

}  // namespace voussoir::io
