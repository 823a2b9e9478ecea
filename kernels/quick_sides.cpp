// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/lanes.h"
#include "kernels/side.h"

// The relative displacement of two rigid faces is affine, u = d + s·a + t·b, so the force of all springs of a side is A·G d and its moment
// needs only the discrete second moments of the points. All limits are convex in (s, t) once split as below, so four corners bound every
// segment.
namespace voussoir::kernels {

namespace {

// Certificates keep this distance from a limit, so that their round-off can only send a side to its segments, never past them.
constexpr double kMargin = 1.0 - 1e-9;

struct BodyLanes {
  VecLanes u;
  MatLanes d;
};

VOUSSOIR_INLINE BodyLanes gather(const double* rows, const std::int32_t* elements) noexcept {
  Lanes r[12] = {};
  for (int l = 0; l < kWidth; ++l) {
    const double* row = rows + static_cast<std::int64_t>(elements[l]) * kPoseStride;
    for (int k = 0; k < 12; ++k) r[k][l] = row[k];
  }
  return {{r[0], r[1], r[2]}, {{r[3], r[4], r[5]}, {r[6], r[7], r[8]}, {r[9], r[10], r[11]}}};
}

VOUSSOIR_INLINE VecLanes load3(const double v[3][kLanes], int at) noexcept {
  return {load_lanes(v[0] + at), load_lanes(v[1] + at), load_lanes(v[2] + at)};
}

/// Relative displacement of the lanes and the frame it acts in.
struct Kinematics {
  VecLanes d, a, b;  // u = d + s a + t b, global axes
  VecLanes n, es, et;
  VecLanes arm_a, arm_b;
};

VOUSSOIR_INLINE Kinematics kinematics(const SideBlock& s, int at, const double* pose) noexcept {
  const BodyLanes p = gather(pose, s.master + at), q = gather(pose, s.slave + at);
  const VecLanes ca = load3(s.ca, at), cb = load3(s.cb, at), es = load3(s.es, at), et = load3(s.et, at);
  const Lanes w = load_lanes(s.mean + at);
  Kinematics k;
  const VecLanes da = p.d * ca, db = q.d * cb;
  k.d = (q.u - p.u) + (db - da);
  const VecLanes as = p.d * es, at_ = p.d * et;
  k.a = q.d * es - as;
  k.b = q.d * et - at_;
  k.es = es + as + w * k.a;
  k.et = et + at_ + w * k.b;
  const VecLanes n0 = cross(es, et), an = p.d * n0, bn = q.d * n0;
  const VecLanes n = n0 + an + w * (bn - an);
  k.n = (1.0 / sqrt(dot(n, n))) * n;
  k.arm_a = ca + da + w * k.d;
  k.arm_b = cb + db - (1.0 - w) * k.d;
  return k;
}

/// Lanes in which every contact point has u_n > 0: no segment that is not bonded touches.
VOUSSOIR_INLINE LaneMask all_open(const SideBlock& s, int at, const Kinematics& k) noexcept {
  const Lanes dn = dot(k.d, k.n), an = dot(k.a, k.n), bn = dot(k.b, k.n);
  const Lanes s0 = load_lanes(s.s_low + at) * an, s1 = load_lanes(s.s_high + at) * an;
  const Lanes t0 = load_lanes(s.t_low + at) * bn, t1 = load_lanes(s.t_high + at) * bn;
  return dn + (min(s0, s1) + min(t0, t1)) > 0.0;
}

/// Lanes whose every segment is certainly inside all limits.
VOUSSOIR_INLINE LaneMask certified(const SideBlock& s, int at, const Kinematics& k, FailureOptions o) noexcept {
  const Lanes kn = load_lanes(s.kn + at), ks = load_lanes(s.ks + at);
  const Lanes ft = load_lanes(s.tension + at), c = kMargin * load_lanes(s.cohesion + at), tan_phi = load_lanes(s.tan_phi + at);
  const Lanes fm = kMargin * load_lanes(s.compression + at), cap = load_lanes(s.cap + at);
  const Lanes ss[2] = {load_lanes(s.s_low + at), load_lanes(s.s_high + at)}, tt[2] = {load_lanes(s.t_low + at), load_lanes(s.t_high + at)};
  LaneMask tension_or_cap_exceeded{}, above_cohesion{}, above_coulomb{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const VecLanes u = k.d + (ss[i] * k.a + tt[j] * k.b);
      const Lanes un = dot(u, k.n), sigma = kn * un;
      const VecLanes us = u - un * k.n;
      const Lanes tau2 = ks * ks * dot(us, us);
      const Lanes coulomb = c - sigma * tan_phi;
      tension_or_cap_exceeded |= (sigma > kMargin * ft) | (sigma * sigma + cap * tau2 > fm * fm);
      above_cohesion |= tau2 > c * c;
      above_coulomb |= (coulomb < 0.0) | (tau2 > coulomb * coulomb);
    }
  }
  LaneMask shear_exceeded = above_cohesion & above_coulomb;
  // Where the limit in tension is c − σ tan φ, only that test bounds it; without a limit in tension it stays on the safe side.
  if (o.in_tension == ShearInTension::coulomb) shear_exceeded = above_coulomb;
  if (!o.shear) shear_exceeded = LaneMask{};
  return ~(tension_or_cap_exceeded | shear_exceeded);
}

struct WrenchLanes {
  VecLanes f, ta, tb;
};

VOUSSOIR_INLINE VecLanes spring(Lanes ks, Lanes extra, VecLanes n, VecLanes u) noexcept { return ks * u + (extra * dot(n, u)) * n; }

VOUSSOIR_INLINE WrenchLanes forces(const SideBlock& s, int at, const Kinematics& k) noexcept {
  const Lanes ks = load_lanes(s.ks + at), extra = load_lanes(s.kn + at) - ks;
  const Lanes sss = load_lanes(s.sss + at), sst = load_lanes(s.sst + at), stt = load_lanes(s.stt + at);
  const VecLanes ga = spring(ks, extra, k.n, k.a), gb = spring(ks, extra, k.n, k.b);
  WrenchLanes w;
  w.f = load_lanes(s.area + at) * spring(ks, extra, k.n, k.d);
  const VecLanes m = cross(k.es, sss * ga + sst * gb) + cross(k.et, sst * ga + stt * gb);
  w.ta = cross(k.arm_a, w.f) + m;
  w.tb = cross(k.arm_b, w.f) + m;
  return w;
}

VOUSSOIR_INLINE void scatter(const SideBlock& s, int at, const WrenchLanes& w, unsigned lanes_done, double* rows,
                             std::int32_t free_rows) noexcept {
  for (int l = 0; l < kWidth; ++l) {
    if (!(lanes_done >> l & 1U)) continue;
    const Vec3 f{w.f.x[l], w.f.y[l], w.f.z[l]};
    const std::int32_t a = s.master[at + l], b = s.slave[at + l];
    if (a < free_rows) add_wrench(rows, a, f, {w.ta.x[l], w.ta.y[l], w.ta.z[l]});
    if (b < free_rows) add_wrench(rows, b, -f, {-w.tb.x[l], -w.tb.y[l], -w.tb.z[l]});
  }
}

}  // namespace

