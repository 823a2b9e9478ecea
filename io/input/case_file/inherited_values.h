// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/input/case_file/case_file.h"

namespace voussoir::io {

/// A case that changes the size of the house it includes has, without a word, what belongs to that other house. Which of these keys it
/// still has from there: openings, places of columns, surcharge, followed points, damping.frequency. Empty: it has none, or changes no
/// size.
std::string inherited_values(const LoadedCase& c);

}  // namespace voussoir::io
