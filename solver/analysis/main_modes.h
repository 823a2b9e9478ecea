// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/model.h"
#include "solver/analysis/modes.h"

/// The modes that matter to mass damping: those that move most of the mass along x and along y.
namespace voussoir::solver {

inline constexpr int kMainModesOf = 12;         // lowest modes that are looked at
inline constexpr double kLeastMassShare = 0.1;  // below it a mode moves a part of the building, not the building

struct MainMode {
  int number = 0;          // from 1, in ascending order of frequency; 0: none has kLeastMassShare, or it is a mechanism
  double frequency = 0.0;  // Hz
  double mass_share = 0.0;
};

/// Of the lowest kMainModesOf modes, the one with the largest effective mass along x, and along y.
/// \throw NumericalError as natural_modes
std::array<MainMode, 2> main_modes(const cases::Case& c, const cases::Model& model, DryJoints dry = DryJoints::open);

}  // namespace voussoir::solver
