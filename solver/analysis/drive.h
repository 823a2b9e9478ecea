// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/run/simulation.h"

/// Rate and damping of a quasi-static analysis, from the first frequencies (kernels/THEORY.md, section 11).
namespace voussoir::solver {

/// Chooses the drive of an analysis and gives it to the simulation; of a time history it does nothing. Before the first step of a run; one
/// that goes on has its drive from its checkpoint.
/// \throw cases::InputError if the case asks for a mode that no mass follows \throw NumericalError if there are no modes to be found
void choose_drive(Simulation& sim, const cases::Case& c);

}  // namespace voussoir::solver
