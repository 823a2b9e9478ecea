// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace voussoir::geometry {

/// "block 7: " for a known subject (>= 0), else an empty string.
inline std::string block_prefix(int subject) { return subject < 0 ? std::string() : "block " + std::to_string(subject) + ": "; }

/// The text that printf would print of `values`.
template <class... Values>
std::string printed(const char* format, Values... values) {
  const int length = std::snprintf(nullptr, 0, format, values...);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/// A number for a message: six significant digits, general format.
inline std::string figure(double value) { return printed("%.6g", value); }
/// A number for a message: four significant digits, general format.
inline std::string short_figure(double value) { return printed("%.4g", value); }

/// A length in millimetres, three significant digits: "0.12 mm".
inline std::string millimetres(double metres) { return printed("%.3g mm", 1e3 * metres); }

}  // namespace voussoir::geometry
