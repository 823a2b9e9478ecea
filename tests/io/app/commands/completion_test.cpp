// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "tests/io/shell.h"

// What bash offers after some words of the command line, the last of them unfinished.
namespace {

std::string offered(const std::string& words) {
  const std::string script = "source <(" + shell::kProgram + " completion bash)" +
                             R"(; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _voussoir; echo -n "${COMPREPLY[@]}")";
  const shell::Outcome o = shell::run("bash -c " + shell::quoted(script) + " bash " + shell::kProgram + " " + words);
  CHECK(o.code == 0);
  return o.text;
}

}  // namespace

TEST_CASE("completion: commands, options and cases, as the program itself says them") {
  CHECK(offered("re") == "resume report");
  CHECK(offered("''").starts_with("new cases "));
  CHECK(offered("run --check") == "--checkpoint-every --checkpoint-simulated");
  CHECK(offered("check hut.toml --dr") == "--draw");
  CHECK(offered("run flat20n --kernels r") == "reference");
  CHECK(offered("modes flat40") == "flat40n");
  CHECK(offered("limit flat40") == "flat40n");
  CHECK(offered("motion flat40").empty());  // takes files
  CHECK(offered("report res").empty());
}
