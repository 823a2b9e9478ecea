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

/// Three columns of the rows of kWidth elements.
VOUSSOIR_INLINE VecLanes columns(const double* rows, int stride, int column, std::int64_t i) noexcept {
  VecLanes v;
  for (int l = 0; l < kWidth; ++l) {
    const double* r = rows + (i + l) * stride + column;
    v.x[l] = r[0], v.y[l] = r[1], v.z[l] = r[2];
  }
  return v;
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

VOUSSOIR_INLINE QuaternionLanes normalised(QuaternionLanes p) noexcept {
  const Lanes f = 1.0 / sqrt(p.w * p.w + p.x * p.x + p.y * p.y + p.z * p.z);
  return {f * p.w, f * p.x, f * p.y, f * p.z};
}

VOUSSOIR_INLINE VecLanes spread(Vec3 v) noexcept { return {lanes(v.x), lanes(v.y), lanes(v.z)}; }

VOUSSOIR_INLINE void write_rows(double* pose, double* twist, std::int64_t i, VecLanes u, const MatLanes& d, VecLanes v,
                                VecLanes w) noexcept {
  for (int l = 0; l < kWidth; ++l) {
    double* p = pose + (i + l) * kPoseStride;
    p[0] = u.x[l], p[1] = u.y[l], p[2] = u.z[l];
    p[3] = d.r0.x[l], p[4] = d.r0.y[l], p[5] = d.r0.z[l];
    p[6] = d.r1.x[l], p[7] = d.r1.y[l], p[8] = d.r1.z[l];
    p[9] = d.r2.x[l], p[10] = d.r2.y[l], p[11] = d.r2.z[l];
    double* t = twist + (i + l) * kTwistStride;
    t[0] = v.x[l], t[1] = v.y[l], t[2] = v.z[l], t[3] = w.x[l], t[4] = w.y[l], t[5] = w.z[l];
  }
}

}  // namespace

void kick(const ElementsView& e, const double* wrench, const BodyForces& f, std::int64_t first, std::int64_t last) noexcept {
  const VecLanes body = spread(f.gravity - f.ground), mean_gravity = spread(f.mean_gravity), mean_ground = spread(f.mean_ground);
  const Lanes dt = lanes(f.dt);
  for (std::int64_t i = first; i < last; i += kWidth) {
    const VecLanes force = columns(wrench, kWrenchStride, 0, i), torque = columns(wrench, kWrenchStride, 3, i);
    const VecLanes dash = columns(wrench, kWrenchStride, 6, i);
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
    store3(e.lx, e.ly, e.lz, i, l + turn * torque);
    store_lanes(e.work_gravity + i, load_lanes(e.work_gravity + i) + dt * m * dot(mean_gravity, before));
    store_lanes(e.work_ground + i, load_lanes(e.work_ground + i) - dt * m * dot(mean_ground, before));
    store_lanes(e.loss_damping + i, load_lanes(e.loss_damping + i) + dt * alpha * m * dot(mean, mean));
    store_lanes(e.loss_dashpot + i, load_lanes(e.loss_dashpot + i) - dt * dot(dash, mean));
  }
}

void drift(const ElementsView& e, double* wrench, double* pose, double* twist, double dt, std::int64_t first, std::int64_t last) noexcept {
  const Lanes step = lanes(dt), half = lanes(0.5 * dt), quarter = lanes(0.25 * dt);
  for (std::int64_t i = first; i < last; i += kWidth) {
    const VecLanes v = load3(e.vx, e.vy, e.vz, i);
    const VecLanes u = load3(e.ux, e.uy, e.uz, i) + step * v;
    store3(e.ux, e.uy, e.uz, i, u);
    const MatLanes inverse = inverse_inertia(e, i);
    const QuaternionLanes q{load_lanes(e.qw + i), load_lanes(e.qx + i), load_lanes(e.qy + i), load_lanes(e.qz + i)};
    const VecLanes l = load3(e.lx, e.ly, e.lz, i), old = load3(e.wx, e.wy, e.wz, i);
    VecLanes w = spin(inverse, q, l);
    for (int pass = 0; pass < 2; ++pass) w = spin(inverse, turned(q, quarter * w), l);
    const QuaternionLanes next = normalised(turned(q, half * w));
    store_lanes(e.qw + i, next.w);
    store3(e.qx, e.qy, e.qz, i, {next.x, next.y, next.z});
    store3(e.wx, e.wy, e.wz, i, w);
    const VecLanes dash = columns(wrench, kWrenchStride, 9, i);
    store_lanes(e.loss_dashpot + i, load_lanes(e.loss_dashpot + i) - half * dot(dash, old + w));
    write_rows(pose, twist, i, u, rotation_minus_identity(next), v, w);
    __builtin_memset(wrench + i * kWrenchStride, 0, sizeof(double) * kWrenchStride * kWidth);
  }
}

}  // namespace voussoir::kernels
