// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

/// `voussoir compare`: are two results the same, bit for bit?
namespace voussoir::io {

/// Where two files part.
struct Difference {
  std::string dataset;
  std::string what;            // "row 12", "other shapes", "only in A"
  std::optional<double> time;  // s, of the row
};

/// What compare_files found. Nothing but `differing` = 0: the same bits.
struct Comparison {
  std::size_t datasets = 0, differing = 0;
  std::optional<Difference> first;  // the earliest in time; else the first by name
};

/// Compares every dataset of two HDF5 files, and the attributes of /case and /summary; provenance apart. Rows are compared byte by byte, so
/// a NaN equals itself. \throw FileError
Comparison compare_files(const std::string& a, const std::string& b);

/// Says on standard output whether two runs are the same; if not, where they part, and their measures side by side
/// (compared_measures.h).
/// \param a, b  folders of runs, or files. \param json  one object for programs: identical, datasets, differing, first, measures (always;
/// null if a file is no run). \return 0: the same; 1: not \throw FileError
int compare_command(const std::string& a, const std::string& b, bool json = false);

}  // namespace voussoir::io
