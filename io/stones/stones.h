// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"

/// The stones that a case takes out of files.
namespace voussoir::io {

/// Reads the files of all [[stones]] of the case and fills in StonesSpec::stones and notes: turned, placed, mended, put against each other
/// and the base, cut into convex pieces where they must be. Does nothing for tables that have their stones.
/// \throw NamedFileError for a file that cannot be read; cases::InputError with the key at fault, naming the stone, where it is and what to
/// do
void load_stones(cases::Case& c);

}  // namespace voussoir::io
