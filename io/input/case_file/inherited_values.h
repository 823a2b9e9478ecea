// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/input/case_file/case_file.h"

namespace voussoir::io {

/// For a case that changes the size of an included house: the keys that still have the values of the included house, in a sentence.
/// Considered are openings, inner walls, piers, columns, surcharge, followed points, damping.frequency. Empty if there are none, or no size
/// is changed.
std::string inherited_values(const LoadedCase& c);

}  // namespace voussoir::io
