// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

/// Version of the layout of run.h5, its attribute `schema_version`.
inline constexpr std::int64_t kResultsSchema = 6;
/// The earliest version that is read: there is a sample of each from here on (tests/io/samples/README.md), none of those before.
inline constexpr std::int64_t kOldestSchema = 4;
/// The first version whose files are sealed (io/input/files/sealed_pages.h).
inline constexpr std::int64_t kSealedSchema = 6;

/// Opens the results of a run, given as its folder or its run.h5. A file of an earlier version, which is not sealed, is noted on standard
/// error.
/// Links, values in other files, and shapes are checked at once, numbers as they are read (run_values.h).
/// \throw FileError if the file holds no results, has a schema that this program does not know, lacks the seal that its schema has, or
/// makes no sense
Hdf5File open_run(const std::string& path);

/// Parts that the file names and that are not beside it. \throw FileError
std::vector<std::string> missing_parts(const Hdf5File& run);

/// Reads all of a run, and its parts: every byte of what is sealed. Returns the number of files. \throw FileError
std::size_t check_run(const std::string& path);

}  // namespace voussoir::io
