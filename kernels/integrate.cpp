// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/integrate.h"

#include <bit>

#include "kernels/lanes.h"
#include "kernels/prefetch.h"
#include "kernels/rows.h"

namespace voussoir::kernels {

namespace {

/// Distance in elements of the prefetches in out-of-cache models. The columns are more than the hardware prefetcher follows. A few lines
/// are prefetched at a time, between the arithmetic, since all at once would wait for each other. Prefetches past the last element have no
/// effect.
constexpr std::int64_t kPrefetchDistance = 2 * kBatch;

template <class... Columns>
VOUSSOIR_INLINE void prefetch_columns(const ElementRows& rows, std::int64_t i, Columns... columns) noexcept {
  if (rows.out_of_cache) (prefetch(columns + i + kPrefetchDistance, kWidth * sizeof(double)), ...);
}

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
/// Dᵀ v.
VOUSSOIR_INLINE VecLanes transposed_times(const MatLanes& d, VecLanes v) noexcept {
  return {d.r0.x * v.x + d.r1.x * v.y + d.r2.x * v.z, d.r0.y * v.x + d.r1.y * v.y + d.r2.y * v.z,
          d.r0.z * v.x + d.r1.z * v.y + d.r2.z * v.z};
}

struct PrincipalLanes {
  VecLanes d;
};
VOUSSOIR_INLINE VecLanes operator*(const PrincipalLanes& m, VecLanes v) noexcept { return {m.d.x * v.x, m.d.y * v.y, m.d.z * v.z}; }

VOUSSOIR_INLINE MatLanes full_inverse_inertia(const ElementsView& e, std::int64_t i) noexcept {
  const Lanes xy = load_lanes(e.ixy + i), xz = load_lanes(e.ixz + i), yz = load_lanes(e.iyz + i);
  return {{load_lanes(e.ixx + i), xy, xz}, {xy, load_lanes(e.iyy + i), yz}, {xz, yz, load_lanes(e.izz + i)}};
}

/// Inverse inertia of elements; bricks have principal body axes, and half as many numbers to read.
template <bool kPrincipal>
VOUSSOIR_INLINE auto inverse_inertia(const ElementsView& e, std::int64_t i) noexcept {
  if constexpr (kPrincipal) {
    return PrincipalLanes{load3(e.ixx, e.iyy, e.izz, i)};
  } else {
    return full_inverse_inertia(e, i);
  }
}

/// m rotated by the rotation vector −h, as a series up to h⁵, without trigonometric functions of a library, whose bits depend on the
/// processor.
VOUSSOIR_INLINE VecLanes turned_back(VecLanes m, VecLanes h) noexcept {
  const Lanes h2 = dot(h, h);
  const VecLanes hm = cross(h, m), hhm = cross(h, hm);
  return m - (1.0 - h2 * (1.0 / 6.0 - h2 * (1.0 / 120.0))) * hm + (0.5 - h2 * (1.0 / 24.0)) * hhm;
}

VOUSSOIR_INLINE QuaternionLanes product(QuaternionLanes a, QuaternionLanes b) noexcept {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// q rotated by the rotation vector 2h in body axes: series of cos and sin up to h⁵ (error of the norm: h⁶).
VOUSSOIR_INLINE QuaternionLanes turned(QuaternionLanes q, VecLanes h) noexcept {
  const Lanes h2 = dot(h, h);
  const Lanes c = 1.0 - h2 * (0.5 - h2 * (1.0 / 24.0));
  const Lanes s = 1.0 - h2 * (1.0 / 6.0 - h2 * (1.0 / 120.0));
  return product(q, {c, s * h.x, s * h.y, s * h.z});
}

/// Normalises by one step of the series, which is exact: the length is 1 up to round-off and the h⁶ of `turned`.
VOUSSOIR_INLINE QuaternionLanes normalised(QuaternionLanes p) noexcept {
  const Lanes f = 1.5 - 0.5 * (p.w * p.w + p.x * p.x + p.y * p.y + p.z * p.z);
  return {f * p.w, f * p.x, f * p.y, f * p.z};
}

VOUSSOIR_INLINE QuaternionLanes orientation(const ElementsView& e, std::int64_t i) noexcept {
  return {load_lanes(e.qw + i), load_lanes(e.qx + i), load_lanes(e.qy + i), load_lanes(e.qz + i)};
}

VOUSSOIR_INLINE void write_rows(const ElementRows& rows, std::int64_t i, VecLanes u, const MatLanes& d, VecLanes v, VecLanes w) noexcept {
  const auto pose_row = [&](int l) { return rows.pose + (i + l) * kPoseStride; };
  if (rows.out_of_cache) {
    static_assert(kPoseStride % 4 == 0);  // otherwise thirds of rows would not be aligned for store_streaming
    Quad x[kWidth], y[kWidth], z[kWidth];
    to_rows(d.r0.x, d.r0.y, d.r0.z, u.x, x);
    to_rows(d.r1.x, d.r1.y, d.r1.z, u.y, y);
    to_rows(d.r2.x, d.r2.y, d.r2.z, u.z, z);
    for (int l = 0; l < kWidth; ++l) {  // row by row, so that whole lines are written at once
      store_streaming(pose_row(l), x[l]);
      store_streaming(pose_row(l) + 4, y[l]);
      store_streaming(pose_row(l) + 8, z[l]);
    }
  } else {
    store_columns(pose_row, 0, d.r0.x, d.r0.y, d.r0.z, u.x);
    store_columns(pose_row, 4, d.r1.x, d.r1.y, d.r1.z, u.y);
    store_columns(pose_row, 8, d.r2.x, d.r2.y, d.r2.z, u.z);
  }
  if (rows.active != nullptr && rows.active[i / kBatch] == 0) return;
  const SixColumns velocities = rows_of({v.x, v.y, v.z, w.x, w.y, w.z});
  for (int l = 0; l < kWidth; ++l) store_row(rows.twist + (i + l) * kTwistStride, velocities, l);
}

/// Clears the rows of kWidth elements, each of kWrenchStride or kDashpotStride numbers.
VOUSSOIR_INLINE void clear_rows(double* rows, std::int64_t i) noexcept {
  static_assert(kDashpotStride == kWrenchStride);
  for (int k = 0; k < kWrenchStride; ++k) store_lanes(rows + i * kWrenchStride + k * kWidth, Lanes{});
}

/// Whether dashpots act on any of kWidth elements: rare where little has come loose.
VOUSSOIR_INLINE bool any_dashed(const ElementRows& rows, std::int64_t i) noexcept {
  std::uint64_t any = 0;
  for (int l = 0; l < kWidth; ++l) any |= std::bit_cast<std::uint64_t>(rows.wrench[(i + l) * kWrenchStride + kDashedColumn]);
  return any != 0;
}

VOUSSOIR_INLINE double* tally_of(const ElementsView& e, std::int64_t i, Tally column) noexcept {
  return e.tally + i / kBatch * kTallies + static_cast<int>(column);
}

/// Adds the work of the dashpots' torques to the energy tally, with the mean of the angular velocities before and after; clears their rows.
VOUSSOIR_INLINE void finish_dashpots(const ElementsView& e, std::int64_t i, VecLanes after, const ElementRows& rows, double dt) noexcept {
  const VecLanes before = load3(e.wx, e.wy, e.wz, i);
  VecLanes torque;
  Lanes x, y, z, unused;
  const auto row = [&](int l) { return rows.dashpot + (i + l) * kDashpotStride; };
  load_columns(row, 0, x, y, z, torque.x);
  load_columns(row, 4, torque.y, torque.z, unused, unused);
  const Quad taken = sums_of(dot(torque, before + after), Lanes{}, Lanes{}, Lanes{});
  *tally_of(e, i, Tally::loss_dashpots) -= 0.5 * dt * taken[0];
  clear_rows(rows.dashpot, i);
}

/// Angular velocity Ω at the next half step, in body axes, from the angular momentum there. The orientation there is the current one
/// rotated by φ = ½ Δt Ω, so Ω = J⁻¹ exp(−φ) Rᵀ L. The last ω gives a first φ, correct to first order a second φ, and the latter gives Ω;
/// as φ is not quite parallel to Ω, Ω is rotated with the element. \param m  Rᵀ L \param last  Rᵀ ω, of the last half step
template <class Inertia>
VOUSSOIR_INLINE VecLanes spin_at_half_step(const Inertia& inverse, VecLanes m, VecLanes last, Lanes half) noexcept {
  const VecLanes guess = half * last;
  const VecLanes phi = half * (inverse * (m - cross(guess, m)));
  const VecLanes spin = inverse * turned_back(m, phi);
  return spin + cross(phi, spin);
}

/// Moves kWidth elements to the orientation `next`, with angular velocity w: positions, rows.
VOUSSOIR_INLINE void move_on(const ElementsView& e, std::int64_t i, QuaternionLanes next, VecLanes w, const ElementRows& rows,
                             double dt) noexcept {
  const VecLanes v = load3(e.vx, e.vy, e.vz, i);
  const VecLanes u = load3(e.ux, e.uy, e.uz, i) + lanes(dt) * v;
  store3(e.ux, e.uy, e.uz, i, u);
  store_lanes(e.qw + i, next.w);
  store3(e.qx, e.qy, e.qz, i, {next.x, next.y, next.z});
  store3(e.wx, e.wy, e.wz, i, w);
  write_rows(rows, i, u, rotation_minus_identity(next), v, w);
  clear_rows(rows.wrench, i);
}

/// The drift of kGroups times kWidth elements, interleaved: the dependency chain from ω to the next orientation is long, and a single group
/// would leave the processor waiting.
template <int kGroups, bool kPrincipal>
VOUSSOIR_INLINE void drift_groups(const ElementsView& e, const ElementRows& rows, double dt, std::int64_t i) noexcept {
  const Lanes half = lanes(0.5 * dt);
  QuaternionLanes q[kGroups];
  MatLanes d[kGroups];
  VecLanes m[kGroups], spin[kGroups];
  for (int g = 0; g < kGroups; ++g) {
    const std::int64_t k = i + g * kWidth;
    const VecLanes l = load3(e.lx, e.ly, e.lz, k), w = load3(e.wx, e.wy, e.wz, k);
    q[g] = orientation(e, k);
    d[g] = rotation_minus_identity(q[g]);
    m[g] = l + transposed_times(d[g], l);
    spin[g] = w + transposed_times(d[g], w);
  }
  for (int g = 0; g < kGroups; ++g) prefetch_columns(rows, i + g * kWidth, e.qw, e.qx, e.qy, e.qz, e.wx, e.wy, e.wz);
  for (int g = 0; g < kGroups; ++g) spin[g] = spin_at_half_step(inverse_inertia<kPrincipal>(e, i + g * kWidth), m[g], spin[g], half);
  for (int g = 0; g < kGroups; ++g) q[g] = normalised(turned(q[g], half * spin[g]));
  for (int g = 0; g < kGroups; ++g) prefetch_columns(rows, i + g * kWidth, e.ixx, e.iyy, e.izz, e.ux, e.uy, e.uz);
  for (int g = 0; g < kGroups; ++g) spin[g] = spin[g] + d[g] * spin[g];
  for (int g = 0; g < kGroups; ++g) {
    if (any_dashed(rows, i + g * kWidth)) finish_dashpots(e, i + g * kWidth, spin[g], rows, dt);
  }
  for (int g = 0; g < kGroups; ++g) move_on(e, i + g * kWidth, q[g], spin[g], rows, dt);
}

/// Energies of one or several elements in a step [J].
struct StepTally {
  Lanes ground{}, gravity{}, damping{}, dashpots{};
};

/// BodyForces in lanes.
struct Pushes {
  Lanes dt;
  VecLanes body, mean_gravity, mean_ground, damped_ground;
  bool damps_rotation;
  double round_off;
};

/// Components that are smaller than `least` become zero.
VOUSSOIR_INLINE VecLanes above(VecLanes v, Lanes least) noexcept {
  return {select(max(v.x, -v.x) < least, Lanes{}, v.x), select(max(v.y, -v.y) < least, Lanes{}, v.y),
          select(max(v.z, -v.z) < least, Lanes{}, v.z)};
}

/// Sets components of force and torque to zero that may be round-off of the contact forces (22a). \param least  N, of a force that counts
VOUSSOIR_INLINE void drop_round_off(const ElementsView& e, std::int64_t i, Lanes least, Lanes inv_mass, VecLanes& force,
                                    VecLanes& torque) noexcept {
  const Lanes inv_inertia = load_lanes(e.ixx + i) + load_lanes(e.iyy + i) + load_lanes(e.izz + i);
  const Lanes arm = sqrt(select(inv_inertia > 0.0, inv_mass / inv_inertia, Lanes{}));  // at most the least radius of gyration
  force = above(force, least);
  torque = above(torque, arm * least);
}

/// The kick of kWidth elements.
VOUSSOIR_INLINE void kick_group(const ElementsView& e, const ElementRows& rows, const Pushes& f, std::int64_t i,
                                StepTally& tally) noexcept {
  if (rows.out_of_cache) prefetch(rows.wrench + (i + kPrefetchDistance) * kWrenchStride, kWidth * kWrenchStride * sizeof(double));
  prefetch_columns(rows, i, e.vx, e.vy, e.vz, e.lx, e.ly, e.lz, e.mass, e.inv_mass, e.alpha);
  const auto row = [&](int l) { return rows.wrench + (i + l) * kWrenchStride; };
  VecLanes force, torque;
  Lanes unused, pushed, dashed;
  load_columns(row, 0, force.x, force.y, force.z, torque.x);
  load_columns(row, 4, torque.y, torque.z, pushed, dashed);
  const Lanes m = load_lanes(e.mass + i), im = load_lanes(e.inv_mass + i), alpha = load_lanes(e.alpha + i);
  const Lanes inert = load_lanes(e.inert_mass + i);
  const LaneMask fixed = im == 0.0;
  if (bits(pushed != 0.0) != 0) drop_round_off(e, i, f.round_off * pushed, im, force, torque);
  const Lanes a = 0.5 * alpha * f.dt;
  const VecLanes before = load3(e.vx, e.vy, e.vz, i);
  const VecLanes after =
      select3(fixed, before, (1.0 / (1.0 + a)) * ((1.0 - a) * before + f.dt * (im * force + f.body - alpha * f.damped_ground)));
  const VecLanes mean = lanes(0.5) * (before + after);
  store3(e.vx, e.vy, e.vz, i, after);
  const VecLanes l = load3(e.lx, e.ly, e.lz, i);
  const Lanes turn = select(fixed, Lanes{}, f.dt);
  VecLanes turned_on = l + turn * torque;
  Lanes lost = lanes(0.0);
  if (f.damps_rotation) {
    turned_on = (1.0 / (1.0 + a)) * (turned_on - a * l);
    lost = lanes(0.5) * dot(l + turned_on, load3(e.wx, e.wy, e.wz, i));
  }
  store3(e.lx, e.ly, e.lz, i, turned_on);
  tally.gravity = tally.gravity + m * dot(f.mean_gravity, before);
  tally.ground = tally.ground - m * dot(f.mean_ground, before);
  tally.damping = tally.damping + alpha * (inert * dot(mean, mean + f.damped_ground) + lost);
  if (bits(dashed != 0.0) != 0) {
    VecLanes dash;
    load_columns([&](int r) { return rows.dashpot + (i + r) * kDashpotStride; }, 0, dash.x, dash.y, dash.z, unused);
    tally.dashpots = tally.dashpots - dot(dash, mean);
  }
}

}  // namespace

void kick(const ElementsView& e, const ElementRows& rows, const BodyForces& f, std::int64_t first, std::int64_t last) noexcept {
  const Pushes pushes{
      lanes(f.dt), spread(f.gravity - f.ground), spread(f.mean_gravity), spread(f.mean_ground), spread(f.damped_ground), f.damps_rotation,
      f.round_off};
  for (std::int64_t i = first; i < last; i += kBatch) {
    StepTally tally;
    for (int k = 0; k < kBatch; k += kWidth) kick_group(e, rows, pushes, i + k, tally);
    const Quad sums = sums_of(tally.ground, tally.gravity, tally.damping, tally.dashpots);
    add_quad(tally_of(e, i, Tally::work_ground), f.dt * sums);
  }
}

void drift(const ElementsView& e, const ElementRows& rows, double dt, std::int64_t first, std::int64_t last) noexcept {
  constexpr int kGroups = 2;
  for (std::int64_t i = first; i < last; i += kGroups * kWidth) {
    const bool principal = e.principal[i / kBatch] != 0;
    principal ? drift_groups<kGroups, true>(e, rows, dt, i) : drift_groups<kGroups, false>(e, rows, dt, i);
  }
}

}  // namespace voussoir::kernels
