// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/input/files/output_path.h"

namespace voussoir::io {

/// Text by column; empty where nothing was measured.
using Cells = std::vector<std::string>;

/// Appends a number in a printf format.
void put(Cells& cells, const char* format, double value);

/// A table printed row by row, and, if requested, also written to a CSV file, whole after each row.
class BenchTable {
 public:
  /// \param file  the CSV file; without a path none \throw FileError if it cannot be written
  BenchTable(Cells header, Output file);

  void print_header() const { print(header_); }
  void add(const Cells& cells);

 private:
  void print(const Cells& cells) const;
  void write(const Cells& cells);

  Cells header_;
  Output file_;
  std::string text_;  // of the file
};

}  // namespace voussoir::io
