// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "solver/limit/limit.h"

/// How the multiplier of a mechanism falls as the mechanism moves by finite displacements: the curve of non-linear kinematic analysis
/// (LIMIT.md; Circolare 7/2019, C8.7.1.2.1.2 and 3).
namespace voussoir::solver {

struct KinematicPoint {
  double displacement = 0.0;  // m, of the control point, horizontally along the live load
  double multiplier = 0.0;
};

struct KinematicCurve {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::size_t parts = 0;               // of the mechanism, each a rigid body
  std::vector<KinematicPoint> points;  // from the beginning of the motion to a multiplier of zero, or to the end of what is followed
  double zero = kNone;                 // m, d_C0: displacement of the control point at which the multiplier is zero; NaN: not found
  Vec3 control;                  // m, the control point at first: the centre of mass of the part that moves fastest along the live load
  double weight = 0.0;           // N, Σ P_k of the moving parts
  double participation = kNone;  // e*, (C8.7.1.5)
  double spectral = kNone;       // d / d_C, (C8.7.1.4)
  std::size_t freedoms = 0;      // of the parts on their hinges; 1: the motion has no choice
  std::size_t sliding = 0;       // seams that slide, or part without a hinge: they do not hold the motion
  std::string none;              // why there is no curve, or no zero; empty: there is one

  /// The multiplier at a displacement of the control point, linear between points. \pre points
  [[nodiscard]] double at(double displacement) const;
};

/// Follows a mechanism of limit analysis. Parts turn about their hinges, which stay where they are in the material; the multiplier is that
/// of virtual work, −Σ dead · v / Σ live · v, with dead loads at their points of the material and live forces at the parts' centres of
/// mass. Ties pull along the line between their ends as it is now, with their yield force while they get longer, until they break. Where the parts have more than one freedom, the motion goes on as it is. \pre the live load is the weight of all bodies
KinematicCurve kinematic_curve(const cases::Case& c, const cases::Model& model, const LimitContacts& contacts, const LimitState& state,
                               Vec3 live);

}  // namespace voussoir::solver
