// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

/// Bitwise comparison of two results.
namespace voussoir::io {

/// The first place where two files differ.
struct Difference {
  std::string dataset;
  std::string what;            // "row 12", "row 12 and row 6", "other times; ...", "other shapes", "only in the first"
  std::optional<double> time;  // s, of the row
};

/// Result of compare_files. `differing` = 0: the same bits.
struct Comparison {
  std::size_t datasets = 0;  // in either file
  std::size_t differing_datasets = 0, differing_attributes = 0;
  std::size_t differing = 0;        // sum of both
  std::optional<Difference> first;  // the earliest in time; if none has a time, the first by name
  std::optional<Difference> input;  // the first within /case and /model: the cause
};

/// Compares every dataset of two HDF5 files except provenance, and the attributes of /, /case and /summary. Rows are compared byte by byte,
/// so a NaN equals itself. Rows of equal time are compared: where two runs wrote at different intervals, the dataset of times differs, and
/// the other datasets of its group differ only if they do at a common time. Cracks are compared in order. \throw FileError
Comparison compare_files(const std::string& a, const std::string& b);

}  // namespace voussoir::io
