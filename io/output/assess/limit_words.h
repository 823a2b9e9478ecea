// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "io/output/assess/kinematic_check.h"
#include "solver/limit/limit.h"
#include "solver/limit/load_path.h"

/// Output of `voussoir limit`: a text table, one JSON object, or the mechanism element by element as CSV.
namespace voussoir::io {

struct LimitQuestion {
  std::string title, live;  // title of the case; description of the load that the multiplier scales
  solver::LimitOptions options;
  std::optional<KinematicQuestion> kinematic;  // also follow the mechanisms by finite displacements
};

/// The curve of a mechanism of the case and its verification, if that was asked for.
struct Kinematics {
  std::string rule;  // "associated" or "Coulomb"
  solver::KinematicCurve curve;
  KinematicCheck check;
};
std::vector<Kinematics> kinematics_of(const LimitQuestion& asked, const cases::Case& c, const cases::Model& model,
                                      const solver::LimitResult& found);

/// \param path  the path of a moving load, of which `found` is the weakest position; null: the load does not move
std::string limit_text(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found,
                       const solver::LoadPath* path = nullptr, const std::vector<Kinematics>& kinematics = {});
std::string limit_json(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found,
                       const solver::LoadPath* path = nullptr, const std::vector<Kinematics>& kinematics = {});
/// CSV with one row per element and flow rule: velocity of its centroid, angular velocity, and the part to which it belongs (0: the
/// ground).
std::string limit_csv(const LimitQuestion& asked, const cases::Model& model, const solver::LimitResult& found);

}  // namespace voussoir::io
