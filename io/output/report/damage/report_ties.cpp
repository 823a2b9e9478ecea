// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/report/damage/report_ties.h"

#include <cstdint>
#include <limits>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

std::vector<float> tie_ends_of_life(const Hdf5File& run) {
  const std::uint64_t ties = run.shape("/model/tie")[0];
  std::vector<float> end(ties, std::numeric_limits<float>::infinity());
  const std::uint64_t rows = run.exists("/ties/broken") ? run.shape("/ties/broken")[0] : 0;
  if (rows == 0 || run.shape("/ties/broken") != Shape{rows, ties} || run.shape("/history/time") != Shape{rows}) return end;
  std::vector<std::uint8_t> row(ties);
  const auto is_broken = [&](std::uint64_t at, std::size_t tie) {
    run.read_rows("/ties/broken", Hdf5Type::u8, at, 1, row.data());
    return row[tie] != 0;
  };
  for (std::size_t i = 0; i < ties; ++i) {
    if (!is_broken(rows - 1, i)) continue;
    std::uint64_t low = 0, high = rows - 1;  // a broken tie stays broken
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      is_broken(middle, i) ? high = middle : low = middle + 1;
    }
    double time = 0.0;
    run.read_rows("/history/time", Hdf5Type::f64, low, 1, &time);
    end[i] = static_cast<float>(time);
  }
  return end;
}

}  // namespace voussoir::io
