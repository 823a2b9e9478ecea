// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "io/app/commands/command.h"
#include "io/app/session/exit_code.h"
#include "io/input/case_file/catalogue.h"
#include "io/input/files/errors.h"
#include "io/input/files/whole_file.h"
#include "io/input/messages/messages.h"

namespace voussoir::io {
namespace {

struct NewWords {
  std::string kind, file;
};

/// Writes a commented case to begin with; never over another file.
int write_new_case(const NewWords& w) {
  const std::string file = w.file.empty() ? "my-" + w.kind + ".toml" : w.file;
  std::error_code error;
  if (std::filesystem::symlink_status(file, error).type() != std::filesystem::file_type::not_found)
    throw FileError(file, "is there already; name another file");
  write_text_file(file, built_in_part("new/" + w.kind)->text);
  std::printf("%s\n", file.c_str());
  say_info("edit it, then: voussoir check " + file);
  return kDone;
}

}  // namespace

Command add_new(CLI::App& program) {
  CLI::App* words = program.add_subcommand("new", "write a commented case to begin with: a house, an arch, stones or a wall");
  auto w = std::make_shared<NewWords>();
  words->add_option("KIND", w->kind, "house, arch, stones or wall")->required()->check(CLI::IsMember({"house", "arch", "stones", "wall"}));
  words->add_option("FILE", w->file, "the file to write (default: my-KIND.toml); never one that is there");
  words->footer("example: voussoir new house my-house.toml");
  return {.words = words, .work = [w] { return write_new_case(*w); }};
}

}  // namespace voussoir::io
