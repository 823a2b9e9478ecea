// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/forward.h"

/// Loads the stones of a case from files, and chooses the origin of its model.
namespace voussoir::io {

/// Reads the files of all [[stones]] of the case and fills in StonesSpec::stones and notes: turned, placed, repaired, made to touch each
/// other and the base, cut into convex pieces where necessary. Skips tables that already have stones. Moves a case whose origin is not
/// chosen yet to the one that suits it (cases/solids/origin.h), also one without stones.
/// \throw NamedFileError for a file that cannot be read; cases::InputError with the key at fault, naming the stone, its place and the
/// remedy
void load_stones(cases::Case& c);

/// A stone that load_stones refuses, shown by its surface as thin plates.
struct ShownFault {
  std::size_t table = 0, stone = 0;
  std::string message;
};
/// Loads stones like load_stones, but does not refuse faulty ones: each is represented by its surface as thin plates, and reported. Names
/// of supports that no stone has are ignored. \return one entry per fault, with the stone's index in StonesSpec::stones of its table
std::vector<ShownFault> load_shown_stones(cases::Case& c);

}  // namespace voussoir::io
