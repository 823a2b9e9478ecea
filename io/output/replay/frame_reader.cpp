// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/frame_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/input/files/errors.h"

namespace voussoir::io {
namespace {

constexpr const char* kPosition = "position";  // of layouts before 5
constexpr std::uint64_t kBlock = 8U << 20;     // bytes of one dataset in memory

}  // namespace

Vec3 origin_of_run(const Hdf5File& run) {
  if (!run.exists("/model/origin")) return {};
  const auto at = run.read<double>("/model/origin");
  if (at.size() != 3) throw FileError(run.path(), "/model/origin is no point");
  return {at[0], at[1], at[2]};
}

FrameReader::FrameReader(const Hdf5File& run, std::uint64_t every)
    : run_(run),
      every_(every),
      moved_(run.exists("/frames/displacement") ? "displacement" : kPosition),
      start_(run.read<double>("/model/element/position0")) {
  const std::vector<double> all = run.read<double>("/frames/time");
  const std::uint64_t n = elements(), rows = all.size();
  if (start_.size() != 3 * n || run.shape(std::string("/frames/") + moved_) != Shape{rows, n, 3} ||
      run.shape("/frames/quaternion") != Shape{rows, n, 4} || run.shape("/frames/broken") != Shape{rows, n})
    throw FileError(run.path(), "/frames does not fit /model/element");
  last_row_ = rows - std::min<std::uint64_t>(rows, 1);
  for (std::uint64_t row = 0; row < rows; row += every_) times_.push_back(all[row]);
  if (rows > 0 && last_row_ % every_ != 0) times_.push_back(all[last_row_]);
}

bool FrameReader::holds_positions() const noexcept { return moved_ == kPosition; }

std::vector<double> FrameReader::displacement(std::uint64_t frame) const {
  std::vector<double> u = row(moved_, frame, 3);
  if (holds_positions()) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] -= start_[i];
  }
  return u;
}

std::vector<double> FrameReader::position(std::uint64_t frame) const {
  std::vector<double> x = row(moved_, frame, 3);
  if (!holds_positions()) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += start_[i];
  }
  return x;
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

// Reads many frames at a time, since every read of an unmerged run opens all its parts.
void FrameReader::read_block(const std::string& dataset, std::uint64_t frame, std::uint64_t row, Block& block) const {
  block.frames = 0;  // empty if the read fails
  const std::uint64_t fit = every_ > 1 ? 1 : std::max<std::uint64_t>(1, kBlock / std::max<std::uint64_t>(1, row * sizeof(double)));
  const std::uint64_t count = std::min(fit, frames() - frame);
  block.values.resize(count * row);
  run_.read_rows(dataset, Hdf5Type::f64, std::min(frame * every_, last_row_), count, block.values.data());
  block.first = frame, block.frames = count;
}

}  // namespace voussoir::io
