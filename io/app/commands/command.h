// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

namespace CLI {
class App;
}

/// Interface of a command. A command is in one file, NAME_command.cpp: options, help, and action. The list `commands` in
/// io/app/CMakeLists.txt is the only other place with its name.
namespace voussoir::io {

struct Command {
  CLI::App* words = nullptr;  // its subcommand of the parser, with all options
  std::function<int()> work;  // to be called after parsing; returns the exit code
  int* threads = nullptr;     // value of -j, 0 if not given; null: the command has no -j
};

/// A function that adds a command to the command line.
using AddCommand = Command (*)(CLI::App& program);

/// All commands, in the order of --help.
std::span<const AddCommand> all_commands();

}  // namespace voussoir::io
