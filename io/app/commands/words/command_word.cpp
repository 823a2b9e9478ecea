// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/command_word.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <regex>
#include <sstream>
#include <vector>

#include "cases/input_error.h"
#include "cases/names.h"

namespace voussoir::io {
namespace {

/// The known option whose letters are nearest to those of the name; empty: none is near. The two dashes, which all have, do not count.
std::string nearest_option(const std::string& name, const std::vector<std::string>& names) {
  std::vector<std::string> letters;
  for (const std::string& known : names) letters.push_back(known.substr(2));
  const std::string near = cases::nearest(name.substr(2), letters);
  return near.empty() ? "" : "--" + near;
}

}  // namespace

void check_command_word(const CLI::App& app, const std::string& word) {
  if (word.starts_with("-")) return;
  std::vector<std::string> names;
  std::string all;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
    all += (all.empty() ? "" : ", ") + names.back();
  }
  if (std::ranges::find(names, word) != names.end()) return;
  const std::string near = cases::nearest(word, names);
  throw cases::InputError("",
                          "\"" + word + "\" is no command" + (near.empty() ? "" : "; is \"" + near + "\" meant?") + "; allowed: " + all);
}

std::string suggested_value(const std::string& message) {
  static const std::regex refused(R"(^(.+): (\S+) not in \{(.+)\})");
  std::smatch parts;
  if (!std::regex_search(message, parts, refused)) return "";
  std::vector<std::string> names;
  std::istringstream list(parts[3].str());
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  const std::string near = cases::nearest(parts[2].str(), names);
  return near.empty() ? "" : parts[1].str() + " " + parts[2].str() + ": did you mean " + near + "?\n";
}

std::string suggested_option(const CLI::App& program, const std::vector<std::string>& words) {
  const auto all = program.get_subcommands();
  const CLI::App& app = all.empty() ? program : *all.front();
  std::vector<std::string> names;
  std::vector<std::string> before;  // options before the command, which are known, but not meant
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const CLI::Option* option : program.get_options()) {
    for (const std::string& name : option->get_lnames()) before.push_back("--" + name);
  }
  const auto known = [&](const std::string& name) {
    return std::ranges::find(names, name) != names.end() || std::ranges::find(before, name) != before.end();
  };
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("-") || name.size() < 3 || known(name)) continue;
    const bool one_dash = !name.starts_with("--");
    if (one_dash && known("-" + name)) return name + ": did you mean -" + name + "?\n";
    if (one_dash && app.get_option_no_throw(name.substr(0, 2)) != nullptr) continue;  // a short option with its value
    const std::string meant = one_dash ? "-" + name : name;
    std::string near = nearest_option(meant, names);
    if (near.empty()) near = nearest_option(meant, before);
    return near.empty() ? "" : name + ": did you mean " + near + "?\n";
  }
  return "";
}

void refuse_options(const CLI::App& command, const std::vector<std::string>& allowed, const std::string& why) {
  for (const CLI::Option* option : command.get_options([](const CLI::Option* o) { return o->count() > 0; })) {
    const std::string name = option->get_name();
    if (name.starts_with('-') && std::ranges::find(allowed, name) == allowed.end()) throw cases::InputError("", name + " " + why);
  }
}

}  // namespace voussoir::io
