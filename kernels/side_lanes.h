// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/lanes.h"
#include "kernels/side.h"

/// kWidth sides of a block at a time: how they move, and how their forces reach the elements. Shared by the kernels of whole and of damaged
/// sides; not for other code. `at` is the first lane, a multiple of kWidth.
namespace voussoir::kernels {

// Greatest difference of the squared length of a mean normal from 1 for which the series of its length is exact to all digits.
inline constexpr double kSeries = 1e-4;
inline constexpr unsigned kGroup = (1U << kWidth) - 1U;  // all lanes of a group

VOUSSOIR_INLINE VecLanes load3(const double v[3][kLanes], int at) noexcept {
  return {load_lanes(v[0] + at), load_lanes(v[1] + at), load_lanes(v[2] + at)};
}

/// Relative displacement of the lanes and the frame of their forces. Differences of R − I are taken before anything is added, so an opening
/// of 1e-12 m on a body 5 m away keeps its digits.
struct Kinematics {
  VecLanes d, a, b;  // u(s,t) = d + s a + t b, global axes [m]
  VecLanes n;        // mean normal, not yet normalised
  VecLanes es, et;
  VecLanes arm_a, arm_b;
};

/// Addresses of the rows of kWidth elements.
struct RowPointers {
  const double* at[kWidth];
};
VOUSSOIR_INLINE RowPointers row_pointers(const double* rows, int stride, const std::int32_t* elements) noexcept {
  RowPointers r;
  for (int l = 0; l < kWidth; ++l) r.at[l] = rows + static_cast<std::int64_t>(elements[l]) * stride;
  return r;
}

/// Row i of R − I of kWidth elements, and u_i.
struct PoseRow {
  VecLanes d;
  Lanes u;
};
VOUSSOIR_INLINE PoseRow pose_row(const RowPointers& rows, int i) noexcept {
  PoseRow r;
  load_columns([&](int l) { return rows.at[l]; }, 4 * i, r.d.x, r.d.y, r.d.z, r.u);
  return r;
}

/// Computes one axis of the kinematics. One axis at a time, since the rows of two matrices fit the registers, but two matrices do not.
VOUSSOIR_INLINE void kinematics_of_axis(const SideConstants& s, int at, int i, const RowPointers& a, const RowPointers& b, VecLanes n0,
                                        Lanes VecLanes::*x, Kinematics& k) noexcept {
  const PoseRow p = pose_row(a, i), q = pose_row(b, i);
  const Lanes w = load_lanes(s.mean + at);
  const VecLanes es = load3(s.es, at), et = load3(s.et, at);
  const VecLanes relative = q.d - p.d, carried = p.d + w * relative;
  const Lanes da = dot(p.d, load3(s.ca, at)), db = dot(q.d, load3(s.cb, at)), d = (q.u - p.u) + (db - da);
  k.d.*x = d;
  k.arm_a.*x = load_lanes(s.ca[i] + at) + da + w * d;
  k.arm_b.*x = load_lanes(s.cb[i] + at) + db - (1.0 - w) * d;
  k.a.*x = dot(relative, es);
  k.b.*x = dot(relative, et);
  k.n.*x = n0.*x + dot(carried, n0);
  k.es.*x = es.*x + dot(carried, es);
  k.et.*x = et.*x + dot(carried, et);
}

/// Lanes whose slave is the base.
VOUSSOIR_INLINE unsigned based(const SideBlock& block, int at) noexcept { return block.on_base >> at & kGroup; }

VOUSSOIR_INLINE Kinematics kinematics(const SideBlock& block, int at, const double* pose) noexcept {
  const RowPointers a = row_pointers(pose, kPoseStride, block.master + at), b = row_pointers(pose, kPoseStride, block.slave + at);
  const SideConstants& s = *block.constants;
  const VecLanes n0 = cross(load3(s.es, at), load3(s.et, at));
  Kinematics k;
  kinematics_of_axis(s, at, 0, a, b, n0, &VecLanes::x, k);
  kinematics_of_axis(s, at, 1, a, b, n0, &VecLanes::y, k);
  kinematics_of_axis(s, at, 2, a, b, n0, &VecLanes::z, k);
  if (const unsigned base = based(block, at); base != 0) k.n = select3(lanes_of(base), n0, k.n);  // THEORY.md (10a)
  return k;
}

/// Vectors in the frame of each lane's side.
struct LocalLanes {
  Lanes n, s1, s2;
};
VOUSSOIR_INLINE LocalLanes operator+(LocalLanes a, LocalLanes b) noexcept { return {a.n + b.n, a.s1 + b.s1, a.s2 + b.s2}; }
VOUSSOIR_INLINE LocalLanes operator-(LocalLanes a, LocalLanes b) noexcept { return {a.n - b.n, a.s1 - b.s1, a.s2 - b.s2}; }
VOUSSOIR_INLINE LocalLanes operator*(Lanes f, LocalLanes a) noexcept { return {f * a.n, f * a.s1, f * a.s2}; }
VOUSSOIR_INLINE LocalLanes load_local(const double v[3][kLanes], int at) noexcept {
  return {load_lanes(v[0] + at), load_lanes(v[1] + at), load_lanes(v[2] + at)};
}
VOUSSOIR_INLINE LocalLanes select3(LaneMask m, LocalLanes a, LocalLanes b) noexcept {
  return {select(m, a.n, b.n), select(m, a.s1, b.s1), select(m, a.s2, b.s2)};
}

/// Frame of each lane's side: mean normal and two tangents, orthonormal, global axes.
struct FrameLanes {
  VecLanes n, t1, t2;
  [[nodiscard]] VOUSSOIR_INLINE LocalLanes local(VecLanes v) const noexcept { return {dot(v, n), dot(v, t1), dot(v, t2)}; }
  [[nodiscard]] VOUSSOIR_INLINE VecLanes global(LocalLanes v) const noexcept { return v.n * n + (v.s1 * t1 + v.s2 * t2); }
};
/// Frame from a mean normal and a tangent. \param n  of length 1
VOUSSOIR_INLINE FrameLanes frame_of(VecLanes n, VecLanes es) noexcept {
  const VecLanes along = es - dot(es, n) * n;
  const VecLanes t1 = (1.0 / sqrt(dot(along, along))) * along;
  return {n, t1, cross(n, t1)};
}

/// Frame of the sides of a block. For sides on the base, es of the reference is used, since the base does not turn with the master.
/// \param n  of length 1
VOUSSOIR_INLINE FrameLanes frame_of(const SideBlock& block, int at, const Kinematics& k, VecLanes n) noexcept {
  const unsigned base = based(block, at);
  return frame_of(n, base == 0 ? k.es : select3(lanes_of(base), load3(block.constants->es, at), k.es));
}

/// Slip by twist of faces that twist as solids do, THEORY.md (11a): a and b of bonded segments from those of the faces, and by the same map
/// Σ s f dA and Σ t f dA, so that force and slip do the same work.
struct SolidFaces {
  VecLanes t1, t2;  // of the frame
  Lanes twist;
  [[nodiscard]] VOUSSOIR_INLINE VecLanes along_s(VecLanes a) const noexcept { return a + (twist * dot(a, t2)) * t2; }
  [[nodiscard]] VOUSSOIR_INLINE VecLanes along_t(VecLanes b) const noexcept { return b + (twist * dot(b, t1)) * t1; }
};
/// \param n,es  of any length; on the base es of the reference is used
VOUSSOIR_INLINE SolidFaces solid_faces(const SideBlock& block, int at, VecLanes n, VecLanes es, Lanes twist) noexcept {
  const unsigned base = based(block, at);
  const VecLanes from = base == 0 ? es : select3(lanes_of(base), load3(block.constants->es, at), es);
  const FrameLanes f = frame_of((1.0 / sqrt(dot(n, n))) * n, from);
  return {f.t1, f.t2, twist};
}

/// Least u_n = dn + s an + t bn over the rectangles of the points [m].
VOUSSOIR_INLINE Lanes least_opening(const SideConstants& s, int at, Lanes dn, Lanes an, Lanes bn) noexcept {
  const Lanes s0 = load_lanes(s.s_low + at) * an, s1 = load_lanes(s.s_high + at) * an;
  const Lanes t0 = load_lanes(s.t_low + at) * bn, t1 = load_lanes(s.t_high + at) * bn;
  return dn + (min(s0, s1) + min(t0, t1));
}

/// Sums of tractions over each lane's side, global axes: Σ f dA, Σ s f dA, Σ t f dA.
struct SumLanes {
  VecLanes f, sf, tf;
};

struct WrenchLanes {
  VecLanes force, torque_a, torque_b;  // on the master; about its centroid; about the slave's, with the sign of the master's
};

VOUSSOIR_INLINE WrenchLanes wrench_of(const Kinematics& k, const SumLanes& sums) noexcept {
  const VecLanes m = cross(k.es, sums.sf) + cross(k.et, sums.tf);
  return {sums.f, cross(k.arm_a, sums.f) + m, cross(k.arm_b, sums.f) + m};
}

/// Adds the wrenches of the chosen lanes to the rows of their elements. `dashpot`: whether they are the dashpots' share, which the total
/// includes.
VOUSSOIR_INLINE void assemble(const SideBlock& s, int at, std::int64_t first, const WrenchLanes& w, unsigned chosen, const Rows& rows,
                              bool dashpot) noexcept {
  const SixColumns on_a = rows_of({w.force.x, w.force.y, w.force.z, w.torque_a.x, w.torque_a.y, w.torque_a.z});
  const SixColumns from_b = rows_of({w.force.x, w.force.y, w.force.z, w.torque_b.x, w.torque_b.y, w.torque_b.z});  // on b: the opposite
  if (rows.pairs.on != nullptr && !dashpot) {
    double* buffer = rows.pairs.wrench + (first + at) * kPairStride;
    for (int l = 0; l < kWidth; ++l) {
      store_row(buffer + l * kPairStride, on_a, l);
      store_opposite(buffer + l * kPairStride + 6, from_b, l);
    }
  }
  static_assert(kDashpotStride == kWrenchStride);
  const auto row = [&](std::int32_t element) {
    const std::int64_t begin = static_cast<std::int64_t>(element) * kWrenchStride;
    if (dashpot) rows.wrench[begin + kDashedColumn] = 1.0;
    return (dashpot ? rows.dashpot : rows.wrench) + begin;
  };
  const auto add_a = [&](int l) { add_row(row(s.master[at + l]), on_a, l); };
  const auto add_b = [&](int l) { subtract_row(row(s.slave[at + l]), from_b, l); };
  const unsigned pushed = chosen & ~(s.on_base >> at);
  if (pushed == kGroup) {  // nearly always
    for (int l = 0; l < kWidth; ++l) add_a(l), add_b(l);
    return;
  }
  for (int l = 0; l < kWidth; ++l) {
    if (chosen >> l & 1U) add_a(l);
    if (pushed >> l & 1U) add_b(l);
  }
}

/// Records which lanes stored a copy of their forces, if copies are kept. \param first  side in lane 0
VOUSSOIR_INLINE void note_copies(const Rows& rows, std::int64_t first, unsigned lanes) noexcept {
  if (rows.pairs.on == nullptr) return;
  for (int l = 0; l < kWidth; ++l) rows.pairs.on[first + l] = static_cast<std::uint8_t>(lanes >> l & 1U);
}

}  // namespace voussoir::kernels
