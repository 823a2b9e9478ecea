// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace voussoir::io {

struct AssessOptions {
  std::string folder;                 // of the run
  std::optional<double> time;         // s, of cracks and of what is "now"; none: the last frame
  std::vector<double> levels;         // m above the base, of storeys; none: foot and top of the walls
  std::vector<double> damping{0.05};  // of the spectra
  std::string maps, spectra;          // folder of crack maps; CSV file; empty: none
  bool json = false, overwrite = false;
};

/// `voussoir assess`: what engineers read off a run (io/MEASURES.md), crack maps of its walls, floor response spectra.
/// \throw cases::InputError, FileError
int assess_command(const AssessOptions& o);

}  // namespace voussoir::io
