// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Which program, on what machine, when. Nothing here says whose machine it is: no names of hosts or users, no paths.
namespace voussoir::io {

struct Provenance {
  std::string version, compiler, flags;  // of this program
  std::string cpu;                       // model name, "unknown" if the system does not say
  int cores = 0;                         // logical, of the machine
  int threads = 0;                       // of the run
  std::string started, ended;            // ISO 8601, UTC; ended is empty until then
  double wall_clock = 0;                 // s
};

/// "0.1.0 (physics 8)": the second number rises whenever the same input gives other numbers.
std::string program_version();

/// This program on this machine, started now.
Provenance provenance(int threads);

/// Now, as 2026-01-31T12:34:56Z.
std::string utc_now();

/// Drops every word that holds a path from a list of flags.
std::string without_paths(const std::string& flags);

}  // namespace voussoir::io
