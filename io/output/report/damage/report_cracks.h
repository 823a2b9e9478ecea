// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cases/forward.h"

namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// The cracks that a run leaves, for the report page: those of `voussoir assess` in the last frame.
/// \return JSON: time (s, of the last frame); more: how many cracks are not listed; cracks: wall, length, peak, at_end (m), peak_time (s),
/// along, z (m, from and to: from the wall's left end as seen from outside, and Building::height_of), widths (mm, by frame of the reader); maps:
/// wall and svg (the crack map of each wall with a listed crack). Empty for a run without walls or frames. \throw FileError
std::string report_cracks(const Hdf5File& run, const cases::Case& c, const FrameReader& frames);

}  // namespace voussoir::io
