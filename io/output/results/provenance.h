// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Program, machine and time of a run. Contains no names of hosts or users, and no paths.
namespace voussoir::io {

class Hdf5File;

struct Provenance {
  std::string version, compiler, flags;  // of this program
  std::string cpu;                       // model name, "unknown" if not available
  int cores = 0;                         // logical, of the machine
  int threads = 0;                       // of the run
  std::string started, ended;            // ISO 8601, UTC; ended is empty before the end
  double wall_clock = 0;                 // s
};

/// Version as "0.1.0 (physics 8)": the second number increases whenever the same input gives other numbers.
std::string program_version();

/// Writes /provenance. \param wall_clock  s, of this process so far
void write_provenance(Hdf5File& file, const Provenance& p, double wall_clock);

/// Provenance of this program on this machine, with `started` set to now.
Provenance provenance(int threads);

/// The current time as 2026-01-31T12:34:56Z.
std::string utc_now();

/// Removes every word that contains a path from a list of flags.
std::string without_paths(const std::string& flags);

}  // namespace voussoir::io
