// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/frame_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/errors.h"

namespace voussoir::io {

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
  std::vector<double> values(elements() * width);
  run_.read_rows(std::string("/frames/") + name, Hdf5Type::f64, frame, 1, values.data());
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    throw FileError(run_.path(), "/frames/" + std::string(name) + ": row " + std::to_string(frame) + " holds a value that is no number");
  return values;
}

}  // namespace voussoir::io
