// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"

namespace voussoir::io {

/// Sets Stone::fixed of all tables by StonesSpec::supports. On entry, `fixed` is the mark in the file.
/// \throw cases::InputError for a name that no stone or group has
void choose_supports(cases::Case& c);

}  // namespace voussoir::io
