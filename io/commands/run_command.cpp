// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/run_command.h"

#include <cstdio>
#include <optional>

#include "cases/census.h"
#include "io/files/errors.h"
#include "io/files/run_folder.h"
#include "io/motion/motion_files.h"
#include "io/results/base_motion.h"
#include "io/session/likely_slips.h"
#include "io/session/prepared_case.h"
#include "io/session/session.h"
#include "io/session/tie_lines.h"
#include "solver/analysis/drive.h"

namespace voussoir::io {

namespace {

/// A step that the case or --dt gives may be too large.
void warn_of_step(const cases::Case& c, const cases::Model& model, double dt) {
  if (!c.time.step) return;
  const double bound = cases::census(model).step_bound;
  if (dt <= bound) return;
  std::fprintf(stderr, "voussoir: warning: the step of %.4g s is above its bound, %.4g s (Eq. 19): the run may diverge\n", dt, bound);
}

}  // namespace

int run_command(const LoadedCase& c, const RunOptions& o) {
  // Everything that can be wrong with the input is found before the folder is touched.
  const cases::Model model = prepared_model(c.value);
  const cases::GroundMotion motion = ground_motion(c.value);
  solver::Options options;
  options.reference_kernels = o.reference_kernels;
  options.gather = o.gather;
  solver::Simulation sim(c.value, model, motion, options);
  choose_drive(sim, c.value);
  print_bounded_ties(sim.world().ties, model);
  warn_of(likely_slips(c, model, motion));
  warn_of_step(c.value, model, sim.world().dt);

  cases::Case used = anchored(c.value);
  used.output.frame_interval = cases::frame_interval(used, model.blocks.size());

  const RunFolder folder = RunFolder::create(o.folder, o.overwrite);
  const std::string resolved = resolved_toml(used);
  ResultsOptions kept;
  kept.motion = motion_datasets(c.value, motion, sim.dt(), sim.cycle());
  kept.cuts = cut_names(c.value);
  std::optional<ResultsWriter> results;
  try {
    folder.write_case(resolved);
    results.emplace(folder.path(), model, resolved, history_names(c.value), provenance(sim.threads()), kept);
  } catch (const FileError&) {
    print_way_on(folder.path());
    throw;
  }
  if (!o.quiet) std::fputs(motion_lines(c.value, motion).c_str(), stderr);

  Checkpoints checkpoints(folder.path(), facts_of(sim, resolved, motion, o.reference_kernels), o.checkpoints);
  solver::RunState plan;
  const int code = run_session(c.value, sim, plan, *results, checkpoints, folder.path(), o.quiet, o.views.page_every);
  if (code == kDone) write_views(folder.path(), o.views);
  return code;
}

}  // namespace voussoir::io
