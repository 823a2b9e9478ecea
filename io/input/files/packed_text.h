// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers made small enough to stand in a page: rounded, as differences, deflated, in base64.
namespace voussoir::io {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);
/// The bytes back; anything that is no digit of base64 ends them.
[[nodiscard]] std::vector<std::byte> from_base64(std::string_view text);

/// Deflates what is appended, piece by piece, in the zlib format (RFC 1950): a browser's DecompressionStream("deflate") reads it.
class Deflater {
 public:
  Deflater();
  ~Deflater();
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void append(std::span<const std::byte> bytes);
  /// All of it in base64. Nothing can be appended afterwards.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The bytes of these values, deflated, in base64.
template <class T>
[[nodiscard]] std::string packed(std::span<const T> values) {
  Deflater d;
  d.append(std::as_bytes(values));
  return d.finish();
}

/// Steps of 16 bits to either side of zero.
inline constexpr double kQuantaOfASide = 32767;

/// `value` in units of `quantum`, rounded to the nearest; beyond the ends of 16 bits, the end.
[[nodiscard]] std::int16_t quantised(double value, double quantum) noexcept;

/// The step from one 16-bit number to the next, modulo 2^16, with small steps of either sign as small numbers: 0, -1, 1, -2 are 0, 1, 2, 3.
[[nodiscard]] std::uint16_t zigzag_step(std::int16_t from, std::int16_t to) noexcept;

}  // namespace voussoir::io
