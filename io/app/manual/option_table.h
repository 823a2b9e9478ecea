// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The command line as data, extracted from the parser, for manual pages and completion scripts.
namespace voussoir::io {

struct OptionRow {
  std::vector<std::string> names;    // "-o", "--output"; of a positional "CASE"
  std::string value;                 // type of its value: TEXT, INT, FLOAT; empty for a flag
  std::vector<std::string> choices;  // allowed values; empty: not a list
  std::string range;                 // "1 to 1024", "at least 0", "more than 0"; empty if any
  std::string text;                  // description
  bool positional = false, required = false, repeated = false;
};

struct CommandRow {
  std::string name, text, footer;
  std::vector<OptionRow> options;  // including positionals
};

struct OptionTable {
  CommandRow program;  // name, and options before any command
  std::vector<CommandRow> commands;
};

/// Extracts the table in the order of --help. \param app  with its commands added
OptionTable option_table(const CLI::App& app);

/// The long name of an option: "--output"; of a positional "CASE".
const std::string& long_name(const OptionRow& option);

}  // namespace voussoir::io
