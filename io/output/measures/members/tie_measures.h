// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

/// Greatest forces of rods, and of the bars of decks and meshes, over a run (io/MEASURES.md).
namespace voussoir::io {

class Hdf5File;

/// One separate tie, or all bars of one deck or mesh.
struct TieMeasures {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string name;
  double bars = 0;             // 0: a tie; else of a deck or mesh: each figure is that of its bar in which it is largest in magnitude
  double peak_force = 0;       // N, largest in magnitude; tension is positive
  double peak_time = 0;        // s, of it
  double peak_elongation = 0;  // m, largest in magnitude
  double plastic = kNone;      // m, plastic elongation at the end; NaN for a group
  double utilisation = kNone;  // largest force over yield force; NaN: elastic, or a run of an earlier version, which does not tell
  double yielded = 0;          // at the end, of a tie 0 or 1: ties or bars that have yielded and hold
  double broken = 0;           // likewise, that have broken
};

/// Measures of all ties of a run, then of its decks and meshes; empty for a run without rows of them. \throw FileError
std::vector<TieMeasures> tie_measures(const Hdf5File& run);

}  // namespace voussoir::io
