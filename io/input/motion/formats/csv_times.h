// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Times of a file of two columns: their step.
namespace voussoir::io {

struct CsvRow {
  double time, value;
  long line;
  int decimals;  // that the time is written with
};

/// 3 of "0.005", 5 of "1.25e-3".
int decimals_of(std::string_view number);

/// The step of the rows: equal to a millionth, or one for which each time is right to half a unit of the last decimal written. Where
/// several steps fit rounded times, `stated` is taken if it is one of them, else a whole number of samples a second or of milliseconds.
/// \param must_be_stated the file itself states it: another is refused
/// \throw FileError with the line
double csv_step(const std::string& path, const std::vector<CsvRow>& rows, std::optional<double> stated, bool must_be_stated);

}  // namespace voussoir::io
