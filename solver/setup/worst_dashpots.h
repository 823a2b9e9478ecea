// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <vector>

/// The largest dashpots that a face can meet, whatever it comes to touch.
namespace voussoir::solver {

/// What a dashpot depends on, of one of its two faces.
struct FaceClass {
  double compliance_n = 0.0, compliance_s = 0.0;  // m/Pa
  double mass = 0.0;                              // kg/m2
  auto operator<=>(const FaceClass&) const = default;
};

/// By class: the largest dashpot constants per area, normal and shear, with any of the classes (Eq. 9), bit by bit as pair by pair.
/// \param h  share of critical damping
std::vector<std::array<double, 2>> worst_dashpots(const std::vector<FaceClass>& classes, double h, int threads);

}  // namespace voussoir::solver
