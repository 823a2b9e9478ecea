// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/foreign_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "io/input/files/errors.h"
#include "io/input/files/text_file.h"

namespace voussoir::io {
namespace {

void add_utf8(std::string& out, char32_t c) {
  const auto add = [&out](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80U) return add(c);
  if (c < 0x800U) {
    add(0xC0U | c >> 6U);
  } else if (c < 0x10000U) {
    add(0xE0U | c >> 12U);
    add(0x80U | (c >> 6U & 0x3FU));
  } else {
    add(0xF0U | c >> 18U);
    add(0x80U | (c >> 12U & 0x3FU));
    add(0x80U | (c >> 6U & 0x3FU));
  }
  add(0x80U | (c & 0x3FU));
}

/// Number of bytes of the first character; 0 if it is not valid UTF-8.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80U) return 1;
  const std::size_t length = first < 0xC2U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : first < 0xF5U ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const bool overlong = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
  const bool beyond = (first == 0xEDU && second >= 0xA0U) || (first == 0xF4U && second >= 0x90U);
  return overlong || beyond ? 0 : length;
}

std::string from_windows_1252(std::string_view bytes) {
  // characters 0x80 to 0x9F; the others are those of Latin-1
  static constexpr std::array<char16_t, 32> kSigns{0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021, 0x2C6,  0x2030, 0x160,
                                                   0x2039, 0x152,  0x8D,   0x17D,  0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
                                                   0x2013, 0x2014, 0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};
  std::string out;
  out.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    add_utf8(out, byte >= 0x80U && byte < 0xA0U ? kSigns[byte - 0x80U] : byte);
  }
  return out;
}

std::string from_utf16(const std::string& path, std::string_view bytes, bool big_endian) {
  const auto refuse = [&path](const char* what) { throw FileError(path, std::string("is in UTF-16 and ") + what + "; save it in UTF-8"); };
  if (bytes.size() % 2 != 0) refuse("ends within a character");
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]), second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<char32_t>(big_endian ? first << 8U | second : second << 8U | first);
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    char32_t c = unit(at);
    if (c >= 0xD800U && c < 0xE000U) {
      const char32_t low = c < 0xDC00U && at + 2 < bytes.size() ? unit(at + 2) : 0U;
      if (low < 0xDC00U || low >= 0xE000U) refuse("holds half a character");
      c = 0x10000U + ((c - 0xD800U) << 10U) + (low - 0xDC00U);
      at += 2;
    }
    add_utf8(out, c);
  }
  return out;
}

}  // namespace

bool is_all_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

Utf16 utf16_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return Utf16::little_endian;
  if (bytes.starts_with("\xFE\xFF")) return Utf16::big_endian;
  constexpr std::size_t kHead = 256;
  const std::string_view head = bytes.substr(0, std::min(bytes.size() & ~std::size_t{1}, kHead));
  std::array<std::size_t, 2> zeros{};  // in even and in odd bytes
  for (std::size_t i = 0; i < head.size(); ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  const std::size_t enough = std::max<std::size_t>(1, head.size() / 8);
  if (zeros[0] == 0 && zeros[1] >= enough && head[1] == '\0') return Utf16::little_endian;
  if (zeros[1] == 0 && zeros[0] >= enough && head[0] == '\0') return Utf16::big_endian;
  return Utf16::no;
}

std::string_view without_utf8_mark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

std::string as_utf8(const std::string& path, std::string bytes) {
  if (const Utf16 order = utf16_of(bytes); order != Utf16::no) {
    const bool has_mark = bytes[0] == '\xFF' || bytes[0] == '\xFE';
    return from_utf16(path, std::string_view(bytes).substr(has_mark ? 2 : 0), order == Utf16::big_endian);
  }
  const std::size_t mark = bytes.size() - without_utf8_mark(bytes).size();
  bytes.erase(0, mark);
  return is_all_utf8(bytes) ? std::move(bytes) : from_windows_1252(bytes);
}

std::string read_foreign_text(const std::string& path, std::size_t largest) { return as_utf8(path, read_text_file(path, largest)); }

}  // namespace voussoir::io
