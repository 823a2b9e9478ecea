// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/output/assess/crack_list.h"
#include "io/output/assess/wall_cracks.h"

/// The crack map of a wall: its elevation from outside, cracks by width, a legend and a scale bar, as SVG.
namespace voussoir::io {

/// Classes of width by Burland, Broms and de Mello (1977) and BRE Digest 251: closed again or invisible, hair cracks, then the upper bounds
/// of very slight (1 mm), slight (5 mm), moderate (15 mm) and severe damage (25 mm).
struct CrackClass {
  double from;  // m
  const char *words, *colour;
  double stroke;  // user units
};
inline constexpr std::array<CrackClass, 6> kCrackClasses{{{0.0, "under 0.1 mm", "#8d979f", 0.9},
                                                          {0.1e-3, "0.1 to 1 mm", "#2f7fd0", 1.7},
                                                          {1e-3, "1 to 5 mm", "#0b3d91", 2.6},
                                                          {5e-3, "5 to 15 mm", "#e08a00", 3.4},
                                                          {15e-3, "15 to 25 mm", "#d62828", 4.4},
                                                          {25e-3, "over 25 mm", "#6d0a1f", 5.6}}};

/// The crack map of wall `wall` as an SVG document.
/// \param joints  of the whole run at this time (joint_widths) \param fallen  by element, 1: fallen
/// \param cracks  of the whole run then (cracks_of), of which the widest of this wall have their numbers, counted from 1
/// \throw FileError
std::string crack_map(const Hdf5File& run, const std::string& title, const Building& building, std::int32_t wall, double time,
                      const std::vector<JointWidth>& joints, const std::vector<std::uint8_t>& fallen, const std::vector<Crack>& cracks);

}  // namespace voussoir::io
