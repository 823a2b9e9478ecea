// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/commands/view_command.h"
#include "io/session/prepared_case.h"
#include "tests/io/shell.h"
#include "tests/io/stones/stones_fixture.h"

// The examples of cases/stones, and what `voussoir view` makes of a model.

namespace {

using namespace voussoir;

const std::string kMake = "python3 " + shell::source("cases/stones/make.py") + " ";

io::LoadedCase loaded(const std::string& path) {
  io::LoadedCase c = io::load_case(path);
  io::load_stones(c.value);
  return c;
}

/// The JSON of the page's element with this id.
nlohmann::json element_of(const std::string& page, const std::string& id) {
  const std::string open = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t at = page.find(open);
  REQUIRE(at != std::string::npos);
  const std::size_t first = at + open.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

}  // namespace

TEST_CASE("examples: every one is a model, with the joints that are counted by other means") {
  const TempFolder folder;
  REQUIRE(shell::code_of(kMake + shell::quoted(folder.path())) == 0);
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".toml") continue;
    ++examples;
    CAPTURE(entry.path().filename().string());
    const io::LoadedCase c = loaded(entry.path().string());
    const cases::Model model = io::prepared_model(c.value);
    std::size_t between = 0;
    for (const auto& j : model.assembly.joints) between += j.element_b >= 0 ? 1 : 0;
    std::filesystem::path stones = entry.path();
    const auto counted = shell::run("python3 " + shell::source("tests/io/stones/count_joints.py") + " " +
                                    shell::quoted(stones.replace_extension(".obj").string()));
    CHECK(counted.text == std::to_string(model.blocks.size()) + " " + std::to_string(between) + "\n");
    for (const cases::Stone& s : c.value.stones[0].stones) {
      CHECK(s.change.empty());
      CHECK(s.pieces.size() == 1);
    }
  }
  CHECK(examples == 7);
}

TEST_CASE("view: a page of the model with its laws; a model that is refused with what is at fault") {
  const TempFolder folder;
  REQUIRE(shell::code_of(kMake + shell::quoted(folder.path()) + " column") == 0);
  const std::string page = folder.path("column.html");
  CHECK(io::view_command(loaded(folder.path("column.toml")), {page, false}) == 0);
  const nlohmann::json model = element_of(shell::text_of(page), "model");
  CHECK(model["fault"] == "");
  CHECK(model["laws"][0]["name"] == "dry");
  CHECK(model["laws"][0]["joints"] == 7);
  CHECK(element_of(shell::text_of(page), "facts")["title"] == "A column of six drums under an abacus");
  CHECK_THROWS(io::view_command(loaded(folder.path("column.toml")), {page, false}));

  folder.write("bad.obj", stones::obj({{"low", stones::box({0, 0, 0}, {1, 1, 1})},
                                       {"high", stones::box({0, 0, 0.9}, {1, 1, 2})},
                                       {"far", stones::box({0, 5, 0}, {1, 6, 2})}}));
  folder.write("bad.toml", stones::kMaterial + "[base]\n[[stones]]\nfile = \"bad.obj\"\nunit = \"m\"\n");
  CHECK(io::view_command(loaded(folder.path("bad.toml")), {page, true}) == 2);
  const nlohmann::json bad = element_of(shell::text_of(page), "model");
  CHECK(bad["faults"] == nlohmann::json::array({0, 1}));
  CHECK(bad["fault"].get<std::string>().find("overlaps stone \"high\"") != std::string::npos);
}
