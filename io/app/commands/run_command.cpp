// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/model.h"
#include "geometry/message.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/commands/words/common_words.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/likely_slips.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/process.h"
#include "io/app/session/run_extent.h"
#include "io/app/session/session.h"
#include "io/app/session/verify_run.h"
#include "io/app/session/words/tie_lines.h"
#include "io/input/files/errors.h"
#include "io/input/files/run_folder.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "io/output/results/base_motion.h"
#include "solver/analysis/drive.h"

namespace voussoir::io {

namespace {

struct RunOptions {
  std::string folder;  // of the results
  bool reference_kernels = false;
  bool overwrite = false, quiet = false;
  int threads = 1;  // at most
  CheckpointSchedule checkpoints;
  Views views;  // written at the end
};

/// Warns if a step given by the case or by --dt is too large.
void warn_of_step(const cases::Case& c, const cases::Model& model, double dt) {
  if (!c.time.step) return;
  const double bound = cases::census(model).step_bound;
  if (dt <= bound) return;
  say_warning(geometry::printed("the step of %.4g s is longer than the largest stable one, %.4g s: the run may diverge", dt, bound));
}

/// Builds, settles, shakes and writes. \return kDone, kNumericalFailure, or 128 + the signal that stopped it.
/// \throw cases::InputError, FileError before anything runs; FileError later if results cannot be written
int run(const LoadedCase& c, const RunOptions& o) {
  // All faults of the input are found before the folder is changed.
  cases::Model model = prepared_model(c.value, o.threads);
  const cases::GroundMotion motion = ground_motion(c.value);
  solver::Options options;
  options.reference_kernels = o.reference_kernels;
  options.threads = o.threads, options.own_pace = true;
  auto sim = std::make_unique<solver::Simulation>(c.value, model, motion, options);
  give_memory_back();
  choose_drive(*sim, c.value);
  refuse_endless(c.value, model, *sim);
  print_bounded_ties(sim->world().ties, model);
  warn_of(likely_slips(c, model, motion));
  warn_of_step(c.value, model, sim->world().dt);

  cases::Case used = anchored(c.value);
  used.output.frame_interval = cases::frame_interval(used, model.blocks.size());

  const RunFolder folder = RunFolder::create(o.folder, o.overwrite);
  const std::string resolved = resolved_toml(used);
  ResultsOptions kept;
  kept.motion = motion_datasets(c.value, motion, sim->dt(), sim->cycle());
  std::ranges::move(load_datasets(c.value, model), std::back_inserter(kept.motion));
  kept.cuts = cut_names(c.value);
  std::optional<ResultsWriter> results;
  try {
    folder.write_case(resolved);
    results.emplace(folder.path(), model, resolved, history_names(c.value), provenance(sim->threads()), kept);
  } catch (const FileError&) {
    print_way_on(folder.path());
    throw;
  }
  cases::forget_joints(model);
  give_memory_back();
  if (!o.quiet) say_lines(motion_lines(c.value, motion));

  Checkpoints checkpoints(folder.path(), facts_of(*sim, resolved, motion, o.reference_kernels), o.checkpoints);
  solver::RunState plan;
  const int code = run_session(c.value, std::move(sim), plan, *results, checkpoints, folder.path(), o.quiet, o.views.page_every);
  if (code == kDone) write_views(folder.path(), o.views);
  return code;
}

struct RunWords {
  CaseWords c;
  RunOptions run;
  std::string kernels = "fast";
  bool verify = false;
};

int run_as_told(RunWords& w) {
  w.run.reference_kernels = w.kernels == "reference";
  if (w.verify) return with_case(w.c, [&](const auto& c) { return verify(c, w.run.reference_kernels, w.c.threads); });
  w.run.threads = w.c.threads;
  if (w.run.folder.empty()) w.run.folder = "results/" + std::filesystem::path(w.c.name).stem().string();
  return with_case(w.c, [&](const auto& c) { return run(c, w.run); });
}

}  // namespace

Command add_run(CLI::App& program) {
  CLI::App* words = program.add_subcommand("run", "build, settle under gravity, shake, write results");
  auto w = std::make_shared<RunWords>();
  add_case(*words, w->c);
  words->add_option("-o,--output", w->run.folder, "folder of the results (default: results/CASE)");
  add_short_keys(*words, w->c);
  words->add_option("--kernels", w->kernels, "fast, or reference: every segment on its own in plain code")
      ->check(CLI::IsMember({"fast", "reference"}));
  add_checkpoints(*words, w->run.checkpoints);
  words->add_flag("--verify", w->verify, "no results: try in about a minute that threads and stops do not change a bit of this case");
  add_views(*words, w->run.views);
  words->add_flag("--overwrite", w->run.overwrite, "replace the results that the folder holds");
  words->add_flag("--quiet", w->run.quiet, "no progress");
  words->footer(
      "to push, tilt or settle it instead: analysis.kind, in the case or by --set\nexample: voussoir run flat20n --direction LTV "
      "--duration 6 -o results/flat20n-LTV\n         voussoir run flat20n --set analysis.kind=pushover -o results/flat20n-push");
  return {.words = words, .work = [w] { return run_as_told(*w); }, .threads = &w->c.threads};
}

}  // namespace voussoir::io
