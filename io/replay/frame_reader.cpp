// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/replay/frame_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/files/errors.h"

namespace voussoir::io {
namespace {

constexpr std::uint64_t kBlock = 8U << 20;  // bytes of one dataset in memory

}  // namespace

FrameReader::FrameReader(const Hdf5File& run)
    : run_(run), start_(run.read<double>("/model/element/position0")), times_(run.read<double>("/frames/time")) {
  const std::uint64_t n = elements();
  if (start_.size() != 3 * n || run.shape("/frames/position") != Shape{frames(), n, 3} ||
      run.shape("/frames/quaternion") != Shape{frames(), n, 4} || run.shape("/frames/broken") != Shape{frames(), n})
    throw FileError(run.path(), "/frames does not fit /model/element");
}

std::vector<double> FrameReader::displacement(std::uint64_t frame) const {
  std::vector<double> u = row("position", frame, 3);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] -= start_[i];
  return u;
}

std::vector<double> FrameReader::row(const char* name, std::uint64_t frame, std::uint64_t width) const {
  const std::uint64_t row = elements() * width;
  Block& block = blocks_[name];
  if (frame < block.first || frame >= block.first + block.frames) read_block(std::string("/frames/") + name, frame, row, block);
  const auto first = block.values.begin() + static_cast<std::ptrdiff_t>((frame - block.first) * row);
  std::vector<double> values(first, first + static_cast<std::ptrdiff_t>(row));
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    throw FileError(run_.path(), "/frames/" + std::string(name) + ": row " + std::to_string(frame) + " holds a value that is no number");
  return values;
}

// Many frames at a time: of a run that is not merged yet, every read opens all its parts.
void FrameReader::read_block(const std::string& dataset, std::uint64_t frame, std::uint64_t row, Block& block) const {
  block.frames = 0;  // nothing, should the read fail
  const std::uint64_t fit = std::max<std::uint64_t>(1, kBlock / std::max<std::uint64_t>(1, row * sizeof(double)));
  const std::uint64_t count = std::min(fit, frames() - frame);
  block.values.resize(count * row);
  run_.read_rows(dataset, Hdf5Type::f64, frame, count, block.values.data());
  block.first = frame, block.frames = count;
}

}  // namespace voussoir::io
