// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The time step of a file of two columns.
namespace voussoir::io {

struct CsvRow {
  double time, value;
  long line;
  int decimals;  // decimals with which the time is written
};

/// Number of decimals: 3 for "0.005", 5 for "1.25e-3".
int decimals_of(std::string_view number);

/// The time step of the rows [s]: steps equal to a millionth, or one step for which each time is right to half a unit of its last decimal.
/// Where several steps fit the rounded times, `stated` is taken if it is one of them, else a whole number of samples per second or of
/// milliseconds.
/// \param must_be_stated  refuse a step other than `stated`, which the file itself states
/// \throw FileError with the line
double csv_step(const std::string& path, const std::vector<CsvRow>& rows, std::optional<double> stated, bool must_be_stated);

}  // namespace voussoir::io
