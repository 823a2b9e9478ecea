// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/case.h"
#include "io/files/hdf5_file.h"

namespace voussoir::io {

/// The case that a run was made of, from its results. \throw FileError
cases::Case case_of_run(const Hdf5File& run);

}  // namespace voussoir::io
