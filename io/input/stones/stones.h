// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/case.h"

/// The stones that a case takes out of files.
namespace voussoir::io {

/// Reads the files of all [[stones]] of the case and fills in StonesSpec::stones and notes: turned, placed, mended, put against each other
/// and the base, cut into convex pieces where they must be. Does nothing for tables that have their stones.
/// \throw NamedFileError for a file that cannot be read; cases::InputError with the key at fault, naming the stone, where it is and what to
/// do
void load_stones(cases::Case& c);

/// The same, to look at what is refused: every stone that is at fault is there by its surface alone, as thin plates, and is told. Names of
/// supports that no stone has are passed over. \return by fault, the stone's place in StonesSpec::stones of its table
struct ShownFault {
  std::size_t table = 0, stone = 0;
  std::string message;
};
std::vector<ShownFault> load_shown_stones(cases::Case& c);

}  // namespace voussoir::io
