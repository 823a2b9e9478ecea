// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>

#include "io/input/files/sealed_pages.h"

/// How HDF5 reads files here: through PagedFile. For the sources of Hdf5File alone.
namespace voussoir::io::hdf5 {

/// Makes files that are opened with these properties be read through PagedFile. \return HDF5's status
int use_paged_files(std::int64_t access_properties);

/// The PagedFile of an open file.
PagedFile& paged_file(std::int64_t file);

/// The fault of the last read that failed, if HDF5 has had one since the last call: HDF5 itself passes on no exception, and ignores
/// some faults.
std::exception_ptr take_fault() noexcept;

}  // namespace voussoir::io::hdf5
