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
#include "io/bench_timing.h"
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

std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int n = 1; n < most; n *= 2) counts.push_back(n);
  counts.push_back(most);
  return counts;
}

using Cells = std::vector<std::string>;

Cells header() {
  Cells names{"scatter", "threads", "ms_per_step", "steps_per_s", "speedup"};
  for (const char* name : {"samples", "quiet", "quiet_ms_per_step", "quiet_steps_per_s", "quiet_speedup"}) names.emplace_back(name);
  for (const char* name : {"handover_ns", "ns_per_joint", "ns_per_segment_side"}) names.emplace_back(name);
  for (const char* name : solver::kStageNames) names.push_back(std::string("ms_") + name);
  return names;
}

/// Under that header; what has not been measured is empty.
Cells cells_of(bool gather, const Timing& t, const cases::Census& n) {
  const double joints = static_cast<double>(n.joints + n.base_joints), segments = static_cast<double>(n.joint_sides);
  Cells cells{gather ? "gather" : "colour", std::to_string(t.threads)};
  const auto put = [&](const char* format, double value) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    cells.emplace_back(text);
  };
  put("%.4f", 1e3 * t.step), put("%.0f", 1.0 / t.step), put("%.2f", t.speedup);
  put("%.0f", t.samples), put("%.0f", t.quiet);
  if (t.quiet > 0) {
    put("%.4f", 1e3 * t.quiet_step), put("%.0f", 1.0 / t.quiet_step);
  } else {
    cells.insert(cells.end(), 2, "");
  }
  if (t.quiet_speedup > 0.0) {
    put("%.2f", t.quiet_speedup);
  } else {
    cells.emplace_back();
  }
  put("%.0f", 1e9 * t.handover), put("%.1f", 1e9 * t.step / joints), put("%.2f", 1e9 * t.step / segments);
  for (const double s : t.stages) put("%.4f", 1e3 * s);
  return cells;
}

std::string csv(const Cells& cells) {
  std::string line = cells.front();
  for (std::size_t k = 1; k < cells.size(); ++k) line += "," + cells[k];
  return line + "\n";
}

void print_columns(const Cells& cells) {
  const Cells names = header();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::printf("%*s ", static_cast<int>(std::max<std::size_t>(8, names[k].size())), cells[k].empty() ? "-" : cells[k].c_str());
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
  TimingOptions timing;
  if (o.batches > 0) timing.least = timing.most = o.batches;
  timing.steps = o.steps;
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
      if (table) table << csv(header());
    }
    for (const Timing& t : time_steps(sim, thread_counts(most), timing)) {
      const Cells cells = cells_of(gather, t, census);
      print_columns(cells);
      if (table) table << csv(cells);
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
