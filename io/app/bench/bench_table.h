// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace voussoir::io {

/// Text by column; what has not been measured is empty.
using Cells = std::vector<std::string>;

/// Appends a number; printf's format.
void put(Cells& cells, const char* format, double value);

/// A table of which the screen shows each row as soon as it is there, and a CSV file, if one is wanted, keeps all.
class BenchTable {
 public:
  /// \param path  of the file, which is replaced; empty: none \throw FileError if it cannot be written
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
