// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"
#include "cases/motion.h"
#include "io/case_file/case_file.h"

/// Between the case as it was read and what a command does with it: what cannot be told before the model is built.
namespace voussoir::io {

/// cases::build_model on all threads that the program uses (use_threads).
cases::Model build_on_all_threads(const cases::Case& c);

/// The model of a case, with the motions of its supports. Refuses followed points outside of it.
/// \throw cases::InputError, FileError
cases::Model prepared_model(const cases::Case& c);

/// Puts a number in place of damping.frequency = "auto": the frequency of the mode with the largest mass in y, to four digits, so that the
/// case as used says it. Tells which mode on standard error. \throw cases::InputError if no mode moves the building along y
void fill_own_frequency(cases::Case& c);

/// What in a case is likely a slip, told on standard error: rules of joints.between that never apply; materials and joint laws of the
/// case's own file that nothing has; a motion that is stronger than any record, or that ends before 80 % of the run; an intensity that the
/// run does not reach, or that is the mean of a strong and a nearly still component; a damping.frequency that is neither within 20 % of the
/// model's main frequency along y nor of that along x. Modes are computed for that (a house: 2 s), unless the model has more than 10,000
/// elements. (Values that are unusual by themselves are LoadedCase::notes.)
void warn_of_slips(const LoadedCase& c, const cases::Model& model, const cases::GroundMotion& motion);

}  // namespace voussoir::io
