// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cases/case.h"
#include "cases/motion.h"
#include "io/input/motion/formats/read_motion.h"
#include "io/input/motion/synthetic/built_in_record.h"

/// From what a case says of its ground motion to the motion itself.
namespace voussoir::io {

/// The folder's record.toml: L, T and V name files in it (at least one), optional name, unit and dt (where a format does not say; else
/// `unstated` holds). \throw FileError
Record read_record_folder(const std::string& folder, const Unstated& unstated);

/// A file that holds three components and says which is L, T and V (BHRC V1, GeoNet V2A). \throw FileError
Record read_record_file(const std::string& path, const Unstated& unstated);

/// Writes L.csv, T.csv, V.csv (t [s], a [m/s2]) and record.toml into the folder, which is made if it is missing.
/// \throw FileError, before anything is written if one of the files exists and `overwrite` is false.
void write_record_folder(const Record& record, const std::string& folder, bool overwrite);

/// The motion on x, y, z in m/s2: cut, corrected and tapered (io/input/motion/treatment.h), scaled, brought to the intensity that is asked
/// for (of L and T, or of x and y: io/input/motion/spectra/intensity.h), and turned by the direction. Relative paths start at `case_folder`
/// (empty: the working folder). \throw cases::InputError with the key (motion, or motion.record, direction, unit, dt, scale, intensity,
/// from, to, taper, baseline); FileError.
cases::GroundMotion load_motion(const cases::Motion& motion, const std::string& case_folder);

/// The motion of a case's ground: none if it has no [motion], or if its [analysis] leaves it out. \throw what load_motion throws
cases::GroundMotion ground_motion(const cases::Case& c);

/// A line for each axis that moves, with its peaks, and one that says what was done to the record, if anything was. Empty: nothing moves.
/// \param applied  what ground_motion gave
std::string motion_lines(const cases::Case& c, const cases::GroundMotion& applied);

/// "from 27 to 47 s, multiplied by 0.4716 to reach PGA = 3 m/s2"; empty: as recorded, but for `scale`.
std::string done_to_record(const cases::Motion& motion, double factor);

}  // namespace voussoir::io
