// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// The mechanism (measures/bodies.h) as the page has it.
struct ReportBodies {
  /// JSON: names: texts; bodies: for each frame pairs of a body's id and the place of its name; hinges: for each frame ten numbers a hinge:
  /// its ends, m, in the reference configuration, then the two elements that each end goes with.
  std::string json;
  std::vector<std::uint8_t> id;  // of each element in one frame after the other; 0: of no body
};

/// \throw FileError
ReportBodies report_bodies(const Hdf5File& run, const FrameReader& frames);

}  // namespace voussoir::io
