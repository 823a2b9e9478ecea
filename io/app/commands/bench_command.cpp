// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/model.h"
#include "cases/names.h"
#include "cases/solids/origin.h"
#include "geometry/nth.h"
#include "io/app/bench/bench_rows.h"
#include "io/app/bench/bench_stages.h"
#include "io/app/bench/bench_table.h"
#include "io/app/bench/bench_timing.h"
#include "io/app/commands/command.h"
#include "io/app/commands/words/case_words.h"
#include "io/app/commands/words/number_range.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/progress.h"
#include "io/app/session/restored_run.h"
#include "io/app/session/session.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/scratch_folder.h"
#include "io/input/motion/motion_files.h"
#include "solver/analysis/drive.h"
#include "solver/bench/machine.h"
#include "solver/bench/memory.h"
#include "solver/bench/step_work.h"
#include "solver/run/simulation.h"

namespace voussoir::io {

namespace {

struct BenchOptions {
  int threads = 1;         // at most
  double after = 0.0;      // s of shaking before the measurement; 0: intact, at the beginning of gravity
  int batches = 0;         // number of batches for a median; 0: 15, or up to 60 on a machine that is seldom quiet
  int steps = 0;           // in a batch; 0: the number that takes about 0.1 s
  std::string csv;         // CSV file for the table; empty: none
  std::string stages_csv;  // CSV file for the table of stages; empty: none
  bool overwrite = false;
};

/// Numbers of sides by state.
struct Sides {
  std::int64_t whole = 0, open = 0, damaged = 0, steady = 0, points = 0, contacts = 0;
};
Sides sides_now(const solver::World& w) {
  Sides n;
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    if (w.sides.joint[id] < 0 || w.sides.retired[id]) continue;
    const kernels::SideState state = w.sides.side_state[id];
    n.whole += state == kernels::SideState::whole;
    n.open += state == kernels::SideState::open;
    n.steady += state == kernels::SideState::steady;
    if (state != kernels::SideState::segments && state != kernels::SideState::steady) continue;
    ++n.damaged;
    n.points += nth(w.points.count, w.sides.set[id]);
  }
  n.contacts = static_cast<std::int64_t>(w.contacts.active.size());
  return n;
}

/// Advances a simulation to the state to be measured.
void advance_to(solver::Simulation& sim, double after) {
  if (after <= 0.0) return;
  while (sim.phase() == solver::Phase::settling && !sim.at_rest() && !sim.settled_too_long()) sim.step({false, sim.steps() % 200 == 0});
  sim.start_shaking();
  while (sim.time() < after) sim.step({});
}

std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int n = 1; n < most; n *= 2) counts.push_back(n);
  counts.push_back(most);
  return counts;
}

void print_subject(const cases::Census& census, const solver::World& w) {
  const Sides n = sides_now(w);
  std::printf("elements                 %s\n", format_count(census.elements).c_str());
  std::printf("joints                   %s, in %zu tasks of %zu colours\n", format_count(census.joints + census.base_joints).c_str(),
              w.sides.task_first.size() - 1, w.sides.colour_first.size() - 1);
  std::printf("contact points           %s\n", format_count(census.joint_sides).c_str());
  std::printf("joints now               %s whole, %s open, %s damaged (%s of them steady) with %s segments; %s patches near others\n",
              format_count(n.whole).c_str(), format_count(n.open).c_str(), format_count(n.damaged).c_str(), format_count(n.steady).c_str(),
              format_count(n.points).c_str(), format_count(n.contacts).c_str());
  const solver::MemoryUse use = solver::memory_use(w);
  const auto per = [](std::size_t bytes, std::int64_t count) {
    return static_cast<double>(bytes) / static_cast<double>(std::max<std::int64_t>(1, count));
  };
  std::printf("memory                   %.0f B an element, %.0f a side of a joint, %.1f a segment; free patches %.1f MB\n",
              per(use.elements, census.elements), per(use.sides, n.whole + n.open + n.damaged),
              per(use.segments, static_cast<std::int64_t>(w.sides.bond.size())), 1e-6 * static_cast<double>(use.patches));
}

