// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/motion.h"
#include "io/input/case_file/case_file.h"
#include "solver/analysis/main_modes.h"

/// Findings: accepted input that is probably a mistake. (Values that are unusual by themselves are in LoadedCase::findings.)
namespace voussoir::io {

/// Findings of the files of stones: signs of damage, content that was left out. Needs no model. \pre the stones are loaded
std::vector<std::string> doubts_of_stones(const LoadedCase& c);

/// Findings of doubts_of_stones, and of the model: rules of joints.between that never apply; materials and joint laws of the case's own
/// file without use; rods that run through openings; openings with courses above that neither a lintel nor an arch carries; points far off
/// their element.
std::vector<std::string> slips_of_model(const LoadedCase& c, const cases::Model& model);

/// Findings of slips_of_model, and: a motion that is stronger than any record, or ends before 80 % of the run; an intensity that the run
/// does not reach, or that is the mean of a strong and a nearly still component; a damping.frequency not within 20 % of the model's main
/// frequency along x or y. The latter needs modes (a house: 2 s), and is omitted for more than 10,000 elements.
std::vector<std::string> likely_slips(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion);

/// Prints findings on standard error, one line each.
void warn_of(const std::vector<std::string>& findings);

/// A number with four digits: "0.2513".
std::string four_digits(double v);
/// A mode in words: "8.015 Hz (mode 1, 75.1 % of the mass in y)". \param axis  0 to 2
std::string mode_words(const solver::MainMode& m, std::size_t axis);

}  // namespace voussoir::io
