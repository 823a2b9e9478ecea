// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/session/session.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>
#include <utility>

#include "cases/case.h"
#include "cases/model.h"
#include "io/app/session/exit_code.h"
#include "io/app/session/process.h"
#include "io/app/session/progress.h"
#include "io/app/session/stop_words.h"
#include "io/app/session/views.h"
#include "io/app/session/words/advice.h"
#include "io/app/session/words/headway.h"
#include "io/app/session/words/tie_lines.h"
#include "io/input/files/errors.h"
#include "io/input/messages/messages.h"
#include "io/output/measures/capacity/capacity_file.h"
#include "io/output/measures/capacity/light_elements.h"
#include "io/output/measures/members/member_words.h"
#include "io/output/measures/settling_warning.h"
#include "solver/world/errors.h"

namespace voussoir::io {

namespace {

volatile std::sig_atomic_t stop_signal = 0;
volatile std::sig_atomic_t save_signal = 0;

/// Handles signals as requests to save, or to save and stop, during its lifetime.
class Signals {
 public:
  Signals() {
    stop_signal = 0;
    save_signal = 0;
    for (const int s : {SIGINT, SIGTERM}) std::signal(s, [](int n) { stop_signal = n; });
    std::signal(SIGUSR1, [](int n) { save_signal = n; });
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
  ~Signals() {
    for (const int s : {SIGINT, SIGTERM, SIGUSR1}) std::signal(s, SIG_DFL);
  }
};

/// \param moves  false: an analysis by states of rest, whose speeds are those of the search
void print_summary(const solver::Summary& s, std::uint64_t hash, const std::string& folder, bool stopped, bool moves) {
  std::printf("collapsed            %s\n", s.collapsed ? "yes" : stopped ? "not so far" : "no");
  std::printf("fallen mass          %.1f %%\n", 100.0 * s.fallen_mass_fraction);
  std::printf("first crack          ");
  if (s.settling.first_crack_time < 0.0) std::printf("while settling; afterwards ");
  s.first_crack_time >= 0.0 ? std::printf("%.3f s\n", s.first_crack_time) : std::printf(stopped ? "none so far\n" : "none\n");
  const auto by_mode = [](const char* what, std::int64_t tension, std::int64_t shear, std::int64_t compression) {
    std::printf("%-20s %s points in tension, %s in shear, %s in compression", what, format_count(tension).c_str(),
                format_count(shear).c_str(), format_count(compression).c_str());
  };
  by_mode("joints failed first", s.first.tension, s.first.shear, s.first.compression);
  std::printf("\n");
  by_mode("joints opened", s.tension, s.shear, s.compression);
  std::printf("; %s have slipped and hold\n", format_count(s.slipped).c_str());
  by_mode("of them settling", s.settling.tension, s.settling.shear, s.settling.compression);
  std::printf("; %s had slipped and held\n", format_count(s.settling.slipped).c_str());
  std::printf("peak base shear      %.1f kN\n", 1e-3 * s.peak_base_shear);
  if (moves) std::printf("peak speed           %.2f m/s\n", s.peak_speed);
  std::printf("energy error         %.2g at worst, of all energy\n", s.worst_residual);
  std::printf("state hash           %016llx\n", static_cast<unsigned long long>(hash));
  if (!s.settled && s.end_time >= 0.0)
    std::printf("warning              the structure did not come to rest under gravity before it was shaken or loaded\n");
  std::printf("results              %s/run.h5 (to %.3f s)\n", folder.c_str(), s.end_time);
}

/// Prints wall-clock times of the stages that took any.
void print_stages(const solver::StageTimes& times) {
  double total = 0.0;
  for (const double t : times) total += t;
  std::printf("time by stage       ");
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] > 0.001 * total) std::printf(" %s %.1f s (%.1f %%)", solver::kStageNames[k], times[k], 100.0 * times[k] / total);
  }
  std::printf("\n");
}

