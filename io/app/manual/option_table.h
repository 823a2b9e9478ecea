// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The command line as data: what the parser knows, for pages and scripts that describe it. Nothing is written twice.
namespace voussoir::io {

struct OptionRow {
  std::vector<std::string> names;    // "-o", "--output"; of a positional its one name, "CASE"
  std::string value;                 // what stands behind it: TEXT, INT, FLOAT; empty for a flag
  std::vector<std::string> choices;  // the only values allowed; empty if there is no such list
  std::string range;                 // "1 to 1024", "at least 0", "more than 0"; empty if any
  std::string text;                  // what it does
  bool positional = false, required = false, repeated = false;
};

struct CommandRow {
  std::string name, text, footer;
  std::vector<OptionRow> options;  // positionals among them
};

struct OptionTable {
  CommandRow program;  // name, and options before any command
  std::vector<CommandRow> commands;
};

/// In the order in which --help lists them. \param app  with its commands added
OptionTable option_table(const CLI::App& app);

/// Name of the option by which most know it: "--output"; of a positional "CASE".
const std::string& long_name(const OptionRow& option);

}  // namespace voussoir::io
