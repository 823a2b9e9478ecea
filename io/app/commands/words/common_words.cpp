// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/commands/words/common_words.h"

#include <CLI/CLI.hpp>
#include <string>

#include "io/app/commands/words/number_range.h"
#include "io/app/session/process.h"

namespace voussoir::io {

void add_threads(CLI::App& command, int& threads) {
  command.add_option("-j,--threads", threads, "threads (default: OMP_NUM_THREADS, else all cores)")->check(CLI::Range(1, kMostThreads));
}

void add_format(CLI::App& command, bool& json) {
  command
      .add_option_function<std::string>(
          "--format", [&json](const std::string& word) { json = word == "json"; }, "text, or json: one object")
      ->check(CLI::IsMember({"text", "json"}));
}

void add_checkpoints(CLI::App& command, CheckpointSchedule& schedule) {
  command.add_option("--checkpoint-every", schedule.wall_clock, "wall-clock between two checkpoints, s (default 300)")
      ->check(number_range(0.0, 1e12));
  command.add_option("--checkpoint-simulated", schedule.simulated, "simulated time between two checkpoints, s, if that comes sooner")
      ->check(number_range(1e-9, 1e12));
}

void add_views(CLI::App& command, Views& views) {
  command.add_flag("--report", views.page, "at the end write the page that `voussoir report` writes");
  command.add_option("--report-every", views.page_every, "write it while the run goes on, too: every so many s of wall-clock")
      ->check(number_range(1e-9, 1e12));
  command.add_flag("--paraview", views.paraview, "at the end write run.xdmf and paraview.h5 (0.3 MB a frame of a house)");
}

}  // namespace voussoir::io
