// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/app/commands/view_command.h"
#include "io/app/session/prepared_case.h"
#include "io/input/files/output_path.h"
#include "tests/io/input/stones/stones_fixture.h"
#include "tests/io/shell.h"

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
    const auto counted = shell::run("python3 " + shell::source("tests/io/input/stones/count_joints.py") + " " +
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

  io::start_command();  // another one
  folder.write("bad.obj", stones::obj({{"low", stones::box({0, 0, 0}, {1, 1, 1})},
                                       {"high", stones::box({0, 0, 0.9}, {1, 1, 2})},
                                       {"far", stones::box({0, 5, 0}, {1, 6, 2})}}));
  folder.write("bad.toml", stones::kMaterial + "[base]\n[[stones]]\nfile = \"bad.obj\"\nunit = \"m\"\n");
  CHECK(io::view_command(loaded(folder.path("bad.toml")), {page, true}) == 2);
  const nlohmann::json bad = element_of(shell::text_of(page), "model");
  CHECK(bad["faults"] == nlohmann::json::array({0, 1}));
  CHECK(bad["fault"].get<std::string>().find("overlaps stone \"high\"") != std::string::npos);
}

TEST_CASE("view: stones that are refused while they are read are shown where they are, and all of them are told") {
  const TempFolder folder;
  const auto cube_at = [](double x) { return stones::box({x, 0, 0}, {x + 1, 1, 1}); };
  std::vector<stones::Named> all;
  for (const char* name : {"good", "open", "out", "skew", "fine"}) all.push_back({name, cube_at(1.5 * static_cast<double>(all.size()))});
  all[1].mesh.faces.pop_back();
  all[2].mesh.faces.erase(all[2].mesh.faces.begin());
  all[3].mesh.vertices[6].z += 0.3;
  folder.write("bad.obj", stones::obj(all));
  folder.write("bad.toml", stones::kMaterial + "[base]\n[[stones]]\nfile = \"bad.obj\"\nunit = \"m\"\n");
  const std::string page = folder.path("bad.html");
  const io::LoadedCase c = io::load_case(folder.path("bad.toml"));
  CHECK(io::view_command(c, {page, false}) == 2);
  const std::string text = shell::text_of(page);
  const nlohmann::json model = element_of(text, "model");
  const std::string fault = model["fault"];
  for (const char* words : {"stone \"open\" of \"bad.obj\" is open", "stone \"out\" of \"bad.obj\" is open",
                            "stone \"skew\" of \"bad.obj\" has a face warped by"})
    CHECK(fault.find(words) != std::string::npos);
  // Two good stones come first, then 10, 10 and 12 triangles as plates.
  const std::vector<int> marked = model["faults"];
  CHECK(marked.size() == 32);
  CHECK(marked.front() == 2);
  CHECK(marked.back() == 33);
  try {
    io::LoadedCase strict = c;
    io::load_stones(strict.value);
    FAIL("nothing is refused");
  } catch (const cases::InputError& e) {
    const std::string message = e.what();
    CHECK(message.find("stone \"open\"") != std::string::npos);
    CHECK(message.find("(and 2 more stones are at fault: \"out\", \"skew\")") != std::string::npos);
  }
}
