// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cases/input_error.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/command_word.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/output/results/provenance.h"
#include "solver/world/errors.h"

namespace {

using namespace voussoir;

int work(const io::Command& command) {
  // The only place that chooses a number of threads; all others are told.
  if (command.threads != nullptr && *command.threads == 0) *command.threads = std::min(omp_get_max_threads(), io::kMostThreads);
  if (command.threads != nullptr) *command.threads = io::threads_to_be_had(*command.threads);
  io::start_command();
  io::now_doing("working");
  return io::code_after_output(command.work());
}

}  // namespace

int main(int argc, char** argv) {
  io::prepare_process();
  CLI::App program{"Voussoir: how masonry buildings crack, fail and collapse in earthquakes"};
  program.set_version_flag("--version", "voussoir " + io::program_version());
  program.require_subcommand(1);
  program.footer(
      "in the order of work: describe (new, cases, keys), look (view, check), without a run (modes, limit, motion), run, read (summary,\n"
      "assess, report, compare), many runs (study)\n"
      "to begin: voussoir new house my-house.toml; voussoir check my-house.toml; voussoir run my-house.toml -o results/my-house\n"
      "documents: cases/tutorial (ten minutes), README.md, io/QUESTIONS.md (each question with its command); installed: below\n"
      "/usr/share/doc/voussoir\n"
      "example: voussoir run flat20n --direction LTV --duration 6");
  std::vector<io::Command> commands;
  for (const io::AddCommand add : io::all_commands()) commands.push_back(add(program));
  try {
    if (argc > 1) io::check_command_word(program, argv[1]);
    program.parse(argc, argv);
    return work(*std::ranges::find_if(commands, [&](const io::Command& c) { return program.got_subcommand(c.words); }));
  } catch (const CLI::ExtrasError& e) {
    program.exit(e);
    io::suggest_option(program, {argv + 1, argv + argc});
    return io::kInputFault;
  } catch (const CLI::ParseError& e) {
    if (program.exit(e) == 0) return io::kDone;
    io::suggest_value(e.what());
    return io::kInputFault;
  } catch (const solver::NumericalError& e) {
    std::fprintf(stderr, "voussoir: numerical failure: %s\n", e.what());
    return io::kNumericalFailure;
  } catch (const io::FileError& e) {
    std::fprintf(stderr, "voussoir: %s\n", e.what());
    return io::kFileFault;
  } catch (const cases::InputError& e) {
    io::tell(e.what());
    return io::kInputFault;
  } catch (const std::exception& e) {
    return io::end_unexpectedly(e);
  }
}
