// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/model.h"
#include "cases/ties/ties.h"
#include "geometry/nth.h"
#include "solver/run/collapse.h"
#include "solver/run/reporter.h"
#include "solver/world/errors.h"

namespace voussoir::solver {

namespace {

/// Whole steps of dt [s] in an interval [s].
std::int64_t in_steps(double interval, double dt) { return std::max<std::int64_t>(1, std::llround(interval / dt)); }

}  // namespace

std::int64_t in_cycles(double interval, double dt, std::int64_t cycle) { return (in_steps(interval, dt) + cycle - 1) / cycle * cycle; }

namespace {

constexpr std::int64_t kTickInterval = 20;  // steps
constexpr double kLost = 2.0;               // AssessmentRow::over where no further state of rest was found
constexpr double kLookForRest = 0.01;       // s, between two looks at whether gravity has come to rest

std::int64_t steps_between_rows(double interval, const Simulation& sim) { return in_cycles(interval, sim.dt(), sim.cycle()); }

FallenMass fallen_mass(const World& w) {
  const Elements& e = w.elements;
  FallenMass fallen;
  const double base = nth(e.body, e.base).ref.z;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i)
    fallen.add(w.model.blocks[i].kind, e.mass[i], -e.uz[i], e.body[i].ref.z - base);
  return fallen;
}

std::int64_t broken(const Damage& d) { return d.tension + d.shear + d.compression; }

void check_residual(const Simulation& sim) {
  const EnergyRow& e = sim.energy();
  if (e.residual <= kResidualLimit) return;
  char text[400];
  if (sim.relaxation().on()) {
    std::snprintf(text, sizeof text,
                  "the energy ledger is off by %.3g of the energy in play at state of rest %lld (allowed: %g): contacts jumped from iteration "
                  "to iteration on the way to it; the states before it are kept",
                  e.residual, static_cast<long long>(sim.path().points()), kResidualLimit);
    throw NumericalError(text);
  }
  std::snprintf(text, sizeof text,
                "the energy ledger is off by %.3g of the energy in play at t = %.4f s (allowed: %g); fastest is %s; try --dt %.3g",
                e.residual, sim.time(), kResidualLimit, sim.fastest_element().c_str(), 0.5 * sim.dt());
  throw NumericalError(text);
}

/// One run: when to step, when to tell.
class Plan {
 public:
  Plan(Simulation& sim, RunState& state, const cases::Case& c, double end, Recorder& out, const Tick& tick)
      : sim_(sim),
        state_(state),
        out_(out),
        tick_(tick),
        report_(sim, state, out),
        end_(end),
        after_collapse_(cases::is_assessment(c.analysis) ? 0.0 : c.time.after_collapse),
        history_(steps_between_rows(c.output.history_interval, sim)),
        frame_(steps_between_rows(cases::frame_interval(c, sim.world().model.blocks.size()), sim)),
        ledger_(steps_between_rows(c.output.ledger_interval, sim)),
        last_(last_step(sim, end)) {
    end_after_collapse();
    end_with_program();
    if (sim.program().active()) out.drive(sim.program().drive()), out.control(sim.program().control());
  }

  /// \return false if the tick stopped it
  bool settle() {
    // Looked at in intervals of its own: how often rows are written must not decide when the shaking begins.
    const std::int64_t look = in_steps(kLookForRest, sim_.dt());
    const auto at_rest = [&] { return (sim_.steps() - 1) % look == 0 && sim_.at_rest(); };
    while (!at_rest() && !sim_.settled_too_long()) {
      if (!go_on()) return false;
      const double time = sim_.time();
      const bool ledger = sim_.steps() % ledger_ == 0;
      sim_.step({false, ledger || sim_.steps() % look == 0});
      ++state_.steps;
      const StageTimer timer(sim_.stage_times(), Stage::output);
      if (ledger) report_.ledger(time);
    }
    state_.settled = at_rest();
    return true;
  }

  /// \return false if the tick stopped it
  bool shake() {
    while (sim_.steps() <= last_) {
      if (!go_on()) return false;
      const std::int64_t n = sim_.steps();
      const double time = sim_.time();
      const bool history = n % history_ == 0, ledger = n % ledger_ == 0 || n == last_;
      if (n % frame_ == 0 || n == last_) {
        const StageTimer timer(sim_.stage_times(), Stage::output);
        sim_.check_speeds();
        report_.frame();
        if (state_.collapse < 0.0 && fallen_mass(sim_.world()).is_collapse()) state_.collapse = time, end_after_collapse();
      }
      sim_.step({.sample = history || ledger, .ledger = ledger});
      const StageTimer timer(sim_.stage_times(), Stage::output);
      ++state_.steps;
      end_with_program();
      if (history) report_.samples(time);
      if (!ledger) continue;
      if (sim_.program().active()) out_.assessment(sim_.program().row(sim_.world(), time));
      out_.forces(sim_.forces());
      if (!sim_.cuts().empty()) out_.cuts(time, sim_.cuts());
      report_.ledger(time);
      check_residual(sim_);
    }
    sim_.check_speeds();
    return true;
  }

