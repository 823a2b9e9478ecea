// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace voussoir::io {

/// Keys of [motion] that give way to `key` where it comes later, over an included case or on the command line: a motion has one source.
inline std::span<const std::string_view> give_way_to(std::string_view key) {
  static constexpr std::array<std::string_view, 6> kToRecord{"x", "y", "z", "L", "T", "V"};
  static constexpr std::array<std::string_view, 5> kToAxes{"record", "L", "T", "V", "direction"};  // which says where L, T, V go
  static constexpr std::array<std::string_view, 4> kToComponents{"record", "x", "y", "z"};
  if (key == "record") return kToRecord;
  if (key == "x" || key == "y" || key == "z") return kToAxes;
  if (key == "L" || key == "T" || key == "V") return kToComponents;
  return {};
}

}  // namespace voussoir::io
