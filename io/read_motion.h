// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cases/motion.h"

/// Readers of one component of ground motion from one file, a format each.
namespace voussoir::io {

/// Largest file of ground motion that is read, bytes: an hour at 1 kHz fits.
inline constexpr std::size_t kLargestMotionFile = 64u << 20;

/// Names of units a user may write, for messages.
inline constexpr const char* kUnitNames = R"("g", "m/s2" or "cm/s2")";

/// What one of the unit is in m/s2 (g = 9.80665); nothing for an unknown name. Spellings as found in headers: "G", "m/s^2", "CM/SEC/SEC",
/// "gal".
std::optional<double> acceleration_unit(std::string_view name);

/// PEER AT2: NGA-West2, NGA-West1, NGA-East and the older forms. The header states unit, number of values and step.
/// \throw FileError with the line for a header that cannot be understood, a file of velocity or displacement, a value that is missing,
/// glued or not finite, or a count other than the header's.
cases::Accelerogram read_at2(const std::string& path);

/// Two columns, time [s] from 0 in equal steps (to 1e-6 of a step) and acceleration, divided by a comma, a semicolon or blanks; lines that
/// start with '#' are comments; before the data may stand one header line, "t [s], a [m/s2]". \param unit holds where the header states
/// none. \throw FileError with the line.
cases::Accelerogram read_motion_csv(const std::string& path, const std::optional<std::string>& unit);

/// By the name's ending (.AT2, .csv, .txt), else by the content. \throw FileError, also for VT2 and DT2 files and unknown formats.
cases::Accelerogram read_accelerogram(const std::string& path, const std::optional<std::string>& unit);

}  // namespace voussoir::io
