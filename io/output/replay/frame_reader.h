// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

/// /frames of a run, one frame after the other: every value it gives is a number. For one thread.
class FrameReader {
 public:
  /// \param run  outlives the reader \param every  which frames it gives: the first, every so many after it, and the last
  /// \throw FileError if /frames does not fit /model/element
  explicit FrameReader(const Hdf5File& run, std::uint64_t every = 1);

  [[nodiscard]] std::uint64_t elements() const noexcept { return start_.size() / 3; }
  [[nodiscard]] std::uint64_t frames() const noexcept { return times_.size(); }
  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }  // s
  [[nodiscard]] std::uint64_t every() const noexcept { return every_; }
  /// Centroids in the reference configuration, three an element, m.
  [[nodiscard]] const std::vector<double>& start() const noexcept { return start_; }

  /// Of the centroids from the reference configuration, three an element, m. \throw FileError
  [[nodiscard]] std::vector<double> displacement(std::uint64_t frame) const;
  /// `width` values an element of /frames/NAME. \throw FileError for a value that is no number
  [[nodiscard]] std::vector<double> row(const char* name, std::uint64_t frame, std::uint64_t width) const;

 private:
  /// Frames of one dataset that are at hand.
  struct Block {
    std::uint64_t first = 0, frames = 0;
    std::vector<double> values;
  };
  void read_block(const std::string& dataset, std::uint64_t frame, std::uint64_t row, Block& block) const;

  const Hdf5File& run_;
  std::uint64_t every_, last_row_;  // of the frames of the run
  std::vector<double> start_, times_;
  mutable std::map<std::string, Block> blocks_;  // by name of the dataset
};

}  // namespace voussoir::io
