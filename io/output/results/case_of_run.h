// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "cases/motion.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

/// The case of a run, from its results, with coordinates relative to the run's origin. \throw FileError
cases::Case case_of_run(const Hdf5File& run);

/// The acceleration of the base as applied: /motion of the run; for runs without /motion, from the case's records. \throw FileError
cases::GroundMotion base_of_run(const Hdf5File& run, const cases::Case& c);

}  // namespace voussoir::io
