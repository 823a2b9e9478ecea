// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// Manual pages and completions say what the parser knows, whatever options it will have.
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Options that --help lists.
std::string options_of(const std::string& command) {
  return shell::run(shell::kProgram + " " + command + " --help | sed -nE 's/^  (-.,)?(--[a-z-]+).*/\\2/p'").text;
}

std::string commands() { return shell::run(shell::kProgram + " --help | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\\1/p'").text; }

}  // namespace

TEST_CASE("manual pages: one a command, with every option") {
  const TempFolder folder;
  REQUIRE(shell::code_of(shell::kProgram + " man " + shell::quoted(folder.path("man1"))) == 0);
  const std::string program = shell::text_of(folder.path("man1/voussoir.1"));
  std::istringstream names(commands());
  int count = 0;
  for (std::string name; std::getline(names, name); ++count) {
    CHECK_MESSAGE(has(program, "\\fB" + name + "\\fR"), name);
    const std::string page = shell::text_of(folder.path("man1/voussoir-" + name + ".1"));
    REQUIRE_MESSAGE(has(page, ".SH SYNOPSIS"), name);
    std::istringstream options(options_of(name));
    for (std::string option; std::getline(options, option);) {
      std::string escaped;
      for (const char c : option) escaped += c == '-' ? "\\-" : std::string(1, c);
      CHECK_MESSAGE(has(page, "\\fB" + escaped + "\\fR"), name << " " << option);
    }
  }
  CHECK(count >= 11);
  CHECK(has(shell::text_of(folder.path("man1/voussoir-run.1")), "Allowed: fast, reference."));
  CHECK(has(shell::text_of(folder.path("man1/voussoir-bench.1")), "Allowed: 1 to 1000."));
  if (shell::code_of("command -v groff >/dev/null") == 0) {
    CHECK(shell::run("groff -man -Tutf8 -ww -z " + shell::quoted(folder.path("man1")) + "/*.1 2>&1").text.empty());
  }
}

TEST_CASE("manual pages: a folder that cannot be made is an error of files") {
  const TempFolder folder;
  const shell::Outcome o = shell::run(shell::kProgram + " man " + shell::quoted(folder.write("file", "") + "/man1") + " 2>&1");
  CHECK(o.code == 3);
  CHECK(has(o.text, "cannot be made"));
}

TEST_CASE("completion: shells that it does not know are refused by those that it knows") {
  const shell::Outcome o = shell::run(shell::kProgram + " completion csh 2>&1");
  CHECK(o.code == 2);
  CHECK(has(o.text, "zsh"));
}

TEST_CASE("completion: fish offers commands, options and cases") {
  if (shell::code_of("command -v fish >/dev/null") != 0) {
    MESSAGE("skipped: no fish");
    return;
  }
  const TempFolder folder;
  REQUIRE(shell::code_of(shell::kProgram + " completion fish >" + shell::quoted(folder.path("voussoir.fish"))) == 0);
  const auto offered = [&](const std::string& words) {
    const std::string script = "set -x PATH (dirname " + shell::kProgram + ") $PATH; source " + folder.path("voussoir.fish") +
                               "; complete -C 'voussoir " + words + "' | cut -f1";
    return shell::run("cd " + shell::quoted(folder.path()) + " && HOME=" + shell::quoted(folder.path()) + " fish -c " +
                      shell::quoted(script))
        .text;
  };
  CHECK(offered("res") == "resume\n");
  CHECK(offered("run --check") == "--checkpoint-every\n--checkpoint-simulated\n");
  CHECK(offered("run --kernels ") == "fast\nreference\n");
  CHECK(has(offered("check flat"), "flat20n\n"));
}

TEST_CASE("completion: zsh takes the script") {
  if (shell::code_of("command -v zsh >/dev/null") != 0) {
    MESSAGE("skipped: no zsh");
    return;
  }
  const std::string script =
      "autoload -Uz compinit; compinit -u -D; source <(" + shell::kProgram + " completion zsh); print ${_comps[voussoir]}";
  CHECK(shell::run("zsh -f -c " + shell::quoted(script) + " 2>&1").text == "_voussoir\n");
}
