// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/model.h"
#include "kernels/rows.h"
#include "solver/limit/contacts.h"
#include "solver/limit/friction_cone.h"
#include "solver/limit/live_load.h"

/// Checks of what limit analysis found against the model itself: its joints, segments and masses, in three dimensions. They share neither
/// equations nor contact points with the programmes, so that a fault there is found here.
namespace voussoir::solver {

/// How far forces at contact points are from being admissible. Forces over the mean weight of a body, moments also over the mean lever.
struct ForceCheck {
  double unbalanced = 0.0;     // largest force or moment left on a body
  double tension = 0.0;        // largest tension at a point
  double over_friction = 0.0;  // largest shear above the limit at a point
  double off_joint = 0.0;      // largest distance of a point from its joint's segments, over the mean lever
  [[nodiscard]] double worst() const noexcept;
};

/// How far a motion is from being a mechanism. Speeds over the fastest point's.
struct MotionCheck {
  double overlap = 0.0;                       // the fastest speed at which contact points go into each other
  double off_normal = 0.0;                    // associated flow: what slip lacks at worst of the opening that goes with it
  double dead_power = 0.0, live_power = 0.0;  // W at the speed 1 m/s
  double fastest = 0.0;                       // m/s, of all contact points and corners of blocks
};

class LimitModel {
 public:
  LimitModel(const cases::Model& model, const LimitContacts& contacts, const LimitForces& forces, const FrictionCone& cone, Vec3 direction)
      : model_(model), contacts_(contacts), forces_(forces), cone_(cone), direction_(direction) {}

  /// \param at_points  of LimitContacts::points, on body a, N \param dead, live  how many times these forces act
  [[nodiscard]] ForceCheck check_forces(const std::vector<Vec3>& at_points, double dead, double live) const;
  [[nodiscard]] MotionCheck check_motion(const std::vector<kernels::Twist>& motion) const;
  /// By how much the forces fall short of the power that Coulomb's friction takes in this motion, where points that are pressed together
  /// do not part: both as a share of the power of the live forces.
  [[nodiscard]] double lost_power(const std::vector<Vec3>& at_points, const std::vector<kernels::Twist>& motion) const;
  /// What a violation of normality would let forces like these add to the multiplier's upper bound.
  [[nodiscard]] double slack_of_bound(const std::vector<Vec3>& at_points, const MotionCheck& c) const;

 private:
  [[nodiscard]] Vec3 speed(std::int32_t body, Vec3 at, const std::vector<kernels::Twist>& motion) const;
  [[nodiscard]] double power(const BodyForces& f, const std::vector<kernels::Twist>& motion) const;

  const cases::Model& model_;
  const LimitContacts& contacts_;
  const LimitForces& forces_;
  const FrictionCone& cone_;
  Vec3 direction_;
};

/// A multiplier between two bounds, and what was checked.
struct LimitProof {
  double lower = 0.0;  // forces that are admissible balance this multiple of the live forces
  double upper = 0.0;  // a mechanism, to which slip belongs as associated flow has it, moves under more than this
  ForceCheck forces;
  MotionCheck motion;
  double lost_power = 0.0;  // Coulomb's flow: LimitModel::lost_power
  bool holds = false;

  static constexpr double kForces = 1e-6, kMotion = 1e-6;  // what the checks may show
  static constexpr double kGap = 1e-6, kLeast = 1e-2;      // of the multiplier, or of this where it is less
  static constexpr double kLost = 1e-4;                    // of the multiplier: power that Coulomb's friction may miss
};

}  // namespace voussoir::solver
