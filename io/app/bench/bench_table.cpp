// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/bench/bench_table.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "io/input/files/errors.h"

namespace voussoir::io {

void put(Cells& cells, const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  cells.emplace_back(text);
}

BenchTable::BenchTable(Cells header, const std::string& path) : header_(std::move(header)) {
  if (path.empty()) return;
  file_.open(path);
  if (!file_) throw FileError(path, "cannot be written");
  write(header_);
}

void BenchTable::add(const Cells& cells) {
  print(cells);
  if (file_.is_open()) write(cells);
}

void BenchTable::print(const Cells& cells) const {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::printf("%*s ", static_cast<int>(std::max<std::size_t>(8, header_[k].size())), cells[k].empty() ? "-" : cells[k].c_str());
  }
  std::printf("\n");
}

void BenchTable::write(const Cells& cells) {
  file_ << cells.front();
  for (std::size_t k = 1; k < cells.size(); ++k) file_ << ',' << cells[k];
  file_ << std::endl;  // flushed at once, so that a stopped bench keeps its rows
}

}  // namespace voussoir::io
