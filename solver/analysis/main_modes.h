// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/forward.h"
#include "solver/analysis/modes.h"

/// The modes that determine mass damping: those with most of the mass along x and along y.
namespace voussoir::solver {

inline constexpr int kMainModesOf = 12;         // number of lowest modes examined
inline constexpr double kLeastMassShare = 0.1;  // share of mass below which a mode is that of a part of the building only

struct MainMode {
  int number = 0;          // from 1, in ascending order of frequency, among the lowest; 0: none of these
  double frequency = 0.0;  // Hz; 0: no mode reaches kLeastMassShare
  double mass_share = 0.0;
};

/// The modes with the largest effective mass along x and along y among the lowest kMainModesOf modes.
/// \throw NumericalError as natural_modes
std::array<MainMode, 2> main_modes(const cases::Case& c, const cases::Model& model, DryJoints dry = DryJoints::open);

/// The same among all modes, however many of rafters or loose beams lie below those of the building. Without a number.
std::array<MainMode, 2> main_modes_of_all(const cases::Case& c, const cases::Model& model, DryJoints dry);

}  // namespace voussoir::solver
