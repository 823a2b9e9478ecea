// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run_command.h"

#include <omp.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "io/errors.h"
#include "io/motion_files.h"
#include "io/progress.h"
#include "io/results.h"
#include "io/run_folder.h"
#include "io/support_motion.h"
#include "solver/errors.h"
#include "solver/field_table.h"
#include "solver/run.h"

namespace voussoir::io {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

/// Asks the run to stop after the step it is in, as long as it lives.
class StopOnSignals {
 public:
  StopOnSignals() {
    stop_signal = 0;
    for (const int s : {SIGINT, SIGTERM}) std::signal(s, [](int n) { stop_signal = n; });
  }
  StopOnSignals(const StopOnSignals&) = delete;
  StopOnSignals& operator=(const StopOnSignals&) = delete;
  ~StopOnSignals() {
    for (const int s : {SIGINT, SIGTERM}) std::signal(s, SIG_DFL);
  }
};

std::vector<std::string> history_names(const cases::Case& c) {
  std::vector<std::string> names;
  for (const cases::HistoryPoint& h : c.output.history) names.push_back(h.name);
  return names;
}

void print_summary(const solver::Summary& s, std::uint64_t hash, const std::string& folder) {
  std::printf("collapsed            %s\n", s.collapsed ? "yes" : "no");
  std::printf("fallen mass          %.1f %%\n", 100.0 * s.fallen_mass_fraction);
  if (s.first_crack_time >= 0.0) {
    std::printf("first crack          %.3f s\n", s.first_crack_time);
  } else {
    std::printf("first crack          none\n");
  }
  std::printf("broken segment sides %s in tension, %s in shear, %s in compression; %s slipped\n", format_count(s.tension).c_str(),
              format_count(s.shear).c_str(), format_count(s.compression).c_str(), format_count(s.slipped).c_str());
  std::printf("peak base shear      %.1f kN\n", 1e-3 * s.peak_base_shear);
  std::printf("peak speed           %.2f m/s\n", s.peak_speed);
  std::printf("energy residual      %.2g at worst\n", s.worst_residual);
  std::printf("state hash           %016llx\n", static_cast<unsigned long long>(hash));
  if (!s.settled) std::printf("warning              gravity did not come to rest before the shaking began\n");
  std::printf("results              %s/run.h5 (to %.3f s)\n", folder.c_str(), s.end_time);
}

/// Wall-clock by stage, of the stages that take any.
void print_stages(const solver::StageTimes& times) {
  double total = 0.0;
  for (const double t : times) total += t;
  std::printf("time by stage       ");
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] > 0.001 * total) std::printf(" %s %.1f s (%.1f %%)", solver::kStageNames[k], times[k], 100.0 * times[k] / total);
  }
  std::printf("\n");
}

}  // namespace

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

  const RunFolder folder = RunFolder::create(o.folder, o.overwrite);
  const std::string resolved = resolved_toml(c.value);
  folder.write_case(resolved);
  ResultsWriter results(folder.path(), model, resolved, history_names(c.value), provenance(omp_get_max_threads()));

  const StopOnSignals stops;
  const auto start = std::chrono::steady_clock::now();
  Progress progress(std::cerr, Progress::mode_for(2, o.quiet));
  const auto tick = [&](const solver::RunStatus& s) {
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.update({s.time, s.end, s.settling, s.step, s.broken, s.residual}, wall);
    return stop_signal == 0;
  };
  try {
    const solver::RunResult r = solver::run(sim, c.value, c.value.time.duration, results, tick);
    progress.finish();
    r.stopped ? results.flush() : static_cast<void>(results.finish());
    print_summary(r.summary, solver::state_hash(sim.world()), folder.path());
    print_stages(sim.stage_times());
    return r.stopped ? 128 + static_cast<int>(stop_signal) : kDone;
  } catch (const solver::NumericalError& e) {
    progress.finish();
    results.flush();
    std::fprintf(stderr, "voussoir: numerical failure: %s\n", e.what());
    return kNumericalFailure;
  }
}

}  // namespace voussoir::io
