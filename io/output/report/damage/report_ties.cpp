// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_ties.h"

#include <cstdint>
#include <limits>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kMostBisected = 64;  // ties whose first broken row is looked for by bisection

}  // namespace

std::vector<float> tie_ends_of_life(const Hdf5File& run) {
  const std::uint64_t ties = run.shape("/model/tie")[0];
  std::vector<float> end(ties, std::numeric_limits<float>::infinity());
  const std::uint64_t rows = run.exists("/ties/broken") ? run.shape("/ties/broken")[0] : 0;
  if (rows == 0 || run.shape("/ties/broken") != Shape{rows, ties} || run.shape("/history/time") != Shape{rows}) return end;
  std::vector<std::uint8_t> row(ties);
  const auto read = [&](std::uint64_t at) { run.read_rows("/ties/broken", Hdf5Type::u8, at, 1, row.data()); };
  read(rows - 1);
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < ties; ++i) {
    if (row[i] != 0) broken.push_back(i);
  }
  const auto breaks_at = [&](std::size_t tie, std::uint64_t at) {
    double time = 0.0;
    run.read_rows("/history/time", Hdf5Type::f64, at, 1, &time);
    end[tie] = static_cast<float>(time);
  };
  if (broken.size() > kMostBisected) {  // each row once
    for (std::uint64_t at = 0; at < rows && !broken.empty(); ++at) {
      read(at);
      std::erase_if(broken, [&](std::size_t tie) { return row[tie] != 0 ? breaks_at(tie, at), true : false; });
    }
    return end;
  }
  for (const std::size_t tie : broken) {
    std::uint64_t low = 0, high = rows - 1;  // a broken tie stays broken
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      read(middle);
      row[tie] != 0 ? high = middle : low = middle + 1;
    }
    breaks_at(tie, low);
  }
  return end;
}

}  // namespace voussoir::io
