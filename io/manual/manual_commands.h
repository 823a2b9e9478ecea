// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/manual/option_table.h"

/// `voussoir man` and `voussoir completion`: the command line, described by itself.
namespace voussoir::io {

/// Shells that `completion` knows.
inline const std::vector<std::string> kShells{"bash", "zsh", "fish"};

/// Writes the manual pages into a folder, which is made if it is missing; pages that are there are replaced. \throw FileError
int man_command(const OptionTable& table, const std::string& folder);

/// Prints the script for a shell. \pre  `shell` is one of kShells
int completion_command(const OptionTable& table, const std::string& shell);

}  // namespace voussoir::io
