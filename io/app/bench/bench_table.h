// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace voussoir::io {

/// Text by column; empty where nothing was measured.
using Cells = std::vector<std::string>;

/// Appends a number in a printf format.
void put(Cells& cells, const char* format, double value);

/// A table printed row by row, and, if requested, also written to a CSV file.
class BenchTable {
 public:
  /// \param path  of the CSV file, which is replaced; empty: none \throw FileError if it cannot be written
  BenchTable(Cells header, const std::string& path);

  void print_header() const { print(header_); }
  void add(const Cells& cells);

 private:
  void print(const Cells& cells) const;
  void write(const Cells& cells);

  Cells header_;
  std::ofstream file_;
};

}  // namespace voussoir::io
