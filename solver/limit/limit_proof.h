// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/forward.h"
#include "kernels/rows.h"
#include "solver/limit/balance.h"
#include "solver/limit/contacts.h"
#include "solver/limit/friction_cone.h"
#include "solver/limit/live_load.h"

/// Checks of results of limit analysis against the model itself: its joints, segments and masses, in three dimensions. They share neither
/// equations nor contact points with the programmes, and so detect faults of these.
namespace voussoir::solver {

/// Violations of admissibility by forces at contact points. Forces are divided by the mean weight of a body, moments also by the mean
/// lever.
struct ForceCheck {
  double unbalanced = 0.0;     // largest residual force or moment on a body
  double tension = 0.0;        // largest tension at a point
  double over_friction = 0.0;  // largest shear above the limit at a point
  double off_joint = 0.0;      // largest distance of a point from its joint's segments, over the mean lever
  double over_yield = 0.0;     // largest force of a tie beyond those at which it yields
  [[nodiscard]] double worst() const noexcept;
};

/// Violations by a motion of the conditions of a mechanism. Speeds are divided by that of the fastest point.
struct MotionCheck {
  double overlap = 0.0;                       // greatest speed of contact points into each other
  double off_normal = 0.0;                    // associated flow: greatest deficit of the opening that accompanies slip
  double stretch = 0.0;                       // greatest speed at which a tie without limit gives way
  std::vector<double> deficit;                // by joint: greatest such deficit; zero within one body
  std::vector<double> stretches;              // by tie: that speed; zero of ties that yield
  double dead_power = 0.0, live_power = 0.0;  // W at the speed 1 m/s
  double tie_power = 0.0;                     // W, taken by ties that yield
  double dead_terms = 0.0;                    // W, the powers of the single dead forces and moments, each without its sign
  double fastest = 0.0;                       // m/s, greatest speed of all contact points and corners of blocks
};

class LimitModel {
 public:
  LimitModel(const cases::Model& model, const LimitContacts& contacts, const LimitForces& forces, const FrictionCone& cone, Vec3 direction)
      : model_(model), contacts_(contacts), forces_(forces), cone_(cone), direction_(direction) {}

  /// Checks forces. \param dead,  live factors of these forces
  [[nodiscard]] ForceCheck check_forces(const ModelForces& found, double dead, double live) const;
  [[nodiscard]] MotionCheck check_motion(const std::vector<kernels::Twist>& motion) const;
  /// Deviation of the forces from Coulomb's flow in this motion: sum over the points of pressure times opening speed, and of the difference
  /// between the power of Coulomb's friction and that of the shear, and over the ties of that between the power of their yield force and of
  /// their force, as a share of the power of the live forces.
  [[nodiscard]] double lost_power(const ModelForces& found, const std::vector<kernels::Twist>& motion) const;
  /// Bound on the error of the multiplier's upper bound due to violations of normality, for forces like these: each joint's deficit holds
  /// back what presses that joint, and so does the stretch of a tie without limit what pulls it. A light stone on heavy ones thus has a
  /// bound of its own weight.
  [[nodiscard]] double slack_of_bound(const ModelForces& found, const MotionCheck& c) const;

 private:
  [[nodiscard]] Vec3 speed(std::int32_t body, Vec3 at, const std::vector<kernels::Twist>& motion) const;
  [[nodiscard]] double power(const BodyForces& f, const std::vector<kernels::Twist>& motion) const;

  const cases::Model& model_;
  const LimitContacts& contacts_;
  const LimitForces& forces_;
  const FrictionCone& cone_;
  Vec3 direction_;
};

/// A multiplier between two bounds, with the results of the checks.
struct LimitProof {
  double lower = 0.0;  // multiple of the live forces balanced by admissible forces
  double upper = 0.0;  // multiple of the live forces above which a mechanism with associated flow moves
  ForceCheck forces;
  MotionCheck motion;
  double lost_power = 0.0;  // Coulomb's flow: LimitModel::lost_power
  bool holds = false;
  bool wide = false;  // the two bounds differ by more than kGap

  static constexpr double kForces = 1e-6, kMotion = 1e-6;  // allowed violations
  static constexpr double kGap = 1e-6, kLeast = 1e-2;      // of the multiplier, or of kLeast if the multiplier is less
  static constexpr double kWidest = 1e-4;                  // likewise; beyond it none is printed
  static constexpr double kLost = 1e-4;                    // of the multiplier: allowed deficit of the power of Coulomb's friction
};

}  // namespace voussoir::solver
