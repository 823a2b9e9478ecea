// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/app/manual/option_table.h"

/// Scripts that let the Tab key complete commands, options, their values and the names of ready cases. Commands and options stand in them;
/// the cases are asked of the program when the key is pressed.
namespace voussoir::io {

std::string bash_completion(const OptionTable& table);
std::string zsh_completion(const OptionTable& table);
std::string fish_completion(const OptionTable& table);

}  // namespace voussoir::io
