// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

/// Are two results the same, bit for bit?
namespace voussoir::io {

/// Where two files part.
struct Difference {
  std::string dataset;
  std::string what;            // "row 12", "row 12 and row 6", "other times; ...", "other shapes", "only in the first"
  std::optional<double> time;  // s, of the row
};

/// What compare_files found. Nothing but `differing` = 0: the same bits.
struct Comparison {
  std::size_t datasets = 0;  // in either file
  std::size_t differing_datasets = 0, differing_attributes = 0;
  std::size_t differing = 0;        // both
  std::optional<Difference> first;  // the earliest in time; without any time the first by name
  std::optional<Difference> input;  // the first of /case and /model: why they part
};

/// Compares every dataset of two HDF5 files, and the attributes of /, /case and /summary; provenance apart. Rows are compared byte by byte,
/// so a NaN equals itself. Rows of one time belong together: where two runs wrote at other intervals, the dataset of the times differs, and
/// the others of its group only if they do at a time that both have. Cracks are compared in order. \throw FileError
Comparison compare_files(const std::string& a, const std::string& b);

}  // namespace voussoir::io