/// Computes the measures. On failure only warns: results are valid without measures, and `voussoir summary` computes them anew.
void take_measures(ResultsWriter& results) {
  now_doing("taking the measures");
  try {
    results.measure();
  } catch (const FileError& e) {
    say_warning(std::string(e.what()) + "; the summary has no measures of the collapse");
  }
}

/// Writes an output of a failed run; if that fails, warns of the loss. \return whether it was written
template <class Write>
bool try_to(const Write& write, const char* lost) {
  try {
    write();
    return true;
  } catch (const FileError& e) {
    say_warning(std::string(e.what()) + "; " + lost);
    return false;
  }
}

/// Computes the measures of a failed run up to the failure. \pre its rows are written
void measure_failed(ResultsWriter& results) {
  take_measures(results);
  if (!try_to([&] { results.flush(); }, "the measures are not in the results")) return;
  if (results.capacity()) std::printf("%s", capacity_text(*results.capacity()).c_str());
}

/// Observer of one run: progress, signals, checkpoints. Of use until `finish`; then for what it has counted.
class Watch {
 public:
  Watch(solver::Simulation& sim, solver::RunState& plan, ResultsWriter& results, Checkpoints& checkpoints, LivePage page, bool quiet)
      : sim_(sim),
        plan_(plan),
        results_(results),
        checkpoints_(checkpoints),
        page_(std::move(page)),
        progress_(std::cerr, Progress::mode_for(2, quiet)) {}

  /// Called after each step. \return false to stop
  bool look(const solver::RunStatus& s) {
    const double now = wall();
    progress_.update(
        {s.time, s.end, s.settling, s.step, s.broken, s.residual, s.states, s.factor, s.unbalanced, s.states < 0 ? "" : headway(sim_)},
        now);
    if (settling_ && !s.settling) warn_of_settling();
    settling_ = s.settling;
    clock_.note(s.time, s.settling, now, sim_.stage_times());
    const bool stop = stop_signal != 0;
    if (stop || save_signal != 0 || checkpoints_.due(s)) {
      save_signal = 0;
      save(stop || !saved_);
      ++saves_;
      saving_ += wall() - now;
    }
    if (saved_) page_.look(now);
    return !stop;
  }

  /// \param must  failure is an error, not a warning
  void save(bool must) {
    results_.flush();
    try {
      checkpoints_.save(sim_, plan_, results_.rows());
      saved_ = true;
    } catch (const FileError& e) {
      if (must) throw;
      progress_.finish();
      say_warning(std::string(e.what()) + "; the run goes on without this checkpoint");
    }
  }

  void finish() { progress_.finish(); }

  [[nodiscard]] const RunClock& clock() const { return clock_; }

  /// Warns once, when the shaking begins.
  void warn_of_settling() {
    const std::string text = settling_warning(sim_.world(), plan_);
    if (text.empty()) return;
    progress_.finish();
    say_warning(text);
  }

  /// Prints the time spent on checkpoints.
  void print_checkpoints() const {
    std::printf("checkpoints          %d, with the rows before them %.2f s (%.2f %% of %.1f s)\n", saves_, saving_,
                100.0 * saving_ / wall(), wall());
  }

 private:
  /// Wall-clock time since the start [s].
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  solver::Simulation& sim_;
  solver::RunState& plan_;
  ResultsWriter& results_;
  Checkpoints& checkpoints_;
  LivePage page_;
  Progress progress_;
  RunClock clock_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool saved_ = false, settling_ = false;
  int saves_ = 0;        // including failed ones
  double saving_ = 0.0;  // s
};

}  // namespace

CheckpointFacts facts_of(const solver::Simulation& sim, const std::string& toml, const cases::GroundMotion& motion,
                         bool reference_kernels) {
  const Provenance p = provenance(0);
  CheckpointFacts f;
  f.case_toml = toml;
  f.motion = motion;
  f.supports = sim.world().model.support_motions;
  f.origin = sim.world().model.origin;
  f.stones = sim.world().model.stones;
  f.step = sim.dt();
  f.reference_kernels = reference_kernels;
  f.program = p.version + ", " + p.compiler + ", " + p.flags;
  f.model_hash = solver::model_hash(sim.world());
  return f;
}

