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

/// \param a, b  folders of runs, or files. \return 0: the same; 1: not, and standard output says where they part \throw FileError
int compare_command(const std::string& a, const std::string& b);

}  // namespace voussoir::io
