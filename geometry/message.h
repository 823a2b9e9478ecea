// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace voussoir::geometry {

/// "block 7: " for a known subject, else nothing.
inline std::string block_prefix(int subject) { return subject < 0 ? std::string() : "block " + std::to_string(subject) + ": "; }

/// A figure for a message: six significant digits, general format.
inline std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace voussoir::geometry
