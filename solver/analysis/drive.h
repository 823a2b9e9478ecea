// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "solver/run/simulation.h"

/// Rate and damping of a quasi-static analysis, from the first frequencies (kernels/THEORY.md, section 11).
namespace voussoir::solver {

/// Sets the drive of a quasi-static analysis in the simulation; has no effect for a time history. To be called before the first step of a
/// run; a resumed run has its drive from the checkpoint.
/// \throw cases::InputError if the case needs a mode with mass that does not exist \throw NumericalError if no modes are found
void choose_drive(Simulation& sim, const cases::Case& c);

}  // namespace voussoir::solver
