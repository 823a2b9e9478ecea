// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/bench_command.h"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "cases/census.h"
#include "io/errors.h"
#include "io/motion_files.h"
#include "io/progress.h"
#include "io/restored_run.h"
#include "io/run_command.h"
#include "io/support_motion.h"
#include "io/waiting_threads.h"
#include "solver/field_table.h"
#include "solver/machine.h"
#include "solver/memory.h"
#include "solver/simulation.h"

namespace voussoir::io {

namespace {

constexpr double kBatch = 0.1;  // s, of steps

/// One line of the table.
struct Row {
  int threads = 1;
  bool gather = false;
  double step = 0.0;            // s
  double speedup = 1.0;         // against one thread
  double flops = 0.0;           // flop/s, what the machine gave these threads at that time
  double handover = 0.0;        // s, from one thread to the next
  solver::StageTimes stages{};  // s a step
};

/// Sides by what they are now.
struct Sides {
  std::int64_t whole = 0, open = 0, damaged = 0, steady = 0, points = 0, contacts = 0;
};
Sides sides_now(const solver::World& w) {
  Sides n;
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    if (w.sides.joint[id] < 0 || w.sides.retired[id]) continue;
    const kernels::Quick state = w.sides.quick[id];
    n.whole += state == kernels::Quick::whole;
    n.open += state == kernels::Quick::open;
    n.steady += state == kernels::Quick::steady;
    if (state != kernels::Quick::segments && state != kernels::Quick::steady) continue;
    ++n.damaged;
    n.points += w.points.count[static_cast<std::size_t>(w.sides.set[id])];
  }
  n.contacts = static_cast<std::int64_t>(w.contacts.active.size());
  return n;
}

/// Brings a simulation to where it is to be measured.
void advance_to(solver::Simulation& sim, double after) {
  if (after <= 0.0) return;
  while (sim.phase() == solver::Phase::settling && !sim.at_rest() && !sim.settled_too_long()) sim.step({false, sim.steps() % 200 == 0});
  sim.start_shaking();
  while (sim.time() < after) sim.step({});
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// One batch of steps.
struct Batch {
  double step = 0.0;            // s
  double flops = 0.0;           // flop/s, of nothing but arithmetic, before and after
  double handover = 0.0;        // s, from one thread to the next, likewise
  solver::StageTimes stages{};  // s a step
};
Batch measure_batch(solver::Simulation& sim, int steps) {
  const int threads = omp_get_max_threads();
  const double flops = solver::flops_now(threads), handover = solver::handover_now(threads);
  const solver::StageTimes before = sim.stage_times();
  const double start = omp_get_wtime();
  for (int i = 0; i < steps; ++i) sim.step({});
  Batch b{(omp_get_wtime() - start) / steps, 0.0, 0.0, {}};
  for (std::size_t k = 0; k < b.stages.size(); ++k) b.stages[k] = (sim.stage_times()[k] - before[k]) / steps;
  b.flops = 0.5 * (flops + solver::flops_now(threads));
  b.handover = 0.5 * (handover + solver::handover_now(threads));
  return b;
}

int steps_in_a_batch(solver::Simulation& sim, const BenchOptions& o) {
  if (o.steps > 0) return o.steps;
  return std::max(10, static_cast<int>(kBatch / measure_batch(sim, 10).step));
}

/// \param one  the same number of batches on one thread, each beside the one of `all` with its number
Row row_of(int threads, bool gather, const std::vector<Batch>& all, const std::vector<Batch>& one) {
  const auto over_batches = [&](auto figure) {
    std::vector<double> figures;
    for (std::size_t b = 0; b < all.size(); ++b) figures.push_back(figure(b));
    return median(std::move(figures));
  };
  Row row{threads,
          gather,
          over_batches([&](std::size_t b) { return all[b].step; }),
          over_batches([&](std::size_t b) { return one[b].step / all[b].step; }),
          over_batches([&](std::size_t b) { return all[b].flops; }),
          over_batches([&](std::size_t b) { return all[b].handover; }),
          {}};
  for (std::size_t k = 0; k < row.stages.size(); ++k) row.stages[k] = over_batches([&](std::size_t b) { return all[b].stages[k]; });
  return row;
}

/// Medians over batches of steps. The numbers of threads take turns, so that whatever else the machine does meets them all.
std::vector<Row> measure(solver::Simulation& sim, const std::vector<int>& counts, bool gather, const BenchOptions& o) {
  std::vector<std::vector<Batch>> batches(counts.size());
  std::vector<int> steps;
  for (const int threads : counts) {
    omp_set_num_threads(threads);
    steps.push_back(steps_in_a_batch(sim, o));
  }
  for (int batch = 0; batch < o.batches; ++batch) {
    for (std::size_t c = 0; c < counts.size(); ++c) {
      omp_set_num_threads(counts[c]);
      for (int i = 0; i < steps[c]; ++i) sim.step({});  // other threads have other shares, and other rows in their caches
      batches[c].push_back(measure_batch(sim, steps[c]));
    }
  }
  std::vector<Row> rows;
  for (std::size_t c = 0; c < counts.size(); ++c) rows.push_back(row_of(counts[c], gather, batches[c], batches.front()));
  return rows;
}

std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int n = 1; n < most; n *= 2) counts.push_back(n);
  counts.push_back(most);
  return counts;
}

