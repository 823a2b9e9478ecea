// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/ledger.h"

#include <algorithm>
#include <cmath>

#include "solver/ties/tie_forces.h"

namespace voussoir::solver {

namespace {

Vec3 at(const Array<double>& x, const Array<double>& y, const Array<double>& z, std::size_t i) { return {x[i], y[i], z[i]}; }
Vec3 at(const std::vector<double>& v, std::size_t i) { return {v[3 * i], v[3 * i + 1], v[3 * i + 2]}; }
void put(std::vector<double>& v, std::size_t i, Vec3 x) { v[3 * i] = x.x, v[3 * i + 1] = x.y, v[3 * i + 2] = x.z; }

template <class Range>
double total(const Range& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

double total(const Patches& patches, double FreePatch::*value) {
  double sum = 0.0;
  for (const FreePatch& p : patches.patch) sum += p.*value;
  return sum;
}

double total(const Ties& ties, double kernels::TieState::*value) {
  double sum = 0.0;
  for (const kernels::TieState& s : ties.state) sum += s.*value;
  return sum;
}

double stored_energy(const Overlaps& o) {
  double sum = 0.0;
  for (const OverlapSpring& s : o.springs) sum += s.stored;
  return sum;
}

double total(const Elements& e, kernels::Tally book) {
  double sum = 0.0;
  for (auto i = static_cast<std::size_t>(book); i < e.tally.size(); i += kernels::kTallies) sum += e.tally[i];
  return sum;
}

}  // namespace

void Ledger::restart(World& w) {
  std::ranges::fill(w.elements.tally, 0.0);
  for (auto* column : {&w.sides.friction, &w.sides.impact, &w.sides.fracture}) column->assign_zeros(column->size());
  for (FreePatch& p : w.patches.patch) p.friction = p.impact = p.fracture = 0.0;
  w.overlaps.friction = w.overlaps.impact = w.overlaps.dashpots = 0.0;
  for (kernels::TieState& s : w.ties.state) s.lost = s.released = 0.0;
  *this = Ledger(w);
}

void Ledger::add_support_work(const World& w) {
  if (w.supports.empty()) return;
  for (std::size_t k = 0; k < w.supports.size(); ++k) {
    const auto e = static_cast<std::size_t>(w.supports[k].element);
    const double* f = w.elements.wrench.data() + e * kernels::kWrenchStride;
    double* old = support_wrench_.data() + 6 * k;
    const Vec3 v = at(w.elements.vx, w.elements.vy, w.elements.vz, e), turn = at(w.elements.wx, w.elements.wy, w.elements.wz, e);
    // The structure pushes the support with f, so the support works with −f.
    if (!fresh_) {
      supports_ -= 0.5 * w.dt * dot(Vec3{f[0] + old[0], f[1] + old[1], f[2] + old[2]}, v);
      if (turn != Vec3{}) supports_ -= 0.5 * w.dt * dot(Vec3{f[3] + old[3], f[4] + old[4], f[5] + old[5]}, turn);
    }
    std::copy_n(f, 6, old);
  }
}

void Ledger::before_kick(World& w) {
  const Elements& e = w.elements;
  const auto n = static_cast<std::size_t>(e.count);
  v_.resize(3 * n), w_.resize(3 * n), l_.resize(3 * n), dash_.resize(6 * n);
  for (std::size_t i = 0; i < n; ++i) {
    put(v_, i, at(e.vx, e.vy, e.vz, i));
    put(w_, i, at(e.wx, e.wy, e.wz, i));
    put(l_, i, at(e.lx, e.ly, e.lz, i));
    std::copy_n(e.dashpot.data() + i * kernels::kDashpotStride, 6, dash_.data() + 6 * i);
  }
  stored_ = joint_energy(w);
  stored_.bonds += stored_energy(w.ties);
  patches_ = total(w.patches, &FreePatch::stored) + stored_energy(w.overlaps);
}

double Ledger::kinetic(const World& w) const {
  const Elements& e = w.elements;
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    // At the first row the old velocities are those of half a step before it, the new ones those of half the element's own step behind it
    // (24a). So the old ones are extrapolated to half the element's own step before the row.
    const int level = w.batch_level(i / kernels::kBatch);
    const double back = fresh_ ? 1.0 / w.multirate.impulse_share(level, 0) - 1.0 : 0.0;
    const Vec3 v = at(e.vx, e.vy, e.vz, i), spin = at(e.wx, e.wy, e.wz, i), l = at(e.lx, e.ly, e.lz, i);
    const Vec3 v0 = at(v_, i), spin0 = at(w_, i), l0 = at(l_, i);
    sum += 0.5 * e.inert_mass()[i] * dot(v0 - back * (v - v0), v) +
           0.25 * (dot(l0 - back * (l - l0), spin) + dot(l, spin0 - back * (spin - spin0)));
  }
  return sum;
}

// The accumulators hold whole steps; a row stands at a whole step, in the middle of one, so half of the last is taken back.
void Ledger::sum_losses(const World& w, const kernels::BodyForces& f, EnergyRow& row) const {
  const Elements& e = w.elements;
  double damping_early = 0.0, dashpot_early = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const Vec3 v = at(e.vx, e.vy, e.vz, i), spin = at(e.wx, e.wy, e.wz, i);
    const double step = w.step_of_element(i);
    damping_early += 0.25 * step * e.alpha[i] * e.inert_mass()[i] * dot(v + at(v_, i) + 2.0 * f.damped_ground, v);
    if (f.damps_rotation)
      damping_early += 0.25 * step * e.alpha[i] * dot(at(l_, i), spin);  // kick has counted with the ω of half a step before
    dashpot_early -= 0.5 * step * (dot(at(dash_, 2 * i), v) + dot(at(dash_, 2 * i + 1), spin));
  }
  row.damping = total(e, kernels::Tally::loss_damping) - damping_early;
  // A spring of whole bodies that ends inside a step may seem to give out a little more than it took, which its own dashpot has taken
  // beside it. What such springs give out beyond the losses of their own dashpots is no loss below zero, but residual.
  const double given = std::max(0.0, -(w.overlaps.impact + w.overlaps.dashpots));
  row.dashpot = total(e, kernels::Tally::loss_dashpots) - dashpot_early + total(w.sides.impact) + total(w.patches, &FreePatch::impact) +
                w.overlaps.impact + given;
  row.friction =
      total(w.sides.friction) + total(w.patches, &FreePatch::friction) + w.overlaps.friction + total(w.ties, &kernels::TieState::lost);
  row.fracture = total(w.sides.fracture) + total(w.patches, &FreePatch::fracture) + total(w.ties, &kernels::TieState::released);
}

EnergyRow Ledger::after_drift(const World& w, const kernels::BodyForces& f, double time, bool counts) {
  EnergyRow row;
  row.time = time;
  row.kinetic = kinetic(w);
  row.strain = stored_.bonds;
  row.contact = stored_.contact + patches_;
  row.gravity = -total(w.elements, kernels::Tally::work_gravity);
  sum_losses(w, f, row);
  const double losses = row.dashpot + row.friction + row.fracture + row.damping;
  const double balance = row.kinetic + row.strain + row.contact + row.gravity + losses;
  const double work = total(w.elements, kernels::Tally::work_ground) + loads_ + supports_;
  if (fresh_) initial_ = balance - work;
  fresh_ = false;
  row.input = initial_ + work;
  scale_ = std::max({scale_, std::abs(row.input), row.strain + row.contact, row.kinetic, -row.gravity});
  row.residual = scale_ > 0.0 ? std::abs(balance - row.input) / scale_ : 0.0;
  if (counts) worst_ = std::max(worst_, row.residual);
  last_ = row;
  return row;
}

}  // namespace voussoir::solver
