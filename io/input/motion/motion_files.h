// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cases/forward.h"
#include "cases/motion.h"
#include "cases/tables/motion.h"
#include "io/input/motion/formats/read_motion.h"
#include "io/input/motion/synthetic/built_in_record.h"

/// Loads the ground motion described by a case.
namespace voussoir::io {

/// Reads the folder's record.toml: L, T and V name files in the folder (at least one), optional name, unit and dt (for formats that do not
/// state them; else `unstated` applies). \throw FileError
Record read_record_folder(const std::string& folder, const Unstated& unstated);

/// Reads a file with three components marked as L, T and V (BHRC V1, GeoNet V2A). \throw FileError
Record read_record_file(const std::string& path, const Unstated& unstated);

/// Writes L.csv, T.csv, V.csv (t [s], a [m/s2]) and record.toml into the folder, which is created if missing.
/// \throw FileError; if one of the files exists and `overwrite` is false, before anything is written.
void write_record_folder(const Record& record, const std::string& folder, bool overwrite);

/// The component of the record that shakes along an axis (0: x, 1: y, 2: z): 0 L, 1 T, 2 V, or the axis itself if files are given for x, y,
/// z.
std::size_t component_along(const cases::Motion& motion, std::size_t axis);

/// The motion on x, y, z in m/s2: cut, corrected and tapered (io/input/motion/treatment.h), scaled, scaled again to the required intensity
/// (of L and T, or of x and y: io/input/motion/spectra/intensity.h), and rotated to the direction. Relative paths start at `case_folder`
/// (empty: the working folder). \throw cases::InputError with the key (motion, or motion.record, direction, unit, dt, scale, intensity,
/// from, to, taper, baseline); FileError.
cases::GroundMotion load_motion(const cases::Motion& motion, const std::string& case_folder);

/// The ground motion of a case: none if it has no [motion], or if its [analysis] does not use it. \throw as load_motion
cases::GroundMotion ground_motion(const cases::Case& c);

/// Text with one line for each moving axis, with its peaks, and one line on the treatment of the record, if any. Empty if nothing moves.
/// \param applied  result of ground_motion
std::string motion_lines(const cases::Case& c, const cases::GroundMotion& applied);

/// Treatment of a record in words: "from 27 to 47 s, multiplied by 0.4716 to reach PGA = 3 m/s2"; empty: as recorded, except for `scale`.
/// \param factor  GroundMotion::factor
std::string done_to_record(const cases::Motion& motion, const std::array<double, 3>& factor);

}  // namespace voussoir::io
