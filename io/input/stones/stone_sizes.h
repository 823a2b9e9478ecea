// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/forward.h"
#include "cases/input_error.h"

namespace voussoir::io {

/// Findings for stones of files so large or small that the unit of the case is probably wrong: one for each such `stones[i].unit`.
std::vector<cases::InputError> unusual_sizes(const cases::Case& c);

}  // namespace voussoir::io