  /// Runs an analysis from one state of rest to the next. \return false if the tick stopped it
  bool follow() {
    while (sim_.steps() <= last_) {
      if (!go_on()) return false;
      const double time = sim_.time();
      const bool row = sim_.path().rests(sim_.relaxation().unbalanced()) || sim_.steps() == last_;
      if (row) sim_.check_speeds(), report_.take_frame();
      sim_.step({.sample = row, .ledger = row});
      ++state_.steps;
      if (row && sim_.path().rests(sim_.relaxation().unbalanced())) tell_rest(time);
      if (row && sim_.path().is_lost()) tell_row(time, kLost);
      if (sim_.path().is_lost()) sim_.program().end_at(sim_.steps());
      end_with_program();
    }
    sim_.check_speeds();
    return true;
  }

  void tell_cracks() { report_.cracks(); }

 private:
  void tell_rest(double time) {
    sim_.accept_rest();
    tell_row(time, sim_.program().ended() > 0 ? 1.0 : 0.0);
    check_residual(sim_);
    if (state_.collapse < 0.0 && fallen_mass(sim_.world()).is_collapse()) state_.collapse = time, end_after_collapse();
  }

  /// Writes the rows of the last step; its frame was taken before the step.
  void tell_row(double time, double over) {
    const StageTimer timer(sim_.stage_times(), Stage::output);
    report_.tell_frame();
    report_.samples(time);
    AssessmentRow r = sim_.program().row(sim_.world(), time);
    r.unbalanced = sim_.relaxation().unbalanced(), r.over = over;
    out_.assessment(r);
    out_.forces(sim_.forces());
    if (!sim_.cuts().empty()) out_.cuts(time, sim_.cuts());
    report_.ledger(time);
  }

  /// The step in which the collapse is seen is never the last: the tick is told of the last one before it.
  void end_after_collapse() {
    if (!after_collapse_ || state_.collapse < 0.0) return;
    end_ = std::min(end_, state_.collapse + *after_collapse_);
    last_ = std::min(last_, std::max(last_step(sim_, end_), last_step(sim_, state_.collapse) + sim_.cycle()));
  }

  /// Nor is the step in which an analysis has found what it looks for.
  void end_with_program() {
    const std::int64_t ended = sim_.program().ended();
    if (ended > 0 && ended + 1 < last_) last_ = std::max(ended + 1, sim_.steps()), end_ = static_cast<double>(last_) * sim_.dt();
  }

  bool go_on() {
    const bool settling = !state_.shaking, last = !settling && sim_.steps() == last_;
    if (state_.steps % kTickInterval != 0 && !last) return true;
    report_.cracks();
    RunStatus s{sim_.time(), end_, settling, state_.steps, broken(sim_.damage()), sim_.energy().residual, last};
    if (sim_.relaxation().on())
      s.states = sim_.path().points(), s.factor = sim_.program().factor(), s.unbalanced = sim_.relaxation().unbalanced();
    return tick_(s);
  }

  Simulation& sim_;
  RunState& state_;
  Recorder& out_;
  const Tick& tick_;
  Reporter report_;
  double end_;                                    // s
  std::optional<double> after_collapse_;          // s
  std::int64_t history_, frame_, ledger_, last_;  // steps
};

}  // namespace

std::int64_t last_step(double end, double dt, std::int64_t cycle) { return std::llround(end / (static_cast<double>(cycle) * dt)) * cycle; }

std::int64_t last_step(const Simulation& sim, double end) { return last_step(end, sim.dt(), sim.cycle()); }

Summary summarise(const Simulation& sim, const RunState& state) {
  const FallenMass fallen = fallen_mass(sim.world());
  Summary s;
  s.fallen_mass_fraction = fallen.fraction();
  s.collapsed = fallen.is_collapse();
  s.first_crack_time = state.first_crack;
  const Damage& d = sim.damage();
  s.tension = d.tension, s.shear = d.shear, s.compression = d.compression, s.slipped = d.slipped;
  s.first = first_limits(sim.world());
  const Damage& before = state.shaking ? state.settling : d;
  s.settling = {before.tension, before.shear, before.compression, before.slipped, state.settling_crack};
  s.peak_base_shear = state.peak_base_shear;
  s.peak_speed = sim.peak_speed();
  s.worst_residual = sim.worst_residual();
  s.settled = state.settled && sim.phase() != Phase::settling;
  s.end_time = sim.time();
  return s;
}

RunResult run(Simulation& sim, RunState& state, const cases::Case& c, double end, Recorder& out, const Tick& tick) {
  Plan plan(sim, state, c, end, out, tick);
  bool stopped = false;
  try {
    if (sim.phase() == Phase::settling) stopped = !plan.settle();
    if (!stopped && !state.shaking) {
      sim.start_shaking();
      plan.tell_cracks();
      state.shaking = true;
      state.settling = sim.damage();
    }
    if (!stopped) stopped = !(sim.relaxation().on() ? plan.follow() : plan.shake());
  } catch (...) {
    try {
      plan.tell_cracks();
    } catch (...) {  // the caller must hear of what stopped the run, not of this
    }
    out.summary(summarise(sim, state));
    throw;
  }
  plan.tell_cracks();
  const RunResult result{stopped, summarise(sim, state)};
  out.summary(result.summary);
  return result;
}

}  // namespace voussoir::solver
