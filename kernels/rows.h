// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/vec3.h"

/// Packed rows, one per element, which the force kernels gather and scatter. A row is one or two cache lines, so that a body costs a few
/// vector loads instead of twelve separate ones. The drift of a step writes the rows of poses and velocities from the state arrays
/// (solver/world/world.h).
namespace voussoir::kernels {

/// Number of sides in a block, and the multiple that element arrays are padded to.
inline constexpr int kLanes = 8;

inline constexpr int kPoseStride = 12;    // for each axis i: row i of R − I (3), u_i [m]
inline constexpr int kTwistStride = 8;    // velocity (3) [m/s], angular velocity in space (3) [rad/s], 2 spare
inline constexpr int kWrenchStride = 8;   // force (3) [N], torque about the centroid (3) [N m], kPushedColumn, kDashedColumn
inline constexpr int kPushedColumn = 6;   // column of a wrench row: sum of the sizes of the contact forces in it [N] (22a)
inline constexpr int kDashedColumn = 7;   // column of a wrench row: not 0 if dashpots contribute to it; if 0, the dashpot row is all zeros
inline constexpr int kDashpotStride = 8;  // dashpots' share of the wrench: force (3) [N], torque (3) [N m], 2 spare

/// Number of elements in a batch: elements that are advanced together and share an energy tally.
inline constexpr int kBatch = 2 * kLanes;

/// Rows of all elements.
struct ElementRows {
  double *pose = nullptr, *twist = nullptr, *wrench = nullptr, *dashpot = nullptr;
  const std::uint8_t* active = nullptr;  // by batch, 1: its velocity rows are written; nullptr: all are written
  bool out_of_cache = false;             // rows are larger than the caches: poses are written by streaming stores, columns are prefetched
};

/// Displacement of the centroid from its reference position [m] and R − I (without the identity: see rotation_minus_identity).
struct Pose {
  Vec3 u;
  Mat3 d;
};
struct Twist {
  Vec3 v, w;
};

inline Pose load_pose(const double* rows, std::int64_t e) noexcept {
  const double* r = rows + e * kPoseStride;
  return {{r[3], r[7], r[11]}, {{r[0], r[1], r[2]}, {r[4], r[5], r[6]}, {r[8], r[9], r[10]}}};
}
inline void store_pose(double* rows, std::int64_t e, const Pose& p) noexcept {
  double* r = rows + e * kPoseStride;
  r[0] = p.d.r0.x, r[1] = p.d.r0.y, r[2] = p.d.r0.z, r[3] = p.u.x;
  r[4] = p.d.r1.x, r[5] = p.d.r1.y, r[6] = p.d.r1.z, r[7] = p.u.y;
  r[8] = p.d.r2.x, r[9] = p.d.r2.y, r[10] = p.d.r2.z, r[11] = p.u.z;
}
inline void store_displacement(double* rows, std::int64_t e, Vec3 u) noexcept {
  double* r = rows + e * kPoseStride;
  r[3] = u.x, r[7] = u.y, r[11] = u.z;
}
inline void store_twist(double* rows, std::int64_t e, const Twist& t) noexcept {
  double* r = rows + e * kTwistStride;
  r[0] = t.v.x, r[1] = t.v.y, r[2] = t.v.z;
  r[3] = t.w.x, r[4] = t.w.y, r[5] = t.w.z;
}
inline Twist load_twist(const double* rows, std::int64_t e) noexcept {
  const double* r = rows + e * kTwistStride;
  return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
}

/// Force [N] and torque [N m] of one interaction on both bodies, each torque about the body's own centroid; `dash_*` is the part of the
/// dashpots, counted for the ledger.
struct PairWrench {
  Vec3 force;  // on a; b gets the opposite
  Vec3 torque_a, torque_b;
  Vec3 dash_force, dash_torque_a, dash_torque_b;
};

inline void add_wrench(double* rows, std::int64_t e, Vec3 f, Vec3 t) noexcept {
  double* r = rows + e * kWrenchStride;
  r[0] += f.x, r[1] += f.y, r[2] += f.z;
  r[3] += t.x, r[4] += t.y, r[5] += t.z;
}
inline void add_dashpot(double* wrench, double* dashpot, std::int64_t e, Vec3 f, Vec3 t) noexcept {
  wrench[e * kWrenchStride + kDashedColumn] = 1.0;
  double* r = dashpot + e * kDashpotStride;
  r[0] += f.x, r[1] += f.y, r[2] += f.z;
  r[3] += t.x, r[4] += t.y, r[5] += t.z;
}
/// Adds the size of a contact force, which the wrench row holds already, to the row's sum of sizes (22a).
inline void note_push(double* wrench, std::int64_t e, Vec3 f) noexcept {
  wrench[e * kWrenchStride + kPushedColumn] += std::abs(f.x) + std::abs(f.y) + std::abs(f.z);
}

}  // namespace voussoir::kernels
