// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace voussoir::io {

/// Refuses a first word that is neither a command nor an option, and suggests the most similar command. \throw cases::InputError
void check_command_word(const CLI::App& app, const std::string& word);

/// For a value that is none of those which its option takes, as in the message "--format: jsn not in {text,json}": a line with the most
/// similar one. Empty: none is similar.
std::string suggested_value(const std::string& message);

/// For the first option among the words that the command does not know: a line with the most similar one that it has. Empty: none.
std::string suggested_option(const CLI::App& program, const std::vector<std::string>& words);

/// Refuses options of a command that were given but do not go with what its first word names. \param allowed  those that do \param why
/// goes on behind "--name " \throw cases::InputError
void refuse_options(const CLI::App& command, const std::vector<std::string>& allowed, const std::string& why);

}  // namespace voussoir::io
