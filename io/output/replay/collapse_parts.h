// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "io/output/replay/frame_reader.h"

/// The mechanism of a quasi-static analysis: parts that move as one from the largest load factor on (io/MEASURES.md).
namespace voussoir::io {

struct CollapseParts {
  std::uint64_t from = 0, to = 0;  // frames between which motion was compared
  std::vector<std::int32_t> part;  // by element: least element of its part; −1: does not move
};

/// Finds the parts. \param mass  kg, by element; 0: fixed \param peak  s, of the largest load factor: motion is taken from the frame at or
/// after it, at the latest the last one. If there is no later frame, or nothing moves later, motion until then is taken instead
CollapseParts collapse_parts(const Hdf5File& run, const FrameReader& frames, const std::vector<double>& mass, double peak);

}  // namespace voussoir::io
