// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/input/case_file/case_file.h"

namespace voussoir::io {

Command add_keys(CLI::App& program) {
  CLI::App* words = program.add_subcommand("keys", "all keys of the case file");
  struct Form {
    bool markdown = false, json = false;
  };
  auto form = std::make_shared<Form>();
  CLI::Option* markdown = words->add_flag("--markdown", form->markdown, "as tables, for a page");
  add_format(*words, form->json);
  words->get_option("--format")->excludes(markdown);
  const auto print = [form] {
    std::fputs((form->json ? key_reference_json() : form->markdown ? key_reference_markdown() : key_reference()).c_str(), stdout);
    return kDone;
  };
  return {.words = words, .work = print};
}

}  // namespace voussoir::io
