// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "solver/run/simulation.h"

/// How far a quasi-static analysis by states of rest is, for the line of progress.
namespace voussoir::io {

/// What has been reached, and what will end the analysis:
/// pushover, tilt: "load factor 0.2500, control point 3.21 of 480 mm, base shear 95 % of its largest (ends at 80 %)";
/// cyclic: "load factor 0.2500, control point 3.21 mm, 2 of 6 half cycles";
/// settlement: "supports moved by 12.3 of 30.0 mm, 4.10 of 10 s of their histories".
std::string headway(const solver::Simulation& sim);

}  // namespace voussoir::io
