// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/app/manual/option_table.h"

/// Scripts for completion by the Tab key of commands, options, their values and the names of ready cases. Scripts contain commands and
/// options; they get the names of cases from the program when the key is pressed.
namespace voussoir::io {

std::string bash_completion(const OptionTable& table);
std::string zsh_completion(const OptionTable& table);
std::string fish_completion(const OptionTable& table);

}  // namespace voussoir::io
