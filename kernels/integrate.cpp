// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/integrate.h"

#include "kernels/lanes.h"
#include "kernels/rows.h"

namespace voussoir::kernels {

namespace {

struct QuaternionLanes {
  Lanes w, x, y, z;
};

VOUSSOIR_INLINE VecLanes load3(const double* x, const double* y, const double* z, std::int64_t i) noexcept {
  return {load_lanes(x + i), load_lanes(y + i), load_lanes(z + i)};
}
VOUSSOIR_INLINE void store3(double* x, double* y, double* z, std::int64_t i, VecLanes v) noexcept {
  store_lanes(x + i, v.x);
  store_lanes(y + i, v.y);
  store_lanes(z + i, v.z);
}

/// R(q) − I, as in rotation_minus_identity.
VOUSSOIR_INLINE MatLanes rotation_minus_identity(QuaternionLanes q) noexcept {
  const Lanes xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Lanes xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const Lanes wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{-2.0 * (yy + zz), 2.0 * (xy - wz), 2.0 * (xz + wy)},
          {2.0 * (xy + wz), -2.0 * (xx + zz), 2.0 * (yz - wx)},
          {2.0 * (xz - wy), 2.0 * (yz + wx), -2.0 * (xx + yy)}};
}
VOUSSOIR_INLINE MatLanes transposed(const MatLanes& m) noexcept {
  return {{m.r0.x, m.r1.x, m.r2.x}, {m.r0.y, m.r1.y, m.r2.y}, {m.r0.z, m.r1.z, m.r2.z}};
}

VOUSSOIR_INLINE MatLanes inverse_inertia(const ElementsView& e, std::int64_t i) noexcept {
  const Lanes xy = load_lanes(e.ixy + i), xz = load_lanes(e.ixz + i), yz = load_lanes(e.iyz + i);
  return {{load_lanes(e.ixx + i), xy, xz}, {xy, load_lanes(e.iyy + i), yz}, {xz, yz, load_lanes(e.izz + i)}};
}

/// ω = R J⁻¹ Rᵀ L.
VOUSSOIR_INLINE VecLanes spin(const MatLanes& inverse, QuaternionLanes q, VecLanes l) noexcept {
  const MatLanes d = rotation_minus_identity(q);
  const VecLanes body = inverse * (l + transposed(d) * l);
  return body + d * body;
}

VOUSSOIR_INLINE QuaternionLanes product(QuaternionLanes a, QuaternionLanes b) noexcept {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// q turned by the rotation vector 2h in space. Series of cos and sin to h⁵ (a norm off by h⁶): no library trigonometry,
/// whose bits depend on the processor.
VOUSSOIR_INLINE QuaternionLanes turned(QuaternionLanes q, VecLanes h) noexcept {
  const Lanes h2 = dot(h, h);
  const Lanes c = 1.0 - h2 * (0.5 - h2 * (1.0 / 24.0));
  const Lanes s = 1.0 - h2 * (1.0 / 6.0 - h2 * (1.0 / 120.0));
  return product({c, s * h.x, s * h.y, s * h.z}, q);
}

/// One step of the series is exact: the length is 1 but for round-off and the h⁶ of `turned`.
VOUSSOIR_INLINE QuaternionLanes normalised(QuaternionLanes p) noexcept {
  const Lanes f = 1.5 - 0.5 * (p.w * p.w + p.x * p.x + p.y * p.y + p.z * p.z);
  return {f * p.w, f * p.x, f * p.y, f * p.z};
}

VOUSSOIR_INLINE QuaternionLanes orientation(const ElementsView& e, std::int64_t i) noexcept {
  return {load_lanes(e.qw + i), load_lanes(e.qx + i), load_lanes(e.qy + i), load_lanes(e.qz + i)};
}

VOUSSOIR_INLINE void write_rows(double* pose, double* twist, std::int64_t i, VecLanes u, const MatLanes& d, VecLanes v,
                                VecLanes w) noexcept {
  const auto pose_row = [=](int l) { return pose + (i + l) * kPoseStride; };
  store_columns(pose_row, 0, d.r0.x, d.r0.y, d.r0.z, u.x);
  store_columns(pose_row, 4, d.r1.x, d.r1.y, d.r1.z, u.y);
  store_columns(pose_row, 8, d.r2.x, d.r2.y, d.r2.z, u.z);
  const auto twist_row = [=](int l) { return twist + (i + l) * kTwistStride; };
  store_columns(twist_row, 0, v.x, v.y, v.z, w.x);
  store_columns(twist_row, 4, w.y, w.z, Lanes{}, Lanes{});
}

/// One step of kWidth elements with the angular velocity w: positions, orientations, rows.
VOUSSOIR_INLINE void move_on(const ElementsView& e, std::int64_t i, VecLanes w, double* wrench, double* pose, double* twist,
                             double dt) noexcept {
  const Lanes half = lanes(0.5 * dt);
  const VecLanes v = load3(e.vx, e.vy, e.vz, i), old = load3(e.wx, e.wy, e.wz, i);
  const VecLanes u = load3(e.ux, e.uy, e.uz, i) + lanes(dt) * v;
  store3(e.ux, e.uy, e.uz, i, u);
  const QuaternionLanes next = normalised(turned(orientation(e, i), half * w));
  store_lanes(e.qw + i, next.w);
  store3(e.qx, e.qy, e.qz, i, {next.x, next.y, next.z});
  store3(e.wx, e.wy, e.wz, i, w);
  Lanes unused;
  VecLanes dash;
  load_columns([=](int r) { return wrench + (i + r) * kWrenchStride; }, 8, unused, dash.x, dash.y, dash.z);
  store_lanes(e.loss_dashpot + i, load_lanes(e.loss_dashpot + i) - half * dot(dash, old + w));
  write_rows(pose, twist, i, u, rotation_minus_identity(next), v, w);
  for (int k = 0; k < kWrenchStride; ++k) store_lanes(wrench + i * kWrenchStride + k * kWidth, Lanes{});
}

}  // namespace

void kick(const ElementsView& e, const double* wrench, const BodyForces& f, std::int64_t first, std::int64_t last) noexcept {
  const VecLanes body = spread(f.gravity - f.ground), mean_gravity = spread(f.mean_gravity), mean_ground = spread(f.mean_ground);
  const Lanes dt = lanes(f.dt);
  for (std::int64_t i = first; i < last; i += kWidth) {
    const auto row = [=](int l) { return wrench + (i + l) * kWrenchStride; };
    VecLanes force, torque, dash;
    Lanes unused;
    load_columns(row, 0, force.x, force.y, force.z, torque.x);
    load_columns(row, 4, torque.y, torque.z, dash.x, dash.y);
    load_columns(row, 8, dash.z, unused, unused, unused);
    const Lanes m = load_lanes(e.mass + i), im = load_lanes(e.inv_mass + i), alpha = load_lanes(e.alpha + i);
    const LaneMask fixed = im == 0.0;
    const Lanes a = 0.5 * alpha * dt;
    const VecLanes before = load3(e.vx, e.vy, e.vz, i);
    VecLanes after = (1.0 / (1.0 + a)) * ((1.0 - a) * before + dt * (im * force + body));
    after = {select(fixed, before.x, after.x), select(fixed, before.y, after.y), select(fixed, before.z, after.z)};
    const VecLanes mean = lanes(0.5) * (before + after);
    store3(e.vx, e.vy, e.vz, i, after);
    const VecLanes l = load3(e.lx, e.ly, e.lz, i);
    const Lanes turn = select(fixed, Lanes{}, dt);
    VecLanes turned_on = l + turn * torque;
    Lanes lost = lanes(0.0);
    if (f.damps_rotation) {
      turned_on = (1.0 / (1.0 + a)) * (turned_on - a * l);
      lost = lanes(0.5) * dot(l + turned_on, load3(e.wx, e.wy, e.wz, i));
    }
    store3(e.lx, e.ly, e.lz, i, turned_on);
    store_lanes(e.work_gravity + i, load_lanes(e.work_gravity + i) + dt * m * dot(mean_gravity, before));
    store_lanes(e.work_ground + i, load_lanes(e.work_ground + i) - dt * m * dot(mean_ground, before));
    store_lanes(e.loss_damping + i, load_lanes(e.loss_damping + i) + dt * alpha * (m * dot(mean, mean) + lost));
    store_lanes(e.loss_dashpot + i, load_lanes(e.loss_dashpot + i) - dt * dot(dash, mean));
  }
}

void drift(const ElementsView& e, double* wrench, double* pose, double* twist, double dt, std::int64_t first, std::int64_t last) noexcept {
  const Lanes quarter = lanes(0.25 * dt);
  constexpr int kGroups =
      kLanes / kWidth;  // side by side: the chain from ω to the next ω is long, and one alone leaves the machine waiting
  for (std::int64_t i = first; i < last; i += kLanes) {
    VecLanes w[kGroups];
    // The last ω is as good a start as L at the last orientation, and free.
    for (int g = 0; g < kGroups; ++g) w[g] = load3(e.wx, e.wy, e.wz, i + g * kWidth);
    for (int pass = 0; pass < 2; ++pass) {
      for (int g = 0; g < kGroups; ++g) {
        const std::int64_t k = i + g * kWidth;
        w[g] = spin(inverse_inertia(e, k), turned(orientation(e, k), quarter * w[g]), load3(e.lx, e.ly, e.lz, k));
      }
    }
    for (int g = 0; g < kGroups; ++g) move_on(e, i + g * kWidth, w[g], wrench, pose, twist, dt);
  }
}

}  // namespace voussoir::kernels
