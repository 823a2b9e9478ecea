// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/vec3.h"
#include "kernels/rows.h"

/// Central differences (Eqs. 15-18, THEORY.md (22)-(24)), element by element. The new state of an element depends on that element's data
/// only.
namespace voussoir::kernels {

/// The energy tally of a batch: running sums over its elements and over all steps so far [J].
enum class Tally : std::uint8_t { work_ground, work_gravity, loss_damping, loss_dashpots };
inline constexpr int kTallies = 4;

/// State and constants of all elements, structure of arrays; SI units, global axes unless said.
struct ElementsView {
  double *ux, *uy, *uz;                             // displacement of the centroid [m]
  double *qw, *qx, *qy, *qz;                        // orientation
  double *vx, *vy, *vz;                             // velocity at the half step [m/s]
  double *lx, *ly, *lz;                             // angular momentum at the half step, space axes [kg m2/s]
  double *wx, *wy, *wz;                             // angular velocity at the half step, space axes [rad/s]
  double* tally;                                    // J, kTallies of each batch
  const double* mass;                               // kg, that weighs; 0: fixed
  const double *inert_mass, *inv_mass;              // kg, 1/kg: what forces accelerate; `mass` but in a relaxation; 0 and 0: fixed
  const double* alpha;                              // 1/s, mass damping (Eq. 13)
  const double *ixx, *iyy, *izz, *ixy, *ixz, *iyz;  // inverse inertia, body axes [1/(kg m2)]; 0: fixed
  const std::uint8_t* principal;                    // by batch, 1: all its elements have principal body axes (ixy, ixz, iyz are 0)
};

/// Of the sum of the sizes of contact forces: a component of their sum below it may be round-off (22a). Each force comes from a depth, the
/// small difference of two places, so its own relative error is up to some 1e-9.
inline constexpr double kPushRoundOff = 1e-8;

/// Accelerations that act on every element in a step.
struct BodyForces {
  double dt = 0.0;                   // s
  Vec3 gravity, ground;              // m/s2 at this step (ground: acceleration of the base, so −ground acts, Eq. 15)
  Vec3 mean_gravity, mean_ground;    // mean of this and the last step: the trapezoid rule of the ledger
  bool damps_rotation = false;       // α also acts on the angular momentum: while settling, where only the state of rest matters
  Vec3 damped_ground{};              // m/s at this step: velocity of the ground, if damped too (damping.frame = "inertial"); else 0
  double round_off = kPushRoundOff;  // components below this share of the sizes of contact forces count as zero (22a); 0: all count
};

/// Advances velocities to the next half step: v₊ = [(1 − a) v₋ + Δt (F/m − α v_g)] / (1 + a), a = αΔt/2, v_g = damped_ground, and L₊ = L₋ +
/// Δt T, or with the same damping as v under damps_rotation. Adds the work of the step except that of the dashpots' torques, and the loss
/// of the damped rotation with the ω behind the step: ½ αΔt (L₋ + L₊)·ω₋ (the sum over steps is that of the trapezoid rule but for its end,
/// which the ledger adds). Elements [first, last), whole batches.
void kick(const ElementsView& e, const ElementRows& rows, const BodyForces& f, std::int64_t first, std::int64_t last) noexcept;

/// Advances positions and orientations to the next step. ω is the angular velocity at the half step that fits L at the orientation there
/// (implicit midpoint on the rotation group, by two fixed-point passes in body axes: no drift of energy in free rotation). Writes the pose
/// rows and the velocity rows of active batches, adds the work of the dashpots' torques, clears the wrench and dashpot rows. Elements
/// [first, last), whole batches.
void drift(const ElementsView& e, const ElementRows& rows, double dt, std::int64_t first, std::int64_t last) noexcept;

}  // namespace voussoir::kernels
