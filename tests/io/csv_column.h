// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "tests/io/shell.h"

namespace csv {

/// Column of the table in a file, a value a row.
/// \pre no value has a comma
inline std::vector<std::string> column(const std::string& table, const std::string& name) {
  std::istringstream lines(shell::text_of(table));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  std::vector<std::string> values;
  for (std::size_t c = 0; !rows.empty() && c < rows[0].size(); ++c) {
    for (std::size_t r = 1; rows[0][c] == name && r < rows.size(); ++r) values.push_back(rows[r].at(c));
  }
  return values;
}

}  // namespace csv
