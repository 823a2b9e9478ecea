// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/manual/option_table.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace voussoir::io {
namespace {

/// Reads a description of a check by the parser: "{fast,reference}", "INT in [1 - 1024]", "POSITIVE", "NONNEGATIVE".
void read_check(const std::string& check, OptionRow& row) {
  if (check.starts_with("{") && check.ends_with("}")) {
    std::istringstream words(check.substr(1, check.size() - 2));
    for (std::string word; std::getline(words, word, ',');) row.choices.push_back(word);
  } else if (check == "POSITIVE") {
    row.range = "more than 0";
  } else if (check == "NONNEGATIVE") {
    row.range = "at least 0";
  } else if (const std::size_t from = check.find(" in ["), dash = check.find(" - ");
             from != std::string::npos && dash != std::string::npos) {
    row.range = check.substr(from + 5, dash - from - 5) + " to " + check.substr(dash + 3, check.size() - dash - 4);
  }
}

OptionRow row_of(const CLI::Option& option) {
  OptionRow row;
  row.positional = option.get_positional();
  row.required = option.get_required();
  row.repeated = option.get_expected_max() > 1;
  row.text = option.get_description();
  if (row.positional) row.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  if (option.get_items_expected_max() == 0) return row;
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  row.value = type.substr(0, colon);
  if (colon != std::string::npos) read_check(type.substr(colon + 1), row);
  return row;
}

CommandRow command_of(const CLI::App& app) {
  CommandRow command{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) command.options.push_back(row_of(*option));
  return command;
}

}  // namespace

OptionTable option_table(const CLI::App& app) {
  OptionTable table{command_of(app), {}};
  table.program.name = "voussoir";
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) table.commands.push_back(command_of(*command));
  return table;
}

const std::string& long_name(const OptionRow& option) { return option.names.back(); }

}  // namespace voussoir::io