std::vector<std::string> history_names(const cases::Case& c) {
  std::vector<std::string> names;
  for (const cases::HistoryPoint& h : c.output.history) names.push_back(h.name);
  return names;
}

void print_way_on(const std::string& folder) {
  if (!checkpoint_files(folder).empty()) {
    say_info("the run has stopped; once its files can be written, 'voussoir resume " + folder + "' goes on");
  } else {
    say_info(
        "the run has stopped before its first checkpoint: there is nothing to go on from; once files can be written, run the case "
        "anew ('voussoir run CASE -o " +
        folder + " --overwrite')");
  }
}

std::vector<std::string> cut_names(const cases::Case& c) {
  std::vector<std::string> names;
  for (const cases::Cut& cut : c.output.cuts) names.push_back(cut.name);
  return names;
}

int run_session(const cases::Case& c, std::unique_ptr<solver::Simulation> sim, solver::RunState& plan, ResultsWriter& results,
                Checkpoints& checkpoints, const std::string& folder, bool quiet, double page_every) {
  std::optional<Signals> signals(std::in_place);
  Watch watch(*sim, plan, results, checkpoints, LivePage(folder, page_every), quiet);
  const std::string light = light_elements_warning(sim->world(), c);
  if (!light.empty()) say_warning(light);
  try {
    now_doing("running");
    const solver::RunResult r = solver::run(*sim, plan, c, c.end(), results, [&](const solver::RunStatus& s) { return watch.look(s); });
    watch.finish();
    const std::uint64_t hash = solver::state_hash(sim->world());
    results.state_hash(hash);
    if (r.stopped) {  // measures of a large run take long: results are on disk before, and a further signal ends the program
      results.flush();
      signals.reset();
      std::signal(SIGUSR1, SIG_IGN);  // nothing more to save
    }
    const cases::Model& model = sim->world().model;
    const solver::Ties ties = sim->world().ties;
    const solver::StageTimes times = sim->stage_times();
    const std::string advice = advice_lines(c, *sim, watch.clock(), plan.collapse);
    sim.reset();
    give_memory_back();
    take_measures(results);
    r.stopped ? results.flush() : static_cast<void>(results.finish());
    if (r.stopped) {
      std::fputs(stop_lines(c, r.summary.end_time, static_cast<int>(stop_signal), folder).c_str(), stdout);
      say_json(stop_json(c, r.summary.end_time, static_cast<int>(stop_signal), folder));
    }
    print_summary(r.summary, hash, folder, r.stopped, !(results.capacity() && results.capacity()->by_rest()));
    if (results.capacity()) std::printf("%s", capacity_text(*results.capacity()).c_str());
    if (results.measures()) std::fputs(loads_text(results.measures()->loads).c_str(), stdout);
    print_tie_outcome(ties, model);
    print_stages(times);
    watch.print_checkpoints();
    std::fputs(advice.c_str(), stdout);
    return r.stopped ? 128 + static_cast<int>(stop_signal) : kDone;
  } catch (const solver::NumericalError& e) {
    watch.finish();
    say_error(kNumericalFailure, {.text = std::string("numerical failure: ") + e.what()});
    results.failure(e.what());
    const bool has_rows = try_to([&] { results.flush(); }, "the last rows are not in the results");
    if (try_to([&] { checkpoints.save_failed(*sim, plan, results.rows()); }, "the state is not saved"))
      say_info("the state is in " + folder + "/checkpoint-failed.h5");
    sim.reset();
    give_memory_back();
    if (has_rows) measure_failed(results);
    return kNumericalFailure;
  } catch (const FileError&) {
    watch.finish();
    print_way_on(folder);
    throw;
  }
}

}  // namespace voussoir::io
