// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "io/output/replay/frame_reader.h"

/// The mechanism of a quasi-static analysis: parts that move as one from the largest load factor on (io/MEASURES.md).
namespace voussoir::io {

struct CollapseParts {
  std::uint64_t from = 0, to = 0;  // frames between which it was looked at
  std::vector<std::int32_t> part;  // of each element the least element of its part; −1: it stands
};

/// \param mass  kg, of each element; none: fixed \param peak  s, of the largest load factor: the frame at it or after it counts; the last
/// one at the latest. Before there is a frame after it, or where nothing moves after it, it is the motion until then
CollapseParts collapse_parts(const Hdf5File& run, const FrameReader& frames, const std::vector<double>& mass, double peak);

}  // namespace voussoir::io
