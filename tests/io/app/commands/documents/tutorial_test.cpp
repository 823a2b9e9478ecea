// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/io/shell.h"

// What cases/tutorial tells a new user must be so: the page shows the cases that lie beside it, and the program takes them.
namespace {

std::string text_of(const std::string& name) { return shell::text_of(VOUSSOIR_SOURCE_DIR "/cases/tutorial/" + name); }

/// The blocks of a page that are marked as of this language.
std::vector<std::string> blocks_of(const std::string& page, const std::string& language) {
  const std::string open = "```" + language + "\n";
  std::vector<std::string> blocks;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) {
    const std::size_t first = at + open.size();
    blocks.push_back(page.substr(first, page.find("```", first) - first));
  }
  return blocks;
}

int check(const std::string& name, const std::string& words = "") {
  return shell::code_of(shell::kProgram + " check " + shell::source("cases/tutorial/" + name) + " " + words + " >/dev/null 2>&1");
}

}  // namespace

TEST_CASE("tutorial: the page shows its cases, and the program takes them") {
  const auto shown = blocks_of(text_of("README.md"), "toml");
  REQUIRE(shown.size() == 2);
  CHECK(shown[0] == text_of("hut.toml"));
  CHECK(shown[1] == text_of("hut-strong.toml"));
  CHECK(check("hut.toml") == 0);
  CHECK(check("hut-strong.toml") == 0);
  CHECK(check("hut.toml", "--set house.bearing_wall=0.1") == 2);  // the fault that the page shows
}
