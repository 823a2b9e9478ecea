// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What the program says on standard error with --messages json: an object a line, and nothing else.
namespace {

using Json = nlohmann::json;

struct Said {
  int code = -1;
  std::vector<Json> messages;
};

/// What the program says on standard error. \param before, after  of the shell
Said said(const std::string& words, const std::string& before = "", const std::string& after = "") {
  const shell::Outcome o = shell::run("{ " + before + shell::kProgram + " --messages json " + words + after + "; } 2>&1 >/dev/null");
  Said result{o.code, {}};
  std::istringstream lines(o.text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    REQUIRE(Json::accept(line));
    result.messages.push_back(Json::parse(line));
  }
  return result;
}

const std::string kCase = R"(title = "test"
[gravity]
settle = false
[time]
duration = 0.01
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joints]
default = "dry"
[base]
z = 0.0
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [1, 1, 1]]
)";

std::string written(const TempFolder& folder, const std::string& text) {
  std::ofstream(folder.path("case.toml")) << text;
  return folder.path("case.toml");
}

std::string replaced(std::string text, const std::string& a, const std::string& b) { return text.replace(text.find(a), a.size(), b); }

}  // namespace

TEST_CASE("messages: a fault of a case has file, line, key, value and what is allowed") {
  const TempFolder folder;
  const std::string file = written(folder, replaced(kCase, "density = 2000.0", "density = -3.0"));
  const Said s = said("check " + shell::quoted(file));
  CHECK(s.code == 2);
  REQUIRE(s.messages.size() == 1);
  const Json& m = s.messages[0];
  CHECK(m["kind"] == "error");
  CHECK(m["code"] == 2);
  CHECK(m["file"] == file);
  CHECK(m["line"] == 7);
  CHECK(m["key"] == "materials.stone.density");
  CHECK(m["value"] == "-3 kg/m3");
  CHECK(m["allowed"].get<std::string>().starts_with("a number, kg/m3, > 0"));
  const shell::Outcome text = shell::run(shell::kProgram + " check " + shell::quoted(file) + " 2>&1 >/dev/null");
  CHECK(text.text == "voussoir: " + m["text"].get<std::string>() + "\n");
}

TEST_CASE("messages: several faults have an object each, in the order of the file") {
  const TempFolder folder;
  const std::string bad = replaced(replaced(kCase, "density = 2000.0", "density = -3.0"), "poisson = 0.2", "poison = 0.2");
  Said s = said("check " + shell::quoted(written(folder, bad)));
  REQUIRE(s.messages.size() == 2);
  CHECK(s.messages[0]["line"] == 7);
  CHECK(s.messages[1]["line"] == 9);
  CHECK(s.messages[1]["key"] == "materials.stone.poison");
  CHECK(s.messages[1]["allowed"] == "density, young, poisson, inside");
  // What is found only when it is built.
  s = said("check " + shell::quoted(written(folder, replaced(kCase, "material = \"stone\"", "material = \"stne\""))));
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0]["line"] == 16);
  CHECK(s.messages[0]["key"] == "block[0].material");
  CHECK(s.messages[0]["value"] == "\"stne\"");
  CHECK(s.messages[0]["allowed"].is_null());
}

TEST_CASE("messages: faults of the command line, of files, of overrides") {
  const TempFolder folder;
  const std::string file = shell::quoted(written(folder, kCase));
  Said s = said("check " + file + " --formt json");
  CHECK(s.code == 2);
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0]["text"].get<std::string>().find("did you mean --format?") != std::string::npos);
  s = said("check " + file + " --set time.duration=-1");
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0]["file"].is_null());
  CHECK(s.messages[0]["line"].is_null());
  CHECK(s.messages[0]["key"] == "time.duration");
  s = said("summary " + shell::quoted(folder.path("none")));
  CHECK(s.code == 3);
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0]["code"] == 3);
  CHECK(s.messages[0]["file"].get<std::string>().starts_with(folder.path("none")));
  s = said("assess " + shell::quoted(folder.path("none")) + " --time nan");
  CHECK(s.code == 2);
  CHECK(s.messages.size() == 1);
  CHECK(shell::voussoir("--messages xml cases").code == 2);
}

TEST_CASE("messages: where memory ends, too") {
  if (shell::kSanitizer) return;
  const Said s = said("check flat20n -j 1", "ulimit -v 100000; ");
  CHECK(s.code == 3);
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0]["text"].get<std::string>().starts_with("out of memory while "));
}

TEST_CASE("messages: of a run, its warnings, its progress, and where it stopped") {
  const TempFolder folder;
  const std::string light = replaced(kCase, "density = 2000.0", "density = 100.0") + "[motion]\nrecord = \"bam-like\"\n";
  const std::string file = shell::quoted(written(folder, light));
  const std::string run = "run " + file + " -j 1 -o " + shell::quoted(folder.path("run"));
  Said s = said(run);
  CHECK(s.code == 0);
  std::vector<std::string> kinds;
  for (const Json& m : s.messages) kinds.push_back(m["kind"]);
  CHECK(std::ranges::count(kinds, "warning") == 1);
  CHECK(std::ranges::count(kinds, "info") == 1);  // of the motion
  CHECK(std::ranges::count(kinds, "progress") == 1);
  CHECK(said(run + " --overwrite --quiet").messages.size() == 1);
  // A run of hours, stopped after a second.
  s = said(run + " --overwrite --set motion= --duration 1e5", "", " & sleep 1; kill -INT $!; wait $!");
  CHECK(s.code == 130);
  REQUIRE(!s.messages.empty());
  const Json& last = s.messages.back();
  CHECK(last["kind"] == "stopped");
  CHECK(last["folder"] == folder.path("run"));
  CHECK(last["time"].get<double>() > 0.0);
  CHECK(last["signal"] == 2);
  CHECK(last["stage"] == "shaking");
}
