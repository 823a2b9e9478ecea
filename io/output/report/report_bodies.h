// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// The mechanism (io/output/measures/debris/bodies.h) in the form of the report page.
struct ReportBodies {
  /// JSON: names: texts; bodies: for each frame pairs of a body's id and the index of its name; hinges: for each frame ten numbers per
  /// hinge: its ends [m] in the reference configuration, then the two elements that each end follows.
  std::string json;
  std::vector<std::uint8_t> id;  // of each element, frame by frame; 0: no body
};

/// Finds the bodies of all frames of the reader. \throw FileError
ReportBodies report_bodies(const Hdf5File& run, const FrameReader& frames);

}  // namespace voussoir::io
