// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

namespace voussoir::io {

/// Whether a history may have the name: it becomes the name of a group of run.h5, beside the dataset of times.
[[nodiscard]] inline bool can_name_history(const std::string& name) {
  const bool control = std::ranges::any_of(name, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  return !name.empty() && name != "time" && name != "." && name != ".." && name.find('/') == std::string::npos && !control;
}

}  // namespace voussoir::io
