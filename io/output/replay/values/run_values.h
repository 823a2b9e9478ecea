// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/input/files/hdf5_file.h"

/// Do the shapes and numbers of results make sense (value_rules.h)? A seal does not tell: a forger computes it anew.
namespace voussoir::io {

/// Checks the extents of all datasets against each other, and the counts of rows that the file states. Reads no values. \throw FileError,
/// naming the dataset
void check_shapes(const Hdf5File& run);

/// An Inspection: checks numbers as they are read. \throw FileError, naming dataset and row
void check_values(const Hdf5File& run, const std::string& dataset, Hdf5Type type, std::uint64_t first, std::uint64_t rows,
                  const void* data);

}  // namespace voussoir::io
