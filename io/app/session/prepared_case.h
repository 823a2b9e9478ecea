// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/model.h"
#include "cases/motion.h"
#include "io/input/case_file/case_file.h"

/// Preparation of a case for a command: checks that need the model.
namespace voussoir::io {

/// The model of a case, with the motions of its supports. Refuses followed points outside the model.
/// \param threads  number of threads that build it \throw cases::InputError, FileError
cases::Model prepared_model(const cases::Case& c, int threads = 1);

/// Replaces damping.frequency = "auto" by the frequency of the mode with the largest mass in y, to four digits, so that the resolved case
/// contains it. Reports the mode on standard error. \throw cases::InputError if no mode moves the building along y
void fill_own_frequency(cases::Case& c, int threads);

}  // namespace voussoir::io
