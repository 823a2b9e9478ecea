// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/assess/wall_cracks.h"

/// The crack map of a wall, as surveyors draw it: its elevation from outside, cracks by width, a legend and a scale bar, as SVG.
namespace voussoir::io {

/// Classes of width, of Burland, Broms and de Mello (1977) and BRE Digest 251: hair cracks, then the upper bounds of very slight (1 mm),
/// slight (5 mm), moderate (15 mm) and severe damage (25 mm).
struct CrackClass {
  double from;  // m
  const char *words, *colour;
  double stroke;  // user units
};
inline constexpr std::array<CrackClass, 5> kCrackClasses{{{0.1e-3, "0.1 to 1 mm", "#6a8fb5", 0.9},
                                                          {1e-3, "1 to 5 mm", "#2b5fa8", 1.6},
                                                          {5e-3, "5 to 15 mm", "#e08a00", 2.4},
                                                          {15e-3, "15 to 25 mm", "#d62828", 3.4},
                                                          {25e-3, "over 25 mm", "#6d0a1f", 4.6}}};

/// \param joints  of the whole run at this moment (joint_widths) \param fallen  by element, 1: it has fallen
/// \throw FileError
std::string crack_map(const Hdf5File& run, const std::string& title, const Building& building, std::int32_t wall, double time,
                      const std::vector<JointWidth>& joints, const std::vector<std::uint8_t>& fallen);

}  // namespace voussoir::io
