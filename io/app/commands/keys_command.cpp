// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "io/app/commands/command.h"
#include "io/app/session/exit_code.h"
#include "io/input/case_file/case_file.h"

namespace voussoir::io {

Command add_keys(CLI::App& program) {
  CLI::App* words = program.add_subcommand("keys", "all keys of the case file");
  auto markdown = std::make_shared<bool>(false);
  words->add_flag("--markdown", *markdown, "as tables, for a page");
  const auto print = [markdown] {
    std::fputs((*markdown ? key_reference_markdown() : key_reference()).c_str(), stdout);
    return kDone;
  };
  return {.words = words, .work = print};
}

}  // namespace voussoir::io
