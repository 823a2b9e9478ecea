// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/side.h"

namespace voussoir::kernels {

namespace {

Local in_frame(Vec3 v, Vec3 n, Vec3 t1, Vec3 t2) noexcept { return {dot(v, n), dot(v, t1), dot(v, t2)}; }

}  // namespace

// THEORY.md (6)-(10a). All fields are exactly affine over a side, because both bodies are rigid. Differences of R − I are taken before
// anything is added, so an opening of 1e-12 m on a body 5 m away keeps its digits.
SideFrame side_frame(const Side& side, const Pose& a, const Pose& b, const Twist& ta, const Twist& tb) noexcept {
  SideFrame f;
  const Mat3 relative = b.d - a.d;
  const Mat3 carried = (1.0 - side.mean) * a.d + side.mean * b.d;
  const Vec3 d = (b.u - a.u) + b.d * side.cb - a.d * side.ca;
  const Vec3 ds = relative * side.es, dt = relative * side.et;
  f.es = side.es + carried * side.es;
  f.et = side.et + carried * side.et;
  const Vec3 n0 = cross(side.es, side.et);
  f.n = side.on_base ? n0 : normalised(n0 + carried * n0);
  const Vec3 along = side.on_base ? side.es : f.es;
  f.t1 = normalised(along - dot(along, f.n) * f.n);
  f.t2 = cross(f.n, f.t1);
  f.arm_a = side.ca + a.d * side.ca + side.mean * d;
  f.arm_b = side.cb + b.d * side.cb - (1.0 - side.mean) * d;
  f.d = in_frame(d, f.n, f.t1, f.t2);
  f.ds = in_frame(ds, f.n, f.t1, f.t2);
  f.dt = in_frame(dt, f.n, f.t1, f.t2);
  // Rates at the point of action, work-conjugate to the force applied there.
  const Vec3 v = (tb.v + cross(tb.w, f.arm_b)) - (ta.v + cross(ta.w, f.arm_a));
  const Vec3 w = tb.w - ta.w;
  f.v = in_frame(v, f.n, f.t1, f.t2);
  f.vs = in_frame(cross(w, f.es), f.n, f.t1, f.t2);
  f.vt = in_frame(cross(w, f.et), f.n, f.t1, f.t2);
  return f;
}

void to_wrench(const SideFrame& f, const SideSums& sums, Vec3& force, Vec3& torque_a, Vec3& torque_b) noexcept {
  const auto global = [&](Local v) { return v.n * f.n + v.s1 * f.t1 + v.s2 * f.t2; };
  force = global(sums.f);
  const Vec3 moment = cross(f.es, global(sums.sf)) + cross(f.et, global(sums.tf));
  torque_a = cross(f.arm_a, force) + moment;
  torque_b = -(cross(f.arm_b, force) + moment);
}

Side side_of(const SideBlock& block, int l, const SideParts& parts) noexcept {
  const SideConstants& b = *block.constants;
  const auto vec = [l](const double v[3][kLanes]) { return Vec3{v[0][l], v[1][l], v[2][l]}; };
  return {.master = block.master[l],
          .slave = block.slave[l],
          .ca = vec(b.ca),
          .cb = vec(b.cb),
          .es = vec(b.es),
          .et = vec(b.et),
          .mean = b.mean[l],
          .on_base = (block.on_base >> l & 1U) != 0,
          .factor = parts.factor,
          .k = {b.kn[l], b.ks[l], parts.dashpot_factor * parts.cn, parts.dashpot_factor * parts.cs},
          .strength = {b.tension[l], b.cohesion[l], b.tan_phi[l], b.compression[l], b.cap[l], b.friction[l]},
          .twist = b.twist[l]};
}

}  // namespace voussoir::kernels