std::string header() {
  std::string line = "scatter,threads,ms_per_step,steps_per_s,speedup,machine_gflops,handover_ns,ns_per_joint,ns_per_segment_side";
  for (const char* name : solver::kStageNames) line += std::string(",ms_") + name;
  return line;
}

/// One line as CSV.
std::string line(const Row& r, const cases::Census& n) {
  const double joints = static_cast<double>(n.joints + n.base_joints), segments = static_cast<double>(n.joint_sides);
  char text[400];
  int at =
      std::snprintf(text, sizeof text, "%s,%d,%.4f,%.0f,%.2f,%.1f,%.0f,%.1f,%.2f", r.gather ? "gather" : "colour", r.threads, 1e3 * r.step,
                    1.0 / r.step, r.speedup, 1e-9 * r.flops, 1e9 * r.handover, 1e9 * r.step / joints, 1e9 * r.step / segments);
  for (const double s : r.stages) at += std::snprintf(text + at, sizeof text - static_cast<std::size_t>(at), ",%.4f", 1e3 * s);
  return text;
}

/// CSV with its commas turned into columns.
void print_columns(const std::string& csv) {
  std::string cell;
  for (const char ch : csv + ",") {
    if (ch != ',') {
      cell += ch;
      continue;
    }
    std::printf("%*s ", std::max(9, static_cast<int>(cell.size())), cell.c_str());
    cell.clear();
  }
  std::printf("\n");
}

void print_subject(const cases::Census& census, const solver::World& w) {
  const Sides n = sides_now(w);
  std::printf("elements                 %s\n", format_count(census.elements).c_str());
  std::printf("joints                   %s, in %zu tasks of %zu colours\n", format_count(census.joints + census.base_joints).c_str(),
              w.sides.task_first.size() - 1, w.sides.colour_first.size() - 1);
  std::printf("segment sides            %s\n", format_count(census.joint_sides).c_str());
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

std::ofstream open_table(const BenchOptions& o) {
  if (o.csv.empty()) return {};
  if (!o.overwrite && std::filesystem::exists(o.csv)) throw FileError(o.csv, "exists; give another name or --overwrite");
  std::ofstream file(o.csv);
  if (!file) throw FileError(o.csv, "cannot be written");
  return file;
}

/// The tables of one subject: `build(gather)` makes its simulation anew.
template <class Build>
void bench(Build build, const cases::Model& model, const BenchOptions& o) {
  std::ofstream table = open_table(o);
  const cases::Census census = cases::census(model);
  const int most = o.threads > 0 ? o.threads : omp_get_max_threads();
  for (const bool gather : {false, true}) {
    omp_set_num_threads(most);
    auto holder = build(gather);
    solver::Simulation& sim = *holder->sim;
    advance_to(sim, o.after);
    if (!gather) {
      print_subject(census, sim.world());
      std::printf("waiting threads          %s\n", waiting_threads().c_str());
      std::printf("machine at best          %.1f Gflop/s on one thread; %.1f GB/s on %d\n\n", 1e-9 * solver::peak_flops(1),
                  1e-9 * solver::peak_bandwidth(most), most);
      print_columns(header());
      if (table) table << header() << '\n';
    }
    for (const Row& row : measure(sim, thread_counts(most), gather, o)) {
      print_columns(line(row, census));
      if (table) table << line(row, census) << '\n';
    }
  }
}

struct Holder {
  std::unique_ptr<solver::Simulation> sim;
};

}  // namespace

int bench_command(const LoadedCase& c, const BenchOptions& o) {
  cases::Model model = cases::build_model(c.value);
  load_support_motions(model, c.value.folder);
  const cases::GroundMotion motion = c.value.motion ? load_motion(*c.value.motion, c.value.folder) : cases::GroundMotion{};
  const auto build = [&](bool gather) {
    solver::Options options;
    options.gather = gather;
    return std::make_unique<Holder>(Holder{std::make_unique<solver::Simulation>(c.value, model, motion, options)});
  };
  bench(build, model, o);
  return kDone;
}

int bench_checkpoint(const std::string& path, const BenchOptions& o) {
  const auto build = [&](bool gather) {
    Checkpoint checkpoint = read_checkpoint(path);
    cases::Case value = read_case({path, checkpoint.facts.case_toml, "."}).value;
    solver::Options options;
    options.gather = gather;
    return restore_run(path, std::move(checkpoint), std::move(value), options);
  };
  const cases::Model model = cases::build_model(read_case({path, read_checkpoint(path).facts.case_toml, "."}).value);
  bench(build, model, o);
  return kDone;
}

}  // namespace voussoir::io
