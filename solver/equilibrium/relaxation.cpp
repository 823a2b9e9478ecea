// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/equilibrium/relaxation.h"

#include <algorithm>
#include <cmath>

#include "geometry/nth.h"
#include "solver/equilibrium/masses.h"

namespace voussoir::solver {

namespace {

constexpr double kOnTheWay = 0.1;      // of the critical damping
constexpr double kMostDamping = 1.8;   // α Δt
constexpr double kMostSquare = 1e200;  // rad²/s², of the frequency: at full rest the energy under it underflows, and state is finite
constexpr std::int64_t kElementsAtATime = 256;  // that a thread takes

Vec3 at(const Array<double>& x, const Array<double>& y, const Array<double>& z, std::size_t i) { return {x[i], y[i], z[i]}; }

/// N, mean over the elements that move: weights, dead loads, and those that grow where there is nothing else.
double mean_weight(const cases::Case& c, const World& w) {
  const double g = norm(c.gravity.acceleration);
  double dead = 0.0, growing = 0.0, count = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(w.elements.count); ++i) {
    if (w.elements.fixed[i]) continue;
    dead += g * w.elements.mass[i], count += 1.0;
  }
  for (const PointLoad& l : w.loads) (l.grows ? growing : dead) += norm(l.force);
  const double all = dead > 0.0 ? dead : growing;
  if (count > 0.0 && !(all > 0.0))
    throw cases::InputError("analysis.solver",
                            "= \"equilibrium\" needs gravity or a load with a force, to which unbalanced forces compare");
  return all / std::max(count, 1.0);
}

}  // namespace

cases::Case without_rates(const cases::Case& c) {
  cases::Case r = c;
  r.contact.damping = 0.0;
  r.contact.restitution.reset();
  r.damping = {};
  return r;
}

Relaxation::Relaxation(const cases::Case& c, World& w) : on_(true), typical_(mean_weight(c, w)) {
  find_inert_masses(w);
  patches_ = w.patches.patch.size();
  by_batch_.resize(static_cast<std::size_t>(w.elements.rows / kernels::kBatch));
}

/// Of one element; adds its weight. Velocities are those beside the predicted ones.
Relaxation::Sums Relaxation::look_at(World& w, std::size_t i, Vec3 acceleration, const Lead& lead) const {
  Elements& e = w.elements;
  double* r = e.wrench.data() + i * kernels::kWrenchStride;
  const double m = e.mass[i];
  r[0] += m * acceleration.x, r[1] += m * acceleration.y, r[2] += m * acceleration.z;
  const double mass = e.inert.inv_mass[i], turn = e.inert.inv_inertia[i];
  const Vec3 f{r[0], r[1], r[2]}, t{r[3], r[4], r[5]};
  Vec3 v = at(e.vx, e.vy, e.vz, i), spin = at(e.wx, e.wy, e.wz, i), l = at(e.lx, e.ly, e.lz, i);
  const double turning = 0.5 * dot(l, spin);
  if (lead.before() != 0.0) {
    const double rate = lead.before() / w.dt;
    const Vec3 turned = rate * lead.rotation(i);
    v = v - rate * lead.displacement(i), spin = spin - turned;
    if (turn > 0.0) l = l - (1.0 / turn) * turned;
  }
  const double moment = turn > 0.0 ? norm(t) / e.radius[i] : 0.0;
  return {dot(f, v) + dot(t, spin), mass * dot(f, f) + turn * dot(t, t), dot(v, v) / mass + dot(l, spin), turning,
          std::max(norm(f), moment)};
}

/// Sums over all elements, those of batches one after another: no bit depends on the threads.
Relaxation::Sums Relaxation::all_of(World& w, Vec3 acceleration, const Lead& lead) {
  w.team.share_out(w.elements.rows, kElementsAtATime, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t batch = first / kernels::kBatch; batch < last / kernels::kBatch; ++batch) {
      Sums sum;
      for (std::int64_t k = batch * kernels::kBatch; k < (batch + 1) * kernels::kBatch; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (w.elements.inert.inv_mass[i] == 0.0) continue;
        const Sums own = look_at(w, i, acceleration, lead);
        sum.power += own.power, sum.square += own.square, sum.kinetic += own.kinetic, sum.turning += own.turning;
        sum.most = std::max(sum.most, own.most);
      }
      nth(by_batch_, batch) = sum;
    }
  });
  Sums all;
  for (const Sums& s : by_batch_)
    all.power += s.power, all.square += s.square, all.kinetic += s.kinetic, all.turning += s.turning, all.most = std::max(all.most, s.most);
  return all;
}

