// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cases/input_error.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/command_word.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/messages/messages.h"
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

namespace {

/// Whether the words of the command line ask for messages in JSON; looked at first, since faults of these words are messages, too.
bool asks_for_json(std::span<char* const> words) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (word == "--messages=json" || (word == "--messages" && i + 1 < words.size() && std::string_view(words[i + 1]) == "json"))
      return true;
  }
  return false;
}

/// The words that no option takes, in the order of the command line: the parser names them backwards.
std::string unexpected(const CLI::App& program, const std::string& said) {
  constexpr std::string_view kHead = "not expected: ";
  const std::size_t head = said.find(kHead), end = said.find('\n', head);
  if (head == std::string::npos || end == std::string::npos) return said;
  std::string words;
  for (const std::string& word : program.remaining(true)) words += (words.empty() ? "" : " ") + word;
  return said.substr(0, head + kHead.size()) + words + said.substr(end);
}

/// Refuses empty words on the command line, as a shell variable that is not set leaves them. \throw CLI::ValidationError
void refuse_empty_words(const CLI::App& program) {
  for (const CLI::App* command : program.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      if (std::ranges::any_of(option->results(), [](const std::string& word) { return word.empty(); }))
        throw CLI::ValidationError(option->get_name(), "is empty");
    }
  }
}

/// Prints what the parser says of the words, with a suggestion. \return the exit code
int end_parsing(const CLI::App& program, const CLI::ParseError& e, const std::string& suggestion) {
  std::ostringstream said;
  if (program.exit(e, std::cout, said) == 0) return io::kDone;
  const std::string text = unexpected(program, said.str()) + suggestion;
  if (io::says_json())
    io::say_error(io::kInputFault, {.text = text.substr(0, text.find_last_not_of('\n') + 1)});
  else
    io::say_lines(text);
  return io::kInputFault;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
  io::say_as_json(asks_for_json(words));
  io::prepare_process();
  CLI::App program{"Voussoir: how masonry buildings crack, fail and collapse in earthquakes"};
  program.set_version_flag("--version", "voussoir " + io::program_version());
  program.add_option("--messages", "text, or json: what the program says on standard error, one object a line")
      ->check(CLI::IsMember({"text", "json"}));
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
    refuse_empty_words(program);
    return work(*std::ranges::find_if(commands, [&](const io::Command& c) { return program.got_subcommand(c.words); }));
  } catch (const CLI::ExtrasError& e) {
    return end_parsing(program, e, io::suggested_option(program, {argv + 1, argv + argc}));
  } catch (const CLI::ParseError& e) {
    return end_parsing(program, e, io::suggested_option(program, {argv + 1, argv + argc}) + io::suggested_value(e.what()));
  } catch (const solver::NumericalError& e) {
    io::say_error(io::kNumericalFailure, {.text = std::string("numerical failure: ") + e.what()});
    return io::kNumericalFailure;
  } catch (const io::FileError& e) {
    io::say_error(io::kFileFault, e.message());
    return io::kFileFault;
  } catch (const io::CaseFileError& e) {
    io::say_errors(io::kInputFault, e.faults());
    return io::kInputFault;
  } catch (const cases::InputError& e) {
    io::say_errors(io::kInputFault, {{.text = e.what(), .key = e.key()}});
    return io::kInputFault;
  } catch (const std::exception& e) {
    return io::end_unexpectedly(e);
  }
}
