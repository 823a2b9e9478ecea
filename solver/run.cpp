// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/errors.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kTickInterval = 20;  // steps

std::int64_t in_steps(double interval, double dt) { return std::max<std::int64_t>(1, std::llround(interval / dt)); }

/// Keeps the buffers and the running figures of one run.
class Reporter {
 public:
  Reporter(Simulation& sim, Recorder& out) : sim_(sim), out_(out) {}

  void frame() {
    const World& w = sim_.world();
    const Elements& e = w.elements;
    const auto n = static_cast<std::size_t>(e.count);
    position_.resize(3 * n), quaternion_.resize(4 * n), broken_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto put = [i](std::vector<float>& to, std::initializer_list<double> v) {
        std::size_t k = v.size() * i;
        for (const double x : v) to[k++] = static_cast<float>(x);
      };
      put(position_, {e.ref_x[i] + e.ux[i], e.ref_y[i] + e.uy[i], e.ref_z[i] + e.uz[i]});
      put(quaternion_, {e.qw[i], e.qx[i], e.qy[i], e.qz[i]});
      broken_[i] = e.bonds_at_start[i] > 0 ? 1.0F - static_cast<float>(e.bonds[i]) / static_cast<float>(e.bonds_at_start[i]) : 0.0F;
    }
    out_.frame({sim_.time(), position_, quaternion_, broken_});
  }

  void samples(double time) {
    out_.history(time, sim_.history());
    const ForcesRow& f = sim_.forces();
    peak_base_shear = std::max(peak_base_shear, std::hypot(f.base_shear.x, f.base_shear.y));
  }

  void ledger(double time) {
    out_.energy(sim_.energy());
    const Damage& d = sim_.damage();
    out_.damage({time, d.bonded, d.slipped, d.tension, d.shear, d.compression});
    cracks();
  }

  void cracks() {
    std::vector<CrackRow>& rows = sim_.cracks();
    if (rows.empty()) return;
    for (const CrackRow& r : rows) {
      if (first_crack < 0.0 && r.time >= 0.0) first_crack = r.time;
    }
    out_.cracks(rows);
    rows.clear();
  }

  double first_crack = -1.0, peak_base_shear = 0.0;

 private:
  Simulation& sim_;
  Recorder& out_;
  std::vector<float> position_, quaternion_, broken_;
};

std::int64_t broken(const Damage& d) { return d.tension + d.shear + d.compression; }

void check_residual(const Simulation& sim) {
  const EnergyRow& e = sim.energy();
  if (e.residual <= kResidualLimit) return;
  char text[200];
  std::snprintf(text, sizeof text, "the energy ledger is off by %.3g of the energy in play at t = %.4f s (allowed: %g); try --dt %.3g",
                e.residual, sim.time(), kResidualLimit, 0.5 * sim.dt());
  throw NumericalError(text);
}

/// Settles until rest. Returns whether rest was reached; `stopped` is set if the tick asked to stop.
bool settle(Simulation& sim, double end, std::int64_t every, Reporter& report, const Tick& tick, std::int64_t& total, bool& stopped) {
  while (!sim.at_rest()) {
    if (sim.settled_too_long()) return false;
    const double time = sim.time();
    const bool ledger = sim.steps() % every == 0;
    sim.step({false, ledger});
    ++total;
    if (ledger) report.ledger(time);
    if (total % kTickInterval == 0 && !tick({sim.time(), end, true, total, broken(sim.damage()), sim.energy().residual})) {
      stopped = true;
      return true;
    }
  }
  return true;
}

}  // namespace

Summary summarise(const Simulation& sim, double first_crack, double peak_base_shear, bool settled) {
  const World& w = sim.world();
  const Elements& e = w.elements;
  double all = 0.0, fallen = 0.0, roof = 0.0, fallen_roof = 0.0;
  const double base = e.ref_z[static_cast<std::size_t>(e.base)];
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const cases::PartKind kind = w.model.blocks[i].kind;
    const bool is_roof = kind == cases::PartKind::beam || kind == cases::PartKind::voussoir;
    const bool has_fallen = -e.uz[i] > std::min(0.5 * (e.ref_z[i] - base), 1.0);
    all += e.mass[i];
    roof += is_roof ? e.mass[i] : 0.0;
    fallen += has_fallen ? e.mass[i] : 0.0;
    fallen_roof += has_fallen && is_roof ? e.mass[i] : 0.0;
  }
  Summary s;
  s.fallen_mass_fraction = all > 0.0 ? fallen / all : 0.0;
  s.collapsed = roof > 0.0 ? fallen_roof > 0.5 * roof : fallen > 0.5 * all;
  s.first_crack_time = first_crack;
  const Damage& d = sim.damage();
  s.tension = d.tension, s.shear = d.shear, s.compression = d.compression, s.slipped = d.slipped;
  s.peak_base_shear = peak_base_shear;
  s.peak_speed = sim.peak_speed();
  s.worst_residual = sim.worst_residual();
  s.settled = settled;
  s.end_time = sim.time();
  return s;
}

RunResult run(Simulation& sim, const cases::Case& c, double end, Recorder& out, const Tick& tick) {
  Reporter report(sim, out);
  const double dt = sim.dt();
  const std::int64_t history = in_steps(c.output.history_interval, dt), frame = in_steps(c.output.frame_interval, dt),
                     ledger = in_steps(c.output.ledger_interval, dt), last = std::llround(end / dt);
  std::int64_t total = 0;
  bool settled = true, stopped = false;
  try {
    if (sim.phase() == Phase::settling) settled = settle(sim, end, ledger, report, tick, total, stopped);
    if (!stopped) sim.start_shaking();
    while (!stopped && sim.steps() <= last) {
      const std::int64_t n = sim.steps();
      const double time = sim.time();
      const Due due{n % history == 0, n % ledger == 0 || n == last};
      if (n % frame == 0) {
        const StageTimer timer(sim.stage_times(), Stage::output);
        report.frame();
      }
      sim.step(due);
      const StageTimer timer(sim.stage_times(), Stage::output);
      if (due.sample) report.samples(time);
      if (due.ledger) {
        if (due.sample) out.forces(sim.forces());
        report.ledger(time);
        check_residual(sim);
      }
      ++total;
      if (total % kTickInterval == 0) stopped = !tick({time, end, false, total, broken(sim.damage()), sim.energy().residual});
    }
  } catch (...) {
    report.cracks();
    out.summary(summarise(sim, report.first_crack, report.peak_base_shear, settled));
    throw;
  }
  report.cracks();
  const RunResult result{stopped, summarise(sim, report.first_crack, report.peak_base_shear, settled)};
  out.summary(result.summary);
  return result;
}

}  // namespace voussoir::solver
