// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "cases/ties/ties.h"
#include "solver/run/run.h"

/// What a run tells its Recorder.
namespace voussoir::solver {

/// The largest figures of the bars from `first` to before `last`.
inline TieGroupSample sample_of(const Ties& ties, std::size_t first, std::size_t last) noexcept {
  const auto larger = [](double kept, double value) { return std::abs(value) > std::abs(kept) ? value : kept; };
  TieGroupSample sample;
  bool elastic = true;
  for (std::size_t i = first; i < last; ++i) {
    const kernels::TieState& s = ties.state[i];
    const double yield = ties.tie[i].law.yield;
    sample.force = larger(sample.force, s.force), sample.elongation = larger(sample.elongation, s.elongation);
    if (std::isfinite(yield)) elastic = false, sample.utilisation = std::max(sample.utilisation, std::abs(s.force) / yield);
    sample.broken += s.broken;
    sample.yielded += s.broken == 0 && s.plastic != 0.0 ? 1 : 0;
  }
  if (elastic) sample.utilisation = std::numeric_limits<double>::quiet_NaN();
  return sample;
}

/// Keeps the buffers and the running figures of one run.
class Reporter {
 public:
  Reporter(Simulation& sim, RunState& state, Recorder& out)
      : sim_(sim), state_(state), out_(out), groups_(cases::tie_groups(sim.world().model)) {}

  void frame() { take_frame(), tell_frame(); }
  /// Copies poses, to be told of later if they turn out to be a state of rest.
  void take_frame() {
    frame_time_ = sim_.time();
    const World& w = sim_.world();
    const Elements& e = w.elements;
    const auto n = static_cast<std::size_t>(e.count);
    displacement_.resize(3 * n), quaternion_.resize(4 * n), broken_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto put = [i](std::vector<float>& to, std::initializer_list<double> v) {
        std::size_t k = v.size() * i;
        for (const double x : v) to[k++] = static_cast<float>(x);
      };
      put(displacement_, {e.ux[i], e.uy[i], e.uz[i]});
      put(quaternion_, {e.qw[i], e.qx[i], e.qy[i], e.qz[i]});
      broken_[i] = e.bonds_at_start[i] > 0 ? 1.0F - static_cast<float>(e.bonds[i]) / static_cast<float>(e.bonds_at_start[i]) : 0.0F;
    }
  }
  void tell_frame() { out_.frame({frame_time_, displacement_, quaternion_, broken_}); }

  void samples(double time) {
    ties(time);
    tie_groups(time);
    if (!sim_.loads().empty()) out_.loads(time, sim_.loads());
    out_.history(time, sim_.history());
    const ForcesRow& f = sim_.forces();
    state_.peak_base_shear = std::max(state_.peak_base_shear, std::hypot(f.base_shear.x, f.base_shear.y));
  }

  void ledger(double time) {
    out_.energy(sim_.energy());
    const Damage& d = sim_.damage();
    out_.damage({time, d.bonded, d.slipped, d.tension, d.shear, d.compression, first_limits(sim_.world())});
    cracks();
  }

  void cracks() {
    if (sim_.cracks().empty()) return;
    cracks_.clear();
    cracks_.swap(sim_.cracks());  // taken out first, so that a recorder that throws is not told them twice
    for (const CrackRow& r : cracks_) {
      if (state_.first_crack < 0.0 && r.time >= 0.0) state_.first_crack = r.time;
      if (state_.settling_crack == 0.0 && r.time < 0.0) state_.settling_crack = r.time;
    }
    out_.cracks(cracks_);
  }

 private:
  void ties(double time) {
    const std::size_t own = cases::own_ties(sim_.world().model);
    if (own == 0) return;
    ties_.clear();
    for (const kernels::TieState& s : std::span(sim_.world().ties.state).first(own))
      ties_.push_back({s.force, s.elongation, s.plastic, s.broken != 0});
    out_.ties(time, ties_);
  }

  void tie_groups(double time) {
    if (groups_.empty()) return;
    group_samples_.clear();
    const Ties& ties = sim_.world().ties;
    for (const cases::TieGroup& g : groups_) group_samples_.push_back(sample_of(ties, g.first, g.last));
    out_.tie_groups(time, group_samples_);
  }

  Simulation& sim_;
  RunState& state_;
  Recorder& out_;
  std::vector<cases::TieGroup> groups_;
  std::vector<TieSample> ties_;
  std::vector<TieGroupSample> group_samples_;
  std::vector<CrackRow> cracks_;
  double frame_time_ = 0.0;  // s
  std::vector<float> displacement_, quaternion_, broken_;
};

}  // namespace voussoir::solver
