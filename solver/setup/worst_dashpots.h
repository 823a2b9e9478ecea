// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "solver/team/team.h"

/// The largest dashpots that a face can have, in contact with any other face.
namespace voussoir::solver {

/// Properties of one of the two faces on which a dashpot depends.
struct FaceClass {
  double compliance_n = 0.0, compliance_s = 0.0;  // m/Pa
  double mass = 0.0;                              // kg/m2
  auto operator<=>(const FaceClass&) const = default;
};

/// By class: the largest dashpot constants per area, normal and shear, with any of the classes (Eq. 9), equal bit by bit to the maximum
/// over pairs.
/// \param h  fraction of critical damping
std::vector<std::array<double, 2>> worst_dashpots(const std::vector<FaceClass>& classes, double h, Team& team);

}  // namespace voussoir::solver
