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

/// Compact encoding of numbers for a page: rounded, as differences, deflated, in base64.
namespace voussoir::io {

/// Base64 by RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);
/// Decodes base64; stops at the first character that is no base64 digit.
[[nodiscard]] std::vector<std::byte> from_base64(std::string_view text);

/// Deflates data appended in pieces, in the zlib format (RFC 1950), which a browser's DecompressionStream("deflate") reads.
class Deflater {
 public:
  Deflater();
  ~Deflater();
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void append(std::span<const std::byte> bytes);
  /// All compressed data in base64. Nothing can be appended afterwards.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The bytes of the values, deflated, in base64.
template <class T>
[[nodiscard]] std::string packed(std::span<const T> values) {
  Deflater d;
  d.append(std::as_bytes(values));
  return d.finish();
}

/// Greatest absolute value of a 16-bit step number.
inline constexpr double kQuantaOfASide = 32767;

/// `value` in units of `quantum`, rounded to nearest and clamped to 16 bits.
[[nodiscard]] std::int16_t quantised(double value, double quantum) noexcept;

/// The difference of two 16-bit numbers, modulo 2^16, in zigzag coding: 0, -1, 1, -2 become 0, 1, 2, 3, so that small steps of either sign
/// are small numbers.
[[nodiscard]] std::uint16_t zigzag_step(std::int16_t from, std::int16_t to) noexcept;

}  // namespace voussoir::io
