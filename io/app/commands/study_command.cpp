// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/app/commands/command.h"
#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

namespace fs = std::filesystem;

/// The script that runs studies: of the checkout that this program was built in, or beside an installed program.
fs::path study_script(const fs::path& program) {
  for (const char* from : {"../../../scripts/study/run", "../share/voussoir/scripts/study/run"}) {
    const fs::path script = (program.parent_path() / from).lexically_normal();
    if (std::error_code error; fs::exists(script, error)) return script;
  }
  const std::string remedy =
      "use the program in build/release/io of a checkout, or install it with its scripts (scripts/package); or, for this one, ";
  throw FileError("scripts/study/run", "is neither in the checkout of " + program.string() + " nor installed beside it; " + remedy +
                                           "VOUSSOIR=" + program.string() + " CHECKOUT/scripts/study/run STUDY.toml");
}

/// Becomes the script, which runs this program for every run of the study. A Python beside the program, as pip puts it there, runs the
/// script.
int run_study(const std::string& file, const std::vector<std::string>& more) {
  const fs::path program = fs::read_symlink("/proc/self/exe"), script = study_script(program);
  setenv("VOUSSOIR", program.c_str(), 0);  // another one that the user names stays
  std::vector<std::string> words{script.string(), file};
  words.insert(words.end(), more.begin(), more.end());
  const fs::path python = program.parent_path() / "python3";
  if (std::error_code error; fs::exists(python, error)) words.insert(words.begin(), python.string());
  std::vector<char*> given;
  for (std::string& word : words) given.push_back(word.data());
  given.push_back(nullptr);
  execv(given.front(), given.data());
  throw FileError(script.string(), "cannot be started; it needs /usr/bin/python3 with h5py (scripts/setup)");
}

}  // namespace

Command add_study(CLI::App& program) {
  CLI::App* words = program.add_subcommand("study", "many runs from one file, and one table of them; goes on after a stop");
  auto file = std::make_shared<std::string>();
  words->add_option("STUDY", *file, "the study file (.toml)")->required();
  words->allow_extras();
  words->footer(
      "Snakemake runs it where it is installed; else the runs follow each other, as many at once as there are cores.\n"
      "further options: -o FOLDER, --cores N, --check (runs nothing), --table (of what is there so far), --known TABLE.csv\n"
      "example: voussoir study scripts/study/tiny.toml -o results/tiny");
  return {.words = words, .work = [words, file] { return run_study(*file, words->remaining()); }};
}

}  // namespace voussoir::io
