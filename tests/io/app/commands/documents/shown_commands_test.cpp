// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// The commands that the first pages show do what they say: each is run, in the order of its page, the runs shortened.
namespace {

/// Lines that call the program, of the blocks of a page that are in no language; without comments.
std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  std::istringstream lines(shell::text_of(VOUSSOIR_SOURCE_DIR "/" + page));
  bool in_block = false, in_no_language = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("```") < 3) in_block = !in_block, in_no_language = in_block && line == "```";
    if (!in_no_language || !line.starts_with("voussoir ")) continue;
    const std::string command = line.substr(0, line.find(" #"));
    commands.push_back(command.substr(0, command.find_last_not_of(' ') + 1));
  }
  return commands;
}

/// A line of a list of commands with what each does; or what asks for a record of the reader's own, or for a browser.
bool is_left_out(const std::string& command) {
  for (const char* part : {"   ", "path/to", "--stills", "--film"})
    if (command.find(part) != std::string::npos) return true;
  return false;
}

/// A run of some steps, which needs no rest before.
std::string shortened(const std::string& command) {
  if (!command.starts_with("voussoir run ")) return command;
  std::string text = std::regex_replace(command, std::regex(" --duration [0-9.]+"), "");
  text += " --quiet --overwrite --set gravity.settle=false";
  if (command.find("analysis.kind") == std::string::npos) return text + " --duration 0.01";
  return text + " --set analysis.solver=dynamics --set analysis.longest=0.01";
}

/// Runs the commands of a page in a folder. \return how many
int run_all(const std::string& page, const TempFolder& folder) {
  const std::string to_folder = "cd " + shell::quoted(folder.path()) + " && ";
  int count = 0;
  for (const std::string& command : commands_of(page)) {
    if (is_left_out(command)) continue;
    const std::string words = shortened(command).substr(std::string("voussoir ").size());
    const shell::Outcome o = shell::run(to_folder + shell::kProgram + " " + words + " 2>&1");
    INFO(page << ": " << command << "\n" << o.text);
    CHECK(o.code == 0);
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("shown: the commands of README, your house, the tutorial, cases and io") {
  if (shell::kSanitizer) return;  // too slow
  const TempFolder first, own, tutorial, cases, io;
  for (const char* name : {"hut.toml", "hut-strong.toml"})
    std::filesystem::copy_file(std::string(VOUSSOIR_SOURCE_DIR "/cases/tutorial/") + name, tutorial.path(name));
  CHECK(run_all("README.md", first) >= 3);
  CHECK(run_all("cases/YOUR_HOUSE.md", own) >= 3);
  CHECK(run_all("cases/tutorial/README.md", tutorial) >= 5);
  CHECK(run_all("cases/README.md", cases) >= 3);
  CHECK(run_all("io/README.md", io) >= 3);
}
