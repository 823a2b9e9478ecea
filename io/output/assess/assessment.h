// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/output/assess/wall_cracks.h"

/// What engineers read off a run, from its results after the fact: definitions in io/MEASURES.md.
namespace voussoir::io {

/// A largest magnitude, with its sign, and when. A value that is no number does not count.
struct Peak {
  double value = 0, time = 0;  // s
  void take(double v, double t) {
    if (std::abs(v) > std::abs(value)) value = v, time = t;
  }
};

struct WallAssessment {
  std::string name;
  double thickness = 0;         // m
  Peak out_of_plane;            // of the piece of about half a metre displaced most against the wall's foot, over the thickness
  double out_of_plane_now = 0;  // the same at the moment looked at
  CrackFigures cracks;          // at the moment looked at
  std::size_t parted = 0;       // joints that are wider than any crack then
  CrackFigures seats;           // slips of timber on the wall then
};

/// Horizontal displacement of a level against the one below it, over their height: a ratio.
struct StoreyDrift {
  std::int32_t house = 0;
  double low = 0, high = 0;  // z, m
  std::array<Peak, 2> peak;  // x, y
  std::array<double, 2> now{};
};

struct CutAssessment {
  std::string name;
  Vec3 normal;  // unit
  // Largest in magnitude: tension; shear across the normal; moment in the plane, and about the normal (torsion).
  Peak axial, shear, bending, torsion;  // N, N m
  Peak compression;                     // largest, as a negative tension
};

struct Assessment {
  double time = 0;    // s, of the frame looked at
  double weight = 0;  // N, of all elements that are not fixed
  Peak base_shear;    // N, horizontal, of the rows of /forces
  double base_shear_over_weight = 0;
  std::vector<WallAssessment> walls;
  std::vector<std::pair<OpeningCorner, CrackFigures>> corners;
  std::vector<StoreyDrift> storeys;
  std::vector<CutAssessment> cuts;
  // Of the frame looked at, for crack maps.
  std::vector<JointWidth> joints;
  std::vector<std::uint8_t> fallen;
};

/// \param c  the case of the run \param time  of the frame nearest to it [s]; none: the last \param levels  heights of storeys above the
/// base [m], none: the walls' foot and top \throw FileError
Assessment assess(const Hdf5File& run, const cases::Case& c, const Building& building, std::optional<double> time,
                  const std::vector<double>& levels);

}  // namespace voussoir::io
