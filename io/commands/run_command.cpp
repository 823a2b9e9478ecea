// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/commands/run_command.h"

#include <omp.h>

#include "io/commands/session.h"
#include "io/commands/tie_lines.h"
#include "io/files/run_folder.h"
#include "io/motion/motion_files.h"
#include "io/motion/support_motion.h"

namespace voussoir::io {

int run_command(const LoadedCase& c, const RunOptions& o) {
  // Everything that can be wrong with the input is found before the folder is touched.
  cases::Model model = cases::build_model(c.value);
  load_support_motions(model, c.value.folder);
  const cases::GroundMotion motion = c.value.motion ? load_motion(*c.value.motion, c.value.folder) : cases::GroundMotion{};
  solver::Options options;
  options.reference_kernels = o.reference_kernels;
  options.gather = o.gather;
  options.threads = o.threads;
  solver::Simulation sim(c.value, model, motion, options);
  print_bounded_ties(sim.world().ties, model);

  const RunFolder folder = RunFolder::create(o.folder, o.overwrite);
  const std::string resolved = resolved_toml(anchored(c.value));
  folder.write_case(resolved);
  ResultsWriter results(folder.path(), model, resolved, history_names(c.value), provenance(sim.threads()));

  Checkpoints checkpoints(folder.path(), facts_of(sim, resolved, motion, o.reference_kernels), o.checkpoints);
  solver::RunState plan;
  const int code = run_session(c.value, sim, plan, results, checkpoints, folder.path(), o.quiet, o.views.page_every);
  if (code == kDone) write_views(folder.path(), o.views);
  return code;
}

}  // namespace voussoir::io
