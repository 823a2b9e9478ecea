// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cases/motion.h"
#include "io/input/motion/spectra/spectra.h"

/// The elastic spectrum that a capacity is compared with.
namespace voussoir::io {

/// Of EN 1998-1, of a table, or of a record.
struct DemandSpectrum {
  TargetSpectrum target;                      // without a record
  std::optional<cases::Accelerogram> record;  // in place of the target
  double damping = 0.05;                      // of critical: of the elastic structure; a table holds values for it
  double corner = 0.0;                        // s, T_C: below it an inelastic structure moves farther than an elastic one
  std::string name;                           // "ec8:1:B:0.25g", name of a file
};

/// Spectral pseudo-acceleration S_e [m/s2] at a period [s] and a damping (of critical). EN 1998-1: by its own equations; a table: times
/// damping_factor(damping) / damping_factor(its own); a record: computed. Nothing outside the range of EN 1998-1 (0 to 4 s), of the table,
/// or at periods below three steps of the record, which does not resolve them.
std::optional<double> acceleration_at(const DemandSpectrum& d, double period, double damping);
/// At its own damping.
inline std::optional<double> acceleration_at(const DemandSpectrum& d, double period) { return acceleration_at(d, period, d.damping); }
/// Spectral displacement [m]: acceleration_at (T/2π)².
std::optional<double> displacement_at(const DemandSpectrum& d, double period, double damping);

/// The file that the words of read_demand name; empty: none.
std::string demand_file(const std::string& words);

/// A spectrum from words: "ec8:TYPE:GROUND:AG", "record:FILE" (one component of a file of any format of ground motion, as FILE#NAME where
/// it has several), or a file of periods and accelerations (read_target). \param corner  T_C [s]; none: that of EN 1998-1 \param unit  of a
/// file that does not state it \param option  that names it, for faults \throw cases::InputError at the option, also where T_C is not
/// known, or given for EN 1998-1; FileError
DemandSpectrum read_demand(const std::string& words, double damping, std::optional<double> corner, const std::optional<std::string>& unit,
                           const std::string& option);

}  // namespace voussoir::io
