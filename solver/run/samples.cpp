// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "solver/run/simulation.h"

/// What a sample takes from a step: base forces, motions of the elements that are followed.
namespace voussoir::solver {

namespace {

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
}

void Simulation::note_velocities() {
  const Elements& e = world_->elements;
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    const auto i = static_cast<std::size_t>(followed_[k]);
    velocity_before_[k] = {e.vx[i], e.vy[i], e.vz[i]};
  }
}

}  // namespace voussoir::solver
