// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/command_word.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "cases/input_error.h"
#include "io/input/document/case_values.h"

namespace voussoir::io {

void check_command_word(const CLI::App& app, const std::string& word) {
  if (word.starts_with("-")) return;
  std::vector<std::string> names;
  std::string all;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
    all += (all.empty() ? "" : ", ") + names.back();
  }
  if (std::ranges::find(names, word) != names.end()) return;
  const std::string near = nearest(word, names);
  throw cases::InputError("",
                          "\"" + word + "\" is no command" + (near.empty() ? "" : "; is \"" + near + "\" meant?") + "; allowed: " + all);
}

}  // namespace voussoir::io
