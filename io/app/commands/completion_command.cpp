// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "io/app/commands/command.h"
#include "io/app/manual/completion.h"
#include "io/app/manual/option_table.h"
#include "io/app/session/exit_code.h"

namespace voussoir::io {
namespace {

int print_completion(const OptionTable& table, const std::string& shell) {
  const std::string text = shell == "bash" ? bash_completion(table) : shell == "zsh" ? zsh_completion(table) : fish_completion(table);
  std::fputs(text.c_str(), stdout);
  return kDone;
}

}  // namespace

Command add_completion(CLI::App& program) {
  CLI::App* words = program.add_subcommand("completion", "print a script that lets the Tab key complete the words of this program");
  auto shell = std::make_shared<std::string>();
  words->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  words->footer("example: source <(voussoir completion bash)");
  return {.words = words, .work = [&program, shell] { return print_completion(option_table(program), *shell); }};
}

}  // namespace voussoir::io
