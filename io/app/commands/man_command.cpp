// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "io/app/commands/command.h"
#include "io/app/manual/man_page.h"
#include "io/app/manual/option_table.h"
#include "io/app/session/exit_code.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/output/results/provenance.h"

namespace voussoir::io {
namespace {

/// Writes the manual pages into a folder, which is created if missing; existing pages are replaced. \throw FileError
int write_pages(const OptionTable& table, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made: " + error.message());
  for (const ManPage& page : man_pages(table, program_version()))
    write_output({(std::filesystem::path(folder) / page.file).string(), FileKind::manual, "FOLDER", true}, page.text);
  return kDone;
}

}  // namespace

Command add_man(CLI::App& program) {
  CLI::App* words = program.add_subcommand("man", "write the manual pages of the program and of its commands into a folder");
  auto folder = std::make_shared<std::string>();
  words->add_option("FOLDER", *folder, "made if it is missing; pages in it are replaced")->required();
  words->footer("example: voussoir man man1; man man1/voussoir-run.1");
  return {.words = words, .work = [&program, folder] { return write_pages(option_table(program), *folder); }};
}

}  // namespace voussoir::io
