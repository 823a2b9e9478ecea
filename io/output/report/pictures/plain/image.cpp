// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/pictures/plain/image.h"

#include <zlib.h>

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace voussoir::io {
namespace {

std::string big_endian(std::uint32_t n) {
  std::string out;
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>((n >> static_cast<unsigned>(shift)) & 255U);
  return out;
}

std::string chunk(std::string_view kind, std::string_view data) {
  const std::string body = std::string(kind) + std::string(data);
  const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(sum));
}

std::string deflated(const std::string& data) {
  uLongf size = ::compressBound(static_cast<uLong>(data.size()));
  std::string out(size, '\0');
  if (::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()), static_cast<uLong>(data.size()),
                  Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  out.resize(size);
  return out;
}

/// Rows, each behind its kind of filter: 2, differences from the row above, which are small.
std::string filtered(const Image& image) {
  constexpr char kUp = 2;
  const std::size_t row = 3 * static_cast<std::size_t>(image.width);
  std::string out;
  out.reserve((row + 1) * static_cast<std::size_t>(image.height));
  for (std::size_t at = 0; at < image.rgb.size(); ++at) {
    if (at % row == 0) out += kUp;
    out += static_cast<char>(image.rgb[at] - (at < row ? 0 : image.rgb[at - row]));
  }
  return out;
}

}  // namespace

std::string png_of(const Image& image) {
  constexpr std::string_view kTrueColour("\x08\x02\x00\x00\x00", 5);  // depth, colour type, and the only compression, filter, order
  const std::string head = big_endian(static_cast<std::uint32_t>(image.width)) + big_endian(static_cast<std::uint32_t>(image.height));
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head + std::string(kTrueColour)) + chunk("IDAT", deflated(filtered(image))) +
         chunk("IEND", "");
}

}  // namespace voussoir::io
