// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

/// Opens the results of a run, given as its folder or its run.h5. A file of an earlier version, which is not sealed, is noted on standard
/// error.
/// \throw FileError if the file holds no results, has a later schema than this program knows, or lacks the seal that its schema has
Hdf5File open_run(const std::string& path);

/// Reads all of a run, and its parts: every byte of what is sealed. Returns the number of files. \throw FileError
std::size_t check_run(const std::string& path);

}  // namespace voussoir::io
