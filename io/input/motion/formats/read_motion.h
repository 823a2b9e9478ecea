// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/motion.h"

/// Readers of files of ground motion, one per format.
namespace voussoir::io {

/// Greatest size of a file of ground motion in bytes: an hour at 1 kHz fits.
inline constexpr std::size_t kLargestMotionFile = 64u << 20;

/// Names of units for the user, for messages.
inline constexpr const char* kUnitNames = R"("g", "m/s2" or "cm/s2")";

/// The unit in m/s2 (g = 9.80665); nothing for an unknown name. Spellings as found in headers: "G", "m/s^2", "CM/SEC/SEC", "gal", "mm/s/s".
std::optional<double> acceleration_unit(std::string_view name);

/// Unit and time step for files that do not state them.
struct Unstated {
  std::optional<std::string> unit;  // of acceleration, see acceleration_unit
  std::optional<double> dt;         // s between samples
  Unstated() = default;
  template <class T>
  requires std::convertible_to<T, std::optional<std::string>> Unstated(T&& u, std::optional<double> step = {})
      : unit(std::forward<T>(u)), dt(step) {}
};

/// PEER AT2: NGA-West2, NGA-West1, NGA-East and the older forms. The header states unit, number of values and step.
/// \throw FileError with the line for a header that cannot be understood, a file of velocity or displacement, a value that is missing,
/// glued or not finite, or a count other than the header's.
cases::Accelerogram read_at2(const std::string& path);

/// Two columns, time [s] in equal steps (see csv_step) from any first time, and acceleration, separated by a comma, a semicolon or blanks;
/// lines that start with '#' are comments; one header line, "t [s], a [m/s2]", may precede the data. Or one column, accelerations at steps
/// of `unstated.dt`, optionally under a header "a [m/s2]". `unstated.unit` applies where the header states no unit; a column of times takes
/// precedence over `unstated.dt`. A first row with the number of values and their step, as in SHAKE, must agree with the data.
/// \throw FileError with the line.
cases::Accelerogram read_motion_csv(const std::string& path, const Unstated& unstated);

/// One component of a file, with its description in the file.
struct Channel {
  std::string component;              // name in the file: "L", "N28W", "90 DEG", "HNE"; may be empty
  char axis = 0;                      // 'L', 'T', 'V' where a file of several components states it
  std::optional<double> stated_peak;  // m/s2, absolute value, if stated by the header
  cases::Accelerogram motion;
};

/// Formats of networks. Units, steps and counts are those of the headers. The baseline is unchanged, except for K-NET, whose counts have an
/// arbitrary offset. Memory is bounded by the file's size, whatever its header states.
/// \throw FileError with the line for a header that cannot be understood, a file that ends early or has more data than its header states, a
/// value that is missing or not finite, and for a file without acceleration.
std::vector<Channel> read_bhrc(const std::string& path);    // BHRC (Iran) V1: L, V, T in one file
std::vector<Channel> read_esm(const std::string& path);     // ESM and AFAD, DYNA 1.2 ASCII: one component
std::vector<Channel> read_cosmos(const std::string& path);  // COSMOS V1, V2: channels
std::vector<Channel> read_csmip(const std::string& path);   // CDMG/CSMIP V2, USC V2: channels
std::vector<Channel> read_geonet(const std::string& path);  // GeoNet (New Zealand) V2A: longitudinal, transverse, up
std::vector<Channel> read_knet(const std::string& path);    // NIED K-NET, KiK-net: one component

/// Reads all components of a file of any format, recognised by its first lines; AT2 and CSV also by the extension (.AT2, .csv, .txt).
/// \throw FileError, also for VT2 and DT2 files and unknown formats.
std::vector<Channel> read_motion_file(const std::string& path, const Unstated& unstated);

/// "#1 (90 DEG), #2 (UP)": numbers and names of all components, for messages.
std::string component_list(const std::vector<Channel>& channels);

/// Reads one component: the only one of the file, or the one named by "FILE#NAME" or "FILE#NUMBER", or the one that the file marks as
/// `axis` ('L', 'T', 'V'; 0: none). \throw FileError, also if none or several fit.
Channel read_channel(const std::string& path, const Unstated& unstated, char axis = 0);

/// The motion of read_channel. \throw FileError as read_channel
cases::Accelerogram read_accelerogram(const std::string& path, const Unstated& unstated, char axis = 0);

}  // namespace voussoir::io
