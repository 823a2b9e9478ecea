// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_table.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace voussoir::io {

void put(Cells& cells, const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  cells.emplace_back(text);
}

BenchTable::BenchTable(Cells header, Output file) : header_(std::move(header)), file_(std::move(file)) {
  if (file_.path.empty()) return;
  write(header_);
  file_.overwrite = true;  // the file is this table's own now
}

void BenchTable::add(const Cells& cells) {
  print(cells);
  if (!file_.path.empty()) write(cells);
}

void BenchTable::print(const Cells& cells) const {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::printf("%*s ", static_cast<int>(std::max<std::size_t>(8, header_[k].size())), cells[k].empty() ? "-" : cells[k].c_str());
  }
  std::printf("\n");
}

void BenchTable::write(const Cells& cells) {
  text_ += cells.front();
  for (std::size_t k = 1; k < cells.size(); ++k) text_ += ',' + cells[k];
  text_ += '\n';
  write_output(file_, text_);  // after each row, so that a stopped bench keeps its rows
}

}  // namespace voussoir::io
