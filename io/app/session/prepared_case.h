// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"
#include "cases/motion.h"
#include "io/input/case_file/case_file.h"

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

}  // namespace voussoir::io
