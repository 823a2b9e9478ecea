// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "cases/model.h"
#include "solver/run/loads.h"
#include "solver/run/over_elements.h"
#include "solver/run/simulation.h"
#include "solver/world/errors.h"

/// What a sample takes from a step: base forces, motions of the elements that are followed, the largest speed.
namespace voussoir::solver {

namespace {

constexpr double kFastest = 200.0;    // m/s; a house that falls from 20 m reaches 20
constexpr double kLargestTurn = 0.5;  // rad in a step of its own: what turns faster has no true orientation, THEORY (24)

Vec3 rotation_vector(Quaternion q, Quaternion start) {
  // q · start⁻¹
  const double w = q.w * start.w + q.x * start.x + q.y * start.y + q.z * start.z;
  Vec3 v{q.x * start.w - q.w * start.x - q.y * start.z + q.z * start.y, q.y * start.w - q.w * start.y - q.z * start.x + q.x * start.z,
         q.z * start.w - q.w * start.z - q.x * start.y + q.y * start.x};
  const double s = norm(v);
  if (s < 1e-12) return 2.0 * v;
  return (2.0 * std::atan2(s, w) / s) * v;
}

}  // namespace

// Forces of pairs of higher levels, which are not among those of the other pairs yet, count as the others do: not with their impulse.
// Internal forces cancel in pairs, so what is left of the sum over all free elements is what base and fixed blocks exert.
void Simulation::measure_base_forces() {
  const World& w = *world_;
  forces_ = {time(), {}, {}};
  for (std::int32_t e = 0; e < w.elements.count; ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (w.elements.fixed[i]) continue;
    const Vec3 x = w.elements.body[i].ref + Vec3{w.elements.ux[i], w.elements.uy[i], w.elements.uz[i]};
    const auto add = [&](const Array<double>& rows) {
      const double* r = rows.data() + i * kernels::kWrenchStride;
      const Vec3 f{r[0], r[1], r[2]};
      forces_.base_shear += f;
      forces_.base_moment += cross(x, f) + Vec3{r[3], r[4], r[5]};
    };
    add(w.elements.wrench);
    for (const Multirate::Rows& r : w.multirate.rows) add(r.wrench);
  }
}

void Simulation::take_samples() {
  const Elements& e = world_->elements;
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    const auto i = static_cast<std::size_t>(followed_[k]);
    const Vec3 u{e.ux[i], e.uy[i], e.uz[i]}, v{e.vx[i], e.vy[i], e.vz[i]};
    samples_[k] = {u - start_[k], 0.5 * (velocity_before_[k] + v), rotation_vector({e.qw[i], e.qx[i], e.qy[i], e.qz[i]}, turned_[k])};
  }
  load_samples_ = solver::load_samples(*world_, load_start_, phase_ == Phase::shaking ? static_cast<double>(step_) * world_->dt : 0.0,
                                       program_.factor());
}

void Simulation::note_velocities() {
  const Elements& e = world_->elements;
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    const auto i = static_cast<std::size_t>(followed_[k]);
    velocity_before_[k] = {e.vx[i], e.vy[i], e.vz[i]};
  }
}

double Simulation::fastest_square() {
  const Elements& e = world_->elements;
  const auto squares = [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    return std::pair{e.vx[k] * e.vx[k] + e.vy[k] * e.vy[k] + e.vz[k] * e.vz[k], e.wx[k] * e.wx[k] + e.wy[k] * e.wy[k] + e.wz[k] * e.wz[k]};
  };
  const auto step = [&](std::int64_t i) { return world_->step_of_element(static_cast<std::size_t>(i)); };
  const auto sound = [&](std::int64_t i) {
    const auto [v2, w2] = squares(i);
    return v2 < kFastest * kFastest && w2 * step(i) * step(i) < kLargestTurn * kLargestTurn;
  };
  // By the threads that have the rows: one alone would fetch all of them, and the others fetch theirs back.
  const double most = over_elements(*world_, update_shares_, most_, [&](std::int64_t first, std::int64_t last) {
    double v2 = 0.0;
    for (std::int64_t i = first; i < last; ++i) v2 = std::max(v2, sound(i) ? squares(i).first : std::numeric_limits<double>::infinity());
    return v2;
  });
  if (most < kFastest * kFastest) return most;
  give_up();
  return 0.0;
}

void Simulation::give_up() {
  const Elements& e = world_->elements;
  for (std::int32_t i = 0; i < e.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double speed = std::hypot(e.vx[k], e.vy[k], e.vz[k]), spin = std::hypot(e.wx[k], e.wy[k], e.wz[k]);
    const double step = world_->step_of_element(k);
    if (speed < kFastest && spin * step < kLargestTurn) continue;
    const std::string element = cases::describe(world_->model.blocks[k], k);
    if (relaxation_.on() && std::isfinite(speed) && std::isfinite(spin)) {
      if (phase_ == Phase::shaking) return path_.lose();
      throw NumericalError(element +
                           " finds no rest while gravity is put on, so there is no capacity: it falls under the dead loads, or "
                           "the relaxation has failed; a run without [analysis] shows which");
    }
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%s moves at %.3g m/s and turns at %.3g rad/s at t = %.6f s (allowed: under %g m/s and %.3g rad/s): the step of %.3g s is "
        "probably too large; try --dt %.3g, or leave it to the program (time.step = \"auto\")",
        element.c_str(), speed, spin, time(), kFastest, kLargestTurn / step, step, 0.5 * world_->dt);
    throw NumericalError(text);
  }
}

std::string Simulation::fastest_element() const {
  const Elements& e = world_->elements;
  std::size_t fastest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    const double v2 = e.vx[i] * e.vx[i] + e.vy[i] * e.vy[i] + e.vz[i] * e.vz[i];
    if (v2 <= most) continue;
    fastest = i, most = v2;
    if (std::isnan(v2)) break;
  }
  return cases::describe(world_->model.blocks[fastest], fastest);
}

}  // namespace voussoir::solver
