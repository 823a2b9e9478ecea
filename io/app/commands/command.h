// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

namespace CLI {
class App;
}

/// What a command is to the program. A command stands in one file, NAME_command.cpp: its options, its help, and what it does. The list
/// `commands` in io/app/CMakeLists.txt names it; nothing else knows of it.
namespace voussoir::io {

struct Command {
  CLI::App* words = nullptr;     // its part of the command line, with all its options
  std::function<int()> work;     // to be called once the command line is read; returns the exit code
  const int* threads = nullptr;  // where -j puts its value; null: the command has no -j
  bool takes_long = false;       // so long that it pays to look first how busy the machine is
};

/// Adds a command to the command line.
using AddCommand = Command (*)(CLI::App& program);

/// All commands, in the order of --help.
std::span<const AddCommand> all_commands();

}  // namespace voussoir::io