/// Prints step times for more cores, predicted by the model of the schedule.
void print_schedule(const solver::JointTasks& tasks, std::span<const StepSplit> splits, std::span<const Timing> timings) {
  constexpr double kNear = 60e-9;  // s, for cores that share a cache, if there is only one core
  constexpr std::array kCores{1, 2, 4, 8, 16, 32};
  const auto split_of = [&](int threads) { return std::ranges::find(splits, threads, &StepSplit::threads); };
  const auto one = split_of(1), two = split_of(2);
  const bool both = two != splits.end() && solver::processors() > 1;
  const auto timing_of = [&](int threads) { return std::ranges::find(timings, threads, &Timing::threads); };
  const double handover = both && timing_of(2)->handover > 0.0 ? timing_of(2)->handover : kNear;
  const solver::MeasuredStep measured{.tasks = one->tasks,
                                      .one = one->stages,
                                      .two = both ? two->stages : solver::StageTimes{},
                                      .parts = one->forces,
                                      .alone = one->alone,
                                      .handover = handover};
  const double on_one = timing_of(1)->step, scale = on_one / solver::predict(tasks, measured, 1).step;
  std::printf("\nby a model of the schedule, from what was measured above; hand-over %.0f ns%s\n", 1e9 * handover,
              both ? "" : "; what one thread does alone is not known without a second one");
  BenchTable table(schedule_header(), {"", FileKind::table, ""});
  table.print_header();
  for (const int cores : kCores) {
    const auto known = timing_of(cores);
    const bool seen = known != timings.end() && cores <= solver::processors();
    table.add(schedule_row(solver::predict(tasks, measured, cores), scale, on_one, seen ? known->step : 0.0));
  }
}

/// Prints the times of parts of a step, from a separate measurement. \param folder  for temporary results
template <class Run>
void bench_stages(Run& run, const std::string& folder, std::span<const Timing> timings, const std::vector<MachineLimits>& best, int batches,
                  BenchTable& table) {
  ResultsOptions when_told;
  when_told.interval = 1e9, when_told.bytes = std::numeric_limits<std::size_t>::max();
  when_told.cuts = cut_names(run.value);
  std::filesystem::create_directory(folder);
  ResultsWriter results(folder, run.model, "", history_names(run.value), provenance(0), when_told);
  std::vector<int> counts, steps;
  for (const Timing& t : timings) counts.push_back(t.threads), steps.push_back(t.steps);
  const std::vector<StepSplit> splits = split_steps({run.value, *run.sim, run.plan, results}, counts, steps, batches);
  for (std::size_t k = 0; k < splits.size(); ++k) {
    for (const Cells& cells : stage_rows(splits[k], best[k])) table.add(cells);
  }
  print_schedule(run.sim->joint_tasks(), splits, timings);
}

/// Machine limits by number of threads; threads beyond the number of cores add nothing.
std::vector<MachineLimits> limits_of(std::span<const int> counts) {
  std::vector<MachineLimits> limits;
  for (const int n : counts) {
    const int cores = std::min(n, solver::processors());
    limits.push_back({solver::peak_flops(cores), solver::peak_bandwidth(cores)});
    std::printf("%-25s%.1f Gflop/s, %.1f GB/s on %d\n", limits.size() == 1 ? "machine at best" : "", 1e-9 * limits.back().flops,
                1e-9 * limits.back().bandwidth, cores);
    if (n >= solver::processors()) return limits.resize(counts.size(), limits.back()), limits;
  }
  return limits;
}

