// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// JSON that may stand inside a script element: nothing in it can end the element. \param json  dumped
std::string safe_json(const std::string& json);

/// What the report page says of a run in words and curves.
struct ReportFacts {
  /// JSON that may stand in a script element: title; motion (direction, record, scale, peak: of the ground's acceleration along x, y, z,
  /// m/s²); ground: where it is in each frame, x, y, z, m (absent without a motion); summary; measures; provenance; times, s; base: its
  /// height, m, or null; parts and materials: names; walls (name, box, across, outward as in measures/building.h); rooms (low, high:
  /// corners, m).
  std::string json;
  /// JSON of the plots, a list. A plot has title, unit, t (s) and curves (name, y); "stack": true where curves add up, but for the last,
  /// which is their sum seen from the other side; "clip": beyond that value, to either side, nothing is drawn. Missing values are null.
  std::string plots;
  std::vector<std::int32_t> part, material;  // of each element: into names of parts, of materials
};

/// \param quantum  of the positions in the page [m] \throw FileError
ReportFacts report_facts(const Hdf5File& run, const FrameReader& frames, double quantum);

}  // namespace voussoir::io
