// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/io/shell.h"

namespace {

/// By thread of a program that computes with two, the first of them first: the processors that it may use.
std::vector<std::string> processors_of_threads(const std::string& environment) {
  const std::string command = "env " + environment + " " + shell::kProgram +
                              " bench arch -j 2 --batches 100 >/dev/null 2>&1 & p=$!\n"
                              "for i in $(seq 600); do [ $(ls /proc/$p/task | wc -l) -ge 2 ] && break; sleep 0.1; done\n"
                              "sleep 0.5\n"
                              "grep -h Cpus_allowed_list /proc/$p/task/*/status\n"
                              "kill $p; wait $p";
  std::istringstream said(shell::run(command).text);
  std::vector<std::string> lists;
  for (std::string line; std::getline(said, line);) lists.push_back(line);
  return lists;
}

}  // namespace

TEST_CASE("threads that OpenMP is told to bind have a processor each, others may use all") {
  if (std::thread::hardware_concurrency() < 2) return;
  for (const char* bound : {"OMP_PROC_BIND=close", "OMP_PLACES=cores", ""}) {
    CAPTURE(bound);
    const std::vector<std::string> lists = processors_of_threads(bound);
    REQUIRE(lists.size() >= 2);
    const auto with_the_first = static_cast<std::size_t>(std::ranges::count(lists, lists.front()));
    CHECK(with_the_first == (*bound == '\0' ? lists.size() : 1));
  }
}
