// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/case.h"

namespace voussoir::io {

/// Stones of files so large or small that their unit is hardly the one that the case states: one at each such `stones[i].unit`.
std::vector<cases::InputError> unusual_sizes(const cases::Case& c);

}  // namespace voussoir::io
