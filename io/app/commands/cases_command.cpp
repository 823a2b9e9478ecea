// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/app/commands/command.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/input/case_file/catalogue.h"

namespace voussoir::io {
namespace {

int print_as_json() {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const CatalogueEntry& e : catalogue()) out.push_back({{"name", e.name}, {"title", e.title}});
  std::printf("%s\n", out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
  return kDone;
}

int print_catalogue() {
  for (const CatalogueEntry& e : catalogue()) std::printf("%-12s %s\n", e.name.c_str(), e.title.c_str());
  return kDone;
}

}  // namespace

Command add_cases(CLI::App& program) {
  CLI::App* words = program.add_subcommand("cases", "the catalogue, one line a case");
  auto json = std::make_shared<bool>(false);
  add_format(*words, *json);
  return {.words = words, .work = [json] { return *json ? print_as_json() : print_catalogue(); }};
}

}  // namespace voussoir::io
