// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// JSON that can be embedded in a script element, as nothing in it ends the element. \param json  serialised
std::string safe_json(const std::string& json);

/// Facts and curves of a run for the report page.
struct ReportFacts {
  /// JSON for a script element: title; motion (direction, record, scale, peak: of the ground's acceleration along x, y, z, m/s²); ground:
  /// its position in each frame, x, y, z, m (absent without a motion); worst: where the page opens (worst_moment.h); summary; measures;
  /// provenance; times, s; base: its height, m, or null; parts and materials: names; walls (name, box, across, outward as in
  /// io/output/measures/building/building.h); rooms (low, high: corners, m).
  std::string json;
  /// JSON list of the plots. A plot has title, unit, t (s) and curves (name, y); "stack": true if curves are stacked, except for the last,
  /// which is the input and equals the sum of the others; "clip": magnitude beyond which nothing is drawn. Missing values are null.
  std::string plots;
  std::vector<std::int32_t> part, material;  // by element: indices into the names of parts and of materials
};

/// \param quantum  of the positions in the page [m] \throw FileError
ReportFacts report_facts(const Hdf5File& run, const FrameReader& frames, double quantum);

}  // namespace voussoir::io
