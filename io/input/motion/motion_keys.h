// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace voussoir::io {

/// Keys of [motion] that are dropped when `key` is given later, over an included case or on the command line: a motion has one source, and
/// `unit`, `dt`, `from` and `to` belong to the files of that source.
inline std::span<const std::string_view> give_way_to(std::string_view key) {
  static constexpr std::array<std::string_view, 10> kToRecord{"x", "y", "z", "L", "T", "V", "unit", "dt", "from", "to"};
  static constexpr std::array<std::string_view, 9> kToAxes{"record", "L",    "T",  "V",        "unit",
                                                           "dt",     "from", "to", "direction"};  // direction: axes of L, T, V
  static constexpr std::array<std::string_view, 8> kToComponents{"record", "x", "y", "z", "unit", "dt", "from", "to"};
  if (key == "record") return kToRecord;
  if (key == "x" || key == "y" || key == "z") return kToAxes;
  if (key == "L" || key == "T" || key == "V") return kToComponents;
  return {};
}

}  // namespace voussoir::io
