// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What stands between backquotes in the first cells of a table.
std::set<std::string> places(const std::string& table) {
  std::set<std::string> all;
  for (std::size_t line = table.find("\n| `"); line != std::string::npos; line = table.find("\n| `", line + 1)) {
    const std::string cell = table.substr(line + 2, table.find(" |", line + 2) - line - 2);
    for (std::size_t from = cell.find('`'); from != std::string::npos; from = cell.find('`', cell.find('`', from + 1) + 1))
      all.insert(cell.substr(from + 1, cell.find('`', from + 1) - from - 1));
  }
  return all;
}

}  // namespace

TEST_CASE("multi-rate: solver/README.md lists the sources of the solver that name it, and no others") {
  const std::filesystem::path solver = VOUSSOIR_SOURCE_DIR "/solver";
  const std::string page = text_of(solver / "README.md");
  const std::size_t from = page.find("## The places of several rates");
  REQUIRE(from != std::string::npos);
  const std::set<std::string> listed = places(page.substr(from, page.find("\n## ", from + 1) - from));
  std::set<std::string> found;
  for (const auto& file : std::filesystem::recursive_directory_iterator(solver)) {
    const std::string kind = file.path().extension();
    if (kind != ".cpp" && kind != ".h") continue;
    const std::string text = text_of(file.path());
    if (text.find("ultirate") != std::string::npos) found.insert(std::filesystem::relative(file.path(), solver));
  }
  CHECK(found.size() > 20);
  for (const std::string& name : found) {
    CAPTURE(name);
    CHECK(listed.contains(name));
  }
  for (const std::string& name : listed) {
    CAPTURE(name);
    CHECK(found.contains(name));
  }
}