unsigned quick_sides(const SideBlock& block, const Quick* quick, const double* pose, double* wrench, std::int32_t free_rows,
                     FailureOptions o) noexcept {
  unsigned done = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    const LaneMask state = widened(reinterpret_cast<const unsigned char*>(quick + at));
    const unsigned whole = bits(state == static_cast<long long>(Quick::whole)), open = bits(state == static_cast<long long>(Quick::open));
    if ((whole | open) == 0) continue;
    const Kinematics k = kinematics(block, at, pose);
    if (open != 0) done |= (open & bits(all_open(block, at, k))) << at;
    if (whole == 0) continue;
    const unsigned ok = whole & bits(certified(block, at, k, o));
    scatter(block, at, forces(block, at, k), ok, wrench, free_rows);
    done |= ok << at;
  }
  return done;
}

double whole_side_energy(const SideBlock& block, int lane, const double* pose) noexcept {
  const int at = lane - lane % kWidth, l = lane % kWidth;
  const Kinematics k = kinematics(block, at, pose);
  const Lanes ks = load_lanes(block.ks + at), extra = load_lanes(block.kn + at) - ks;
  const VecLanes ga = spring(ks, extra, k.n, k.a), gb = spring(ks, extra, k.n, k.b), gd = spring(ks, extra, k.n, k.d);
  const Lanes twice = load_lanes(block.area + at) * dot(k.d, gd) + load_lanes(block.sss + at) * dot(k.a, ga) +
                      2.0 * load_lanes(block.sst + at) * dot(k.a, gb) + load_lanes(block.stt + at) * dot(k.b, gb);
  return 0.5 * twice[l];
}

}  // namespace voussoir::kernels
