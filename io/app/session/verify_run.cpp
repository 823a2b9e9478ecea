// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/verify_run.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <set>

#include "cases/case.h"
#include "cases/model.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/prepared_case.h"
#include "io/app/session/progress.h"
#include "io/app/session/session.h"
#include "io/input/files/scratch_folder.h"
#include "io/input/messages/messages.h"
#include "io/input/motion/motion_files.h"
#include "solver/analysis/drive.h"
#include "solver/world/errors.h"

namespace voussoir::io {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSeconds = 12.0;           // wall-clock time of each of the three runs, before anything breaks
constexpr std::int64_t kTrial = 20;         // timed steps
constexpr std::int64_t kMostTried = 20000;  // steps
constexpr std::int64_t kLedgerSteps = 10;

/// Data common to all runs of a verification.
struct Setting {
  const cases::Case& value;
  const cases::Model& model;
  const cases::GroundMotion& motion;
  solver::Options options;
  std::int64_t steps = 0;
};

void advance(solver::Simulation& sim, solver::RunState& plan, const Setting& s, std::int64_t until) {
  for (; plan.steps < until; ++plan.steps) {
    if (!plan.shaking && (sim.phase() == solver::Phase::shaking || plan.steps >= s.steps / 2)) {
      sim.start_shaking();
      plan.shaking = true;
    }
    const bool due = plan.steps % kLedgerSteps == 0;
    sim.step({due, due});
    sim.cracks().clear();
  }
}

/// The state after all steps; with stops, after each of which a new simulation continues from a checkpoint.
solver::SavedState outcome(const Setting& s, int threads, const std::set<std::int64_t>& stops) {
  solver::Options options = s.options;
  options.threads = threads;
  const auto build = [&] { return std::make_unique<solver::Simulation>(s.value, s.model, s.motion, options); };
  std::unique_ptr<solver::Simulation> sim = build();
  choose_drive(*sim, s.value);
  solver::RunState plan;
  const ScratchFolder scratch;
  const std::string checkpoint = scratch.path() + "/checkpoint.h5";
  for (const std::int64_t stop : stops) {
    advance(*sim, plan, s, stop);
    write_checkpoint(checkpoint, facts_of(*sim, "", s.motion, s.options.reference_kernels), solver::fields(*sim, plan));
    sim = build();
    plan = {};
    solver::restore(*sim, plan, read_checkpoint(checkpoint).state);
  }
  advance(*sim, plan, s, s.steps);
  return solver::save(*sim, plan);
}

/// An even number of steps with which one run takes about kSeconds.
std::int64_t choose_steps(const Setting& s) {
  solver::Options options = s.options;
  options.threads = 1;
  solver::Simulation sim(s.value, s.model, s.motion, options);
  const auto start = Clock::now();
  for (std::int64_t i = 0; i < kTrial; ++i) sim.step({});
  const double each = std::chrono::duration<double>(Clock::now() - start).count() / static_cast<double>(kTrial);
  return 2 * (std::clamp(static_cast<std::int64_t>(kSeconds / (each + 1e-9)), 10 * kTrial, kMostTried) / 2);
}

/// Prints and returns whether two states are equal.
bool same(const char* what, const solver::SavedState& a, const solver::SavedState& b) {
  const auto differs = [&](const auto& entry) {
    const auto other = b.find(entry.first);
    return other == b.end() || other->second.bytes != entry.second.bytes;
  };
  const auto it = std::ranges::find_if(a, differs);
  std::printf("%-42s %s%s\n", what, it == a.end() ? "the same bits" : "DIFFERENT: first in ", it == a.end() ? "" : it->first.c_str());
  std::fflush(stdout);
  return it == a.end();
}

int compare_runs(const Setting& s, int threads) {
  std::printf("%s steps, half of them settling; the whole state is compared\n", format_count(s.steps).c_str());
  const solver::SavedState one = outcome(s, 1, {});
  const std::int64_t first = s.steps / 3, second = 3 * s.steps / 4;
  char text[80];
  std::snprintf(text, sizeof text, "1 thread and %d threads", threads);
  bool good = same(text, one, outcome(s, threads, {}));
  std::snprintf(text, sizeof text, "stopped after %s and %s steps", format_count(first).c_str(), format_count(second).c_str());
  good = same(text, one, outcome(s, threads, {first, second})) && good;
  return good ? kDone : kNumericalFailure;
}

}  // namespace

int verify(const LoadedCase& c, bool reference_kernels, int threads) {
  const cases::Model model = prepared_model(c.value, threads);
  const cases::GroundMotion motion = ground_motion(c.value);
  Setting s{c.value, model, motion, {}, 0};
  s.options.reference_kernels = reference_kernels;
  try {
    s.steps = choose_steps(s);
    return compare_runs(s, std::max(2, threads));  // at least two, even where one is the default
  } catch (const solver::NumericalError& e) {
    say_error(kNumericalFailure, {.text = std::string("numerical failure: ") + e.what()});
    return kNumericalFailure;
  }
}

}  // namespace voussoir::io
