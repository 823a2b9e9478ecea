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

#include "cases/forward.h"
#include "io/output/assess/crack_list.h"
#include "io/output/assess/wall_cracks.h"

/// Engineering figures of a run, computed from its results; definitions in io/MEASURES.md.
namespace voussoir::io {

/// The value of largest magnitude, with its sign, and its time. NaN values are ignored.
struct Peak {
  double value = 0, time = 0;  // s
  void take(double v, double t) {
    if (std::abs(v) > std::abs(value)) value = v, time = t;
  }
};

struct WallAssessment {
  std::string name;
  double thickness = 0;         // m
  Peak out_of_plane;            // greatest displacement against the wall's foot of any piece of about half a metre, over the thickness
  double out_of_plane_now = 0;  // out_of_plane at the assessed frame
  CrackFigures cracks;          // at the assessed frame
  std::size_t parted = 0;       // number of joints wider than any crack, at the assessed frame
  CrackFigures seats;           // slips of timber on the wall, at the assessed frame
};

/// Horizontal displacement of a level relative to the one below, over their difference in height: a ratio.
struct StoreyDrift {
  std::int32_t house = 0;
  double low = 0, high = 0;  // m, Building::height_of
  std::array<Peak, 2> peak;  // x, y
  std::array<double, 2> now{};
};

struct CutAssessment {
  std::string name;
  Vec3 normal;  // unit
  // Largest magnitudes: tension; shear across the normal; moment in the plane, and about the normal (torsion).
  Peak axial, shear, bending, torsion;  // N, N m
  Peak compression;                     // largest compression, as a negative tension
};

struct Assessment {
  double time = 0;    // s, time of the assessed frame
  double weight = 0;  // N, of all elements that are not fixed
  Peak base_shear;    // N, horizontal: peak_base_shear; its time is that of the largest row of /forces
  double base_shear_over_weight = 0;
  std::vector<WallAssessment> walls;
  std::vector<std::pair<OpeningCorner, CrackFigures>> corners;  // their z: Building::height_of
  std::vector<StoreyDrift> storeys;
  std::vector<CutAssessment> cuts;
  // At the assessed frame, for crack maps.
  std::vector<JointWidth> joints;
  std::vector<std::uint8_t> fallen;
  std::vector<Crack> cracks;  // the widest first
};

/// Assesses a run at one frame.
/// \param c  the case of the run \param time  of the frame, nearest one taken [s]; none: the last frame
/// \param levels  heights of storeys, Building::height_of [m]; none: feet and tops of the walls of each storey
/// \throw FileError
Assessment assess(const Hdf5File& run, const cases::Case& c, const Building& building, std::optional<double> time,
                  const std::vector<double>& levels);

}  // namespace voussoir::io
