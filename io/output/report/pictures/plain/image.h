// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voussoir::io {

/// A colour as screens show it (sRGB), each part from 0 to 1.
struct Rgb {
  double red = 0.0, green = 0.0, blue = 0.0;
};
constexpr Rgb operator*(double f, Rgb c) noexcept { return {f * c.red, f * c.green, f * c.blue}; }
/// From a to b, as t goes from 0 to 1.
constexpr Rgb mixed(Rgb a, Rgb b, double t) noexcept {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

/// Pixels, three bytes each (red, green, blue), row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The bytes of a PNG file (W3C recommendation, 2003): 8 bits a channel, no palette.
std::string png_of(const Image& image);

}  // namespace voussoir::io