namespace {

/// Inertia and damping of the predicted motion, as forces; what they work is given back of what damping takes.
void add_lead(World& w, const Lead& lead, double alpha, std::size_t i) {
  Elements& e = w.elements;
  const double mass = e.inert.inv_mass[i], turn = e.inert.inv_inertia[i], a = 0.5 * alpha * w.dt;
  if (mass == 0.0) return;
  double* r = e.wrench.data() + i * kernels::kWrenchStride;
  const double rate = 0.5 * alpha * (lead.before() + lead.ahead()) / w.dt + (lead.ahead() - lead.before()) / (w.dt * w.dt);
  const Vec3 f = (rate / mass) * lead.displacement(i), t = turn > 0.0 ? (rate / turn) * lead.rotation(i) : Vec3{};
  r[0] += f.x, r[1] += f.y, r[2] += f.z, r[3] += t.x, r[4] += t.y, r[5] += t.z;
  const Vec3 v = at(e.vx, e.vy, e.vz, i), l = at(e.lx, e.ly, e.lz, i);
  const Vec3 after = (1.0 / (1.0 + a)) * ((1.0 - a) * v + (w.dt * mass) * Vec3{r[0], r[1], r[2]});
  const Vec3 turned = (1.0 / (1.0 + a)) * ((1.0 - a) * l + w.dt * Vec3{r[3], r[4], r[5]});
  const double work = 0.5 * w.dt * (dot(f, v + after) + turn * dot(t, l + turned));
  e.tally[i / kernels::kBatch * kernels::kTallies + static_cast<std::size_t>(kernels::Tally::loss_damping)] -= work;
}

}  // namespace

void Relaxation::restore(World& w) {
  if (!on_ || patches_ == w.patches.patch.size()) return;
  find_inert_masses(w);
  patches_ = w.patches.patch.size();
}

/// Finds masses anew where a joint has come apart. Velocities stay, so the energy of motion changes: relaxation gives or takes it.
void Relaxation::renew_masses(World& w) {
  Elements& e = w.elements;
  const Array<double> mass = e.inert.mass, inv_inertia = e.inert.inv_inertia;
  find_inert_masses(w);
  patches_ = w.patches.patch.size();
  double given = 0.0, turning = 0.0;  // J
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const Vec3 v = at(e.vx, e.vy, e.vz, i), spin = at(e.wx, e.wy, e.wz, i), l = at(e.lx, e.ly, e.lz, i);
    given += 0.5 * (e.inert.mass[i] - mass[i]) * dot(v, v);
    if (!(e.inert.inv_inertia[i] > 0.0)) continue;
    const double ratio = inv_inertia[i] / e.inert.inv_inertia[i];
    turning += 0.5 * (ratio - 1.0) * dot(l, spin);
    e.lx[i] *= ratio, e.ly[i] *= ratio, e.lz[i] *= ratio;
  }
  state_.turning += turning;
  e.tally[static_cast<std::size_t>(kernels::Tally::loss_damping)] -= given + turning;
}

void Relaxation::look(World& w, Vec3 acceleration, bool on_the_way, const Lead& lead) {
  if (patches_ != w.patches.patch.size()) renew_masses(w);
  const Sums s = all_of(w, acceleration, lead);
  state_.unbalanced = s.most / typical_;
  // The last kick has booked the loss by damping of rotations with their angular velocities before it, not the mean: THEORY.md (27).
  w.elements.tally[static_cast<std::size_t>(kernels::Tally::loss_damping)] += 0.5 * state_.alpha * w.dt * (s.turning - state_.turning);
  if (s.kinetic > 0.0) state_.frequency = std::sqrt(std::min(kMostSquare, std::max(0.0, (state_.power - s.power) / (w.dt * s.kinetic))));
  // Critical for it, but where damping would bear a part of the load.
  const double share = on_the_way && !lead.leads() ? kOnTheWay : 1.0;
  const double alpha = share * std::min(2.0 * state_.frequency, kMostDamping / w.dt);
  const double a = 0.5 * alpha * w.dt;
  state_.power = ((1.0 - a) * s.power + w.dt * s.square) / (1.0 + a);
  state_.alpha = alpha, state_.turning = s.turning;
  std::fill(w.elements.alpha.begin(), w.elements.alpha.end(), alpha);
  if (!lead.leads()) return;
  w.team.share_out(w.elements.rows, kElementsAtATime, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < std::min<std::int64_t>(last, w.elements.count); ++i)
      add_lead(w, lead, alpha, static_cast<std::size_t>(i));
  });
}

}  // namespace voussoir::solver
