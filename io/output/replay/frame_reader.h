// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/vec3.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

/// The origin that the coordinates of a run are relative to [m], in the axes of its case file; zero for runs that do not state one. \throw
/// FileError
Vec3 origin_of_run(const Hdf5File& run);

/// Reads /frames of a run, one frame after the other, and refuses values that are NaN. For use by one thread.
class FrameReader {
 public:
  /// \param run  must outlive the reader \param every  interval of the frames given: the first, every `every`-th after it, and the last
  explicit FrameReader(const Hdf5File& run, std::uint64_t every = 1);

  [[nodiscard]] std::uint64_t elements() const noexcept { return start_.size() / 3; }
  [[nodiscard]] std::uint64_t frames() const noexcept { return times_.size(); }
  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }  // s
  [[nodiscard]] std::uint64_t every() const noexcept { return every_; }
  /// Centroids in the reference configuration [m], three values per element.
  [[nodiscard]] const std::vector<double>& start() const noexcept { return start_; }

  /// Displacements of the centroids from the reference configuration [m], three values per element. Layouts before 5 held positions.
  /// \throw FileError
  [[nodiscard]] std::vector<double> displacement(std::uint64_t frame) const;
  /// Positions of the centroids relative to the run's origin [m], three values per element. \throw FileError
  [[nodiscard]] std::vector<double> position(std::uint64_t frame) const;
  /// Values of /frames/NAME, `width` per element. \throw FileError for NaN
  [[nodiscard]] std::vector<double> row(const char* name, std::uint64_t frame, std::uint64_t width) const;

 private:
  /// Buffered frames of one dataset.
  struct Block {
    std::uint64_t first = 0, frames = 0;
    std::vector<double> values;
  };
  [[nodiscard]] bool holds_positions() const noexcept;
  void read_block(const std::string& dataset, std::uint64_t frame, std::uint64_t row, Block& block) const;

  const Hdf5File& run_;
  std::uint64_t every_, last_row_;  // in frames of the run
  const char* moved_;               // name of the dataset that says where the centroids are
  std::vector<double> start_, times_;
  mutable std::map<std::string, Block> blocks_;  // by dataset name
};

}  // namespace voussoir::io
