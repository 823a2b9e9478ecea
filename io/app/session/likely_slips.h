// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases/model.h"
#include "cases/motion.h"
#include "io/input/case_file/case_file.h"
#include "solver/analysis/main_modes.h"

/// Findings: what in a case is let through, but is likely a slip. (Values that are unusual by themselves are LoadedCase::findings.)
namespace voussoir::io {

/// Rules of joints.between that never apply; materials and joint laws of the case's own file that nothing has; rods that run through
/// openings; openings with courses above them that neither a lintel nor an arch carries; points far off what they are a point of.
std::vector<std::string> slips_of_model(const LoadedCase& c, const cases::Model& model);

/// These, and: a motion that is stronger than any record, or that ends before 80 % of the run; an intensity that the run does not reach, or
/// that is the mean of a strong and a nearly still component; a damping.frequency that is neither within 20 % of the model's main frequency
/// along y nor of that along x. Modes are computed for that (a house: 2 s), unless the model has more than 10,000 elements.
std::vector<std::string> likely_slips(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion);

/// Tells findings on standard error, a line each.
void warn_of(const std::vector<std::string>& findings);

/// "0.2513"
std::string four_digits(double v);
/// "8.015 Hz (mode 1, 75.1 % of the mass in y)". \param axis  0 to 2
std::string mode_words(const solver::MainMode& m, std::size_t axis);

}  // namespace voussoir::io
