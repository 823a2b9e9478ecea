// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cases/case.h"

/// `voussoir motion FILE...`: what engineers ask of a record.
namespace voussoir::io {

struct MotionOptions {
  std::optional<std::string> spectra;  // CSV file of response spectra to write
  std::vector<double> damping{0.02};   // of critical, for the spectra
  std::optional<double> until;         // s; only the first seconds count, in the table, the spectra and what is written; before `treatment`
  cases::MotionTreatment treatment;    // as in a case; of all that is printed and written
  std::optional<std::string> unit;     // "g", "m/s2", "cm/s2": where a format does not say
  std::optional<double> dt;            // s: where a format does not say
  bool combine = false;                // the two horizontal components together, too, in spectra and fits
  std::vector<double> periods;         // s, of Sa: the measures of motion.intensity are printed, too, if there are some
  std::optional<std::string> target;   // spectrum to compare with, see read_target
  std::array<double, 2> fit{0.05, 1.0};  // s, periods over which it is compared
  std::optional<std::string> write;      // folder to write the record to, as CSV files with record.toml; takes a single record
  bool overwrite = false;                // of existing files
};

/// Prints a table with one line per component; its last column is the peak acceleration that the file's header states. Each argument is
/// "bam-like", "bam-like#7", a folder that holds record.toml, a file, or FILE#COMPONENT. Spectra, combinations and
/// fits: motion_spectra.h. \return 0. \throw cases::InputError, FileError; before anything
/// is printed or written if it is a fault of the input.
int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o, std::ostream& out);

/// The same, to standard output.
int motion_command(const std::vector<std::string>& arguments, const MotionOptions& o);

}  // namespace voussoir::io
