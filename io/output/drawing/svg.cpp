// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/svg.h"

#include "geometry/message.h"

namespace voussoir::io {
namespace {

/// A number to a hundredth of a unit, finer than the resolution of screens and printers.
std::string number(double value) { return geometry::printed("%.2f", value); }

std::string attribute(const char* name, std::string_view value) { return " " + std::string(name) + "=\"" + std::string(value) + "\""; }
std::string attribute(const char* name, double value) { return attribute(name, number(value)); }

std::string escaped(std::string_view words) {
  std::string out;
  for (const char c : words) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

Svg::Svg(double width, double height) {
  out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) + attribute("height", height) +
         " font-family=\"sans-serif\" stroke-linejoin=\"round\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
}

void Svg::polygon(std::span<const geometry::Point2> corners, std::string_view fill, std::string_view edge) {
  out_ += "<path" + attribute("stroke", edge) + " stroke-width=\"0.5\"" + attribute("fill", fill) + " d=\"";
  char command = 'M';
  for (const geometry::Point2 p : corners) {
    out_ += command + number(p.s) + " " + number(p.t);
    command = 'L';
  }
  out_ += "Z\"/>\n";
}

void Svg::line(geometry::Point2 from, geometry::Point2 to, std::string_view colour, double width) {
  out_ += "<line" + attribute("x1", from.s) + attribute("y1", from.t) + attribute("x2", to.s) + attribute("y2", to.t) +
          attribute("stroke", colour) + attribute("stroke-width", width) + "/>\n";
}

void Svg::circle(geometry::Point2 centre, double radius, std::string_view fill) {
  out_ += "<circle" + attribute("cx", centre.s) + attribute("cy", centre.t) + attribute("r", radius) + attribute("fill", fill) + "/>\n";
}

void Svg::text(geometry::Point2 at, std::string_view words, double size, std::string_view anchor, std::string_view colour) {
  out_ += "<text" + attribute("x", at.s) + attribute("y", at.t) + attribute("font-size", size) + attribute("text-anchor", anchor) +
          attribute("fill", colour) + " paint-order=\"stroke\" stroke=\"white\" stroke-width=\"3\">" + escaped(words) + "</text>\n";
}

std::string Svg::finish() && { return std::move(out_) + "</svg>\n"; }

}  // namespace voussoir::io