/// Prints all tables of one case or checkpoint.
template <class Run>
void bench(Run& run, const BenchOptions& o) {
  const Output csv{o.csv, FileKind::table, "--csv", o.overwrite}, stages_csv{o.stages_csv, FileKind::table, "--stages-csv", o.overwrite};
  for (const Output& output : {csv, stages_csv}) check_output(output);
  const ScratchFolder scratch;
  BenchTable table(timing_header(), csv), stages(stage_header(), stages_csv);
  const cases::Census census = cases::census(run.model);
  const std::vector<int> counts = thread_counts(o.threads);
  TimingOptions timing;
  if (o.batches > 0) timing.least = timing.most = o.batches;
  timing.steps = o.steps;
  solver::Simulation& sim = *run.sim;
  sim.set_threads(counts.back());
  advance_to(sim, o.after);
  run.plan.shaking |= sim.phase() == solver::Phase::shaking;
  print_subject(census, sim.world());
  const std::vector<MachineLimits> best = limits_of(counts);
  std::printf("\n");
  table.print_header();
  const std::vector<Timing> timings = time_steps(sim, counts, timing);
  for (const Timing& t : timings) table.add(timing_row(t, census));
  std::printf("\n");
  stages.print_header();
  bench_stages(run, scratch.path() + "/run", timings, best, timing.least, stages);
}

/// A new run of a case, in the form of RestoredRun.
struct FreshRun {
  const cases::Case& value;
  const cases::Model& model;
  solver::RunState plan;
  std::unique_ptr<solver::Simulation> sim;
};

/// Steps the case with 1, 2, 4, ... threads, up to o.threads, and prints tables: times of a step and of its parts, and the predictions of a
/// model of the schedule for more cores. \throw cases::InputError, FileError before anything runs
int bench_case(const LoadedCase& c, const BenchOptions& o) {
  const cases::Model model = prepared_model(c.value, o.threads);
  cases::GroundMotion motion;  // without a motion nothing happens, even after settling
  if (o.after > 0.0) motion = ground_motion(c.value);
  solver::Options options;
  options.threads = o.threads;
  FreshRun run{c.value, model, {}, std::make_unique<solver::Simulation>(c.value, model, motion, options)};
  choose_drive(*run.sim, c.value);
  bench(run, o);
  return kDone;
}

/// Benchmarks the state of a checkpoint. \throw FileError, and cases::InputError if o.after is given
int bench_checkpoint(const std::string& path, const BenchOptions& o) {
  if (o.after > 0.0)
    throw cases::InputError("--after", "= " + cases::text(o.after) + " s; a checkpoint is measured as it stands, leave it out");
  note_input(path);
  Checkpoint checkpoint = read_checkpoint(path);
  cases::Case value = read_case({path, checkpoint.facts.case_toml, "."}).value;
  solver::Options options;
  options.threads = o.threads;
  const std::unique_ptr<RestoredRun> run = restore_run(path, std::move(checkpoint), std::move(value), options);
  bench(*run, o);
  return kDone;
}

struct BenchWords {
  CaseWords c;
  BenchOptions o;
};

int bench_as_told(BenchWords& w) {
  w.o.threads = w.c.threads;
  if (w.c.name.ends_with(".h5")) return bench_checkpoint(w.c.name, w.o);
  return with_case(w.c, [&](const auto& c) { return bench_case(c, w.o); });
}

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* words = program.add_subcommand("bench", "time per step, joint and segment, and where it goes; thread scaling");
  auto w = std::make_shared<BenchWords>();
  add_case(*words, w->c);
  words->add_option("--after", w->o.after, "s of shaking before it is measured (default: 0, intact)")->check(number_range(0.0, 1e12));
  words
      ->add_option("--batches", w->o.batches,
                   "a figure is the median of so many batches of steps (default: 15, up to 60 if the machine is seldom quiet)")
      ->check(CLI::Range(1, 1000));
  words->add_option("--steps", w->o.steps, "steps in a batch (default: about 0.1 s of them)")->check(CLI::Range(1, 1000000));
  words->add_option("--csv", w->o.csv, "also write the table of what a step takes to this file");
  words->add_option("--stages-csv", w->o.stages_csv, "also write the table of where it goes, part by part, to this file");
  words->add_flag("--overwrite", w->o.overwrite, "replace these files");
  words->footer(
      "CASE may also be a checkpoint (.h5) of a run: measured as it stands there\nexample: voussoir bench flat20n -j 2 --after 3.5");
  return {.words = words, .work = [w] { return bench_as_told(*w); }, .threads = &w->c.threads};
}

}  // namespace voussoir::io
