// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <string>

// What bash offers after some words of the command line, the last of them unfinished.
namespace {

std::string offered(const std::string& words) {
  const std::string script = "source " + std::string(VOUSSOIR_SOURCE_DIR) +
                             R"(/scripts/completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _voussoir; echo -n "${COMPREPLY[@]}")";
  const std::string command = "bash -c '" + script + "' bash " + VOUSSOIR_PROGRAM + " " + words;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  CHECK(pclose(pipe) == 0);
  return text;
}

}  // namespace

TEST_CASE("completion: commands, options and cases, as the program itself says them") {
  CHECK(offered("re") == "resume report");
  CHECK(offered("''").starts_with("run resume "));
  CHECK(offered("run --check") == "--checkpoint-every --checkpoint-simulated");
  CHECK(offered("check hut.toml --dr") == "--draw");
  CHECK(offered("modes flat40") == "flat40n");
  CHECK(offered("motion flat40").empty());  // takes files
  CHECK(offered("report res").empty());
}
