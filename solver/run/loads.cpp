// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/loads.h"

#include "cases/model.h"

namespace voussoir::solver {

namespace {

double ramp_share(double t, double begin, double end) {
  if (t >= end) return 1.0;
  return t <= begin ? 0.0 : (t - begin) / (end - begin);
}

struct Wrench {
  Vec3 force, moment;  // N, N m, about the centroid
};

/// A share of a load, where its element is now. \param whole  force of the whole load
Wrench wrench_of(const World& w, const PointLoad& l, Vec3 whole, double share) {
  const Mat3 d = kernels::load_pose(w.elements.pose.data(), l.element).d;
  const Vec3 arm = l.arm + d * l.arm;
  const Vec3 force = share * (l.follows ? whole + d * whole : whole);
  return {force, share * (l.follows ? l.moment + d * l.moment : l.moment) + cross(arm, force)};
}

Wrench wrench_at(const World& w, const PointLoad& l, double t, double factor) {
  const Vec3 whole = l.history != nullptr ? l.part * value_at(*l.history, t) : l.force;
  return wrench_of(w, l, whole, l.grows ? factor : ramp_share(t, l.ramp_begin, l.ramp_end));
}

double power(const World& w, std::int32_t element, Vec3 force, Vec3 moment) {
  const auto i = static_cast<std::size_t>(element);
  const Vec3 v{w.elements.vx[i], w.elements.vy[i], w.elements.vz[i]}, spin{w.elements.wx[i], w.elements.wy[i], w.elements.wz[i]};
  return dot(force, v) + dot(moment, spin);
}

}  // namespace

void apply_loads(World& w, Ledger& ledger, std::vector<Vec3>& before, std::int64_t step, double t, double factor) {
  const Multirate& m = w.multirate;
  const int due = m.due(step);
  for (std::size_t k = 0; k < w.loads.size(); ++k) {
    const PointLoad& l = w.loads[k];
    const Wrench now = wrench_at(w, l, t, factor);
    const int level = w.batch_level(static_cast<std::size_t>(l.element / kernels::kBatch));
    if (level < due) {
      const double share = m.impulse_share(level, step);
      kernels::add_wrench(w.elements.wrench.data(), l.element, share * now.force, share * now.moment);
    }
    if (step > 0) ledger.add_load_work(0.5 * w.dt * power(w, l.element, now.force + before[2 * k], now.moment + before[2 * k + 1]));
    before[2 * k] = now.force;
    before[2 * k + 1] = now.moment;
  }
}

std::vector<Vec3> places_of_loads(const World& w) {
  std::vector<Vec3> places;
  places.reserve(w.loads.size());
  for (const PointLoad& l : w.loads) {
    const auto i = static_cast<std::size_t>(l.element);
    const Mat3 turned = kernels::load_pose(w.elements.pose.data(), l.element).d;
    places.push_back(Vec3{w.elements.ux[i], w.elements.uy[i], w.elements.uz[i]} + turned * l.arm);
  }
  return places;
}

std::vector<LoadSample> load_samples(const World& w, const std::vector<Vec3>& start, double t, double factor) {
  const std::vector<Vec3> places = places_of_loads(w);
  const std::size_t count = w.loads.empty() ? 0 : static_cast<std::size_t>(w.loads.back().load) + 1;
  std::vector<LoadSample> samples(count);
  std::vector<double> weight(count);
  for (std::size_t k = 0; k < w.loads.size(); ++k) {
    const PointLoad& l = w.loads[k];
    const auto of = static_cast<std::size_t>(l.load);
    const Vec3 force = wrench_at(w, l, t, factor).force;
    const double share = l.moves ? norm(force) : l.part;
    samples[of].force += force;
    samples[of].displacement += share * (places[k] - start[k]), weight[of] += share;
  }
  for (std::size_t i = 0; i < count; ++i) samples[i].displacement = (1.0 / weight[i]) * samples[i].displacement;  // NaN: acts nowhere
  return samples;
}

double power_of_growing_loads(const World& w) {
  double sum = 0.0;
  for (const PointLoad& l : w.loads) {
    if (!l.grows) continue;
    const Wrench unit = wrench_of(w, l, l.force, 1.0);
    sum += power(w, l.element, unit.force, unit.moment);
  }
  return sum;
}

}  // namespace voussoir::solver
