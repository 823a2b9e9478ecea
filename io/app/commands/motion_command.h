// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cases/tables/motion.h"

/// `voussoir motion FILE...`: intensity figures and spectra of records.
namespace voussoir::io {

struct MotionOptions {
  std::optional<std::string> spectra;    // CSV file for response spectra
  std::vector<double> damping{0.02};     // of critical, for the spectra
  std::optional<double> until;           // s; only the first seconds are used, for all output; applied before `treatment`
  cases::MotionTreatment treatment;      // as in a case; for all output
  std::optional<std::string> unit;       // "g", "m/s2", "cm/s2": for formats without a unit
  std::optional<double> dt;              // s: for formats without a time step
  bool combine = false;                  // also spectra and fits of the two horizontal components combined
  std::vector<double> periods;           // s, of Sa: if not empty, the measures of motion.intensity are printed, too
  std::optional<std::string> target;     // spectrum for comparison, see read_target
  std::array<double, 2> fit{0.05, 1.0};  // s, periods of the comparison
  std::optional<std::string> write;      // folder for the record as CSV files with record.toml; for a single record
  bool overwrite = false;                // existing files may be replaced
  bool json = false;                     // the figures as one JSON array instead of a table
};

/// Prints a table with one line per component; the last column is the peak acceleration stated by the file's header. Each argument is
/// "bam-like", "bam-like#7", a folder that holds record.toml, a file, or FILE#COMPONENT. Spectra, combinations and fits: motion_spectra.h.
///
/// \return 0 \throw cases::InputError, FileError; faults of the input before anything is printed or written
int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o, std::ostream& out);

/// Prints to standard output.
int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o);

}  // namespace voussoir::io
