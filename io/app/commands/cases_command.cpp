// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>

#include "io/app/commands/command.h"
#include "io/app/session/exit_code.h"
#include "io/input/case_file/catalogue.h"

namespace voussoir::io {
namespace {

int print_catalogue() {
  for (const CatalogueEntry& e : catalogue()) std::printf("%-12s %s\n", e.name.c_str(), e.title.c_str());
  return kDone;
}

}  // namespace

Command add_cases(CLI::App& program) {
  return {.words = program.add_subcommand("cases", "the catalogue, one line a case"), .work = print_catalogue};
}

}  // namespace voussoir::io
