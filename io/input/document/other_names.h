// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::io {

/// The key that engineers call `name`, such as "young" for "E" and "friction" for "phi", among the keys that are allowed; empty if there is
/// none. For names that are spelt wrong: cases::nearest.
std::string meant_key(std::string_view name, const std::vector<std::string>& allowed);

}  // namespace voussoir::io
