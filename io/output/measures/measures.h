// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/output/measures/debris/debris.h"
#include "io/output/measures/point_accelerations.h"

/// Measures of a collapse, from what a run has recorded: its model, its cracks and its frames. The one place for the summary of a run, the
/// report page and studies; definitions and limits: io/MEASURES.md. What "fallen" and "collapsed" mean stands in solver/collapse.h.
namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// Of a time: it never came.
inline constexpr double kNeverReached = -1.0;

struct WallMeasures {
  std::string name;
  double fallen_mass_fraction = 0;                  // of the wall's mass, at the end
  double first_fallen_time = kNeverReached;         // of the first frame in which an element of it has fallen, s
  double quarter_fallen_time = kNeverReached;       // of the first frame in which a quarter of its mass has fallen, s
  double first_open_joint_time = kNeverReached;     // when a joint of it first came open, at or after time zero, s
  double peak_drift = 0;                            // as long as it stood, the largest in magnitude; NaN: never stood
  double residual_drift = 0;                        // at the end; NaN: it does not stand
  double peak_in_plane_drift = 0;                   // as peak_drift, along the wall
  double crack_extent = 0, large_crack_extent = 0;  // at the end: CrackExtent::fine and large
  double opened_extent = 0;                         // CrackExtent::any at the end
  double settling_crack_extent = 0;                 // CrackExtent::fine in the first frame
};

/// A value for each frame.
struct MeasureSeries {
  std::vector<double> time;  // s
  std::vector<std::int64_t> damage_grade;
  std::vector<double> fallen_mass_fraction;
  std::vector<double> free_volume;       // of that in the reference configuration; NaN: there is no room
  std::vector<double> penetration;       // of the deepest pair of bodies, m
  std::vector<std::int64_t> deep_pairs;  // deeper than half a segment
  std::vector<double> drift;             // an entry a wall in each frame; NaN: it does not stand
  std::vector<double> in_plane_drift;    // the same along the wall
};

struct Measures {
  bool collapsed = false;                   // in the last frame
  double fallen_mass_fraction = 0;          // in the last frame
  double first_crack_time = kNeverReached;  // of the first row of /cracks at or after time zero, s
  // What the building's own weight did before the shaking began, and what came after: rows of /cracks before and from time zero.
  std::int64_t settling_cracks = 0, shaking_cracks = 0;
  double settling_first_crack_time = 0;     // s, below 0; NaN: nothing broke before time zero
  std::int64_t settling_damage_grade = -1;  // damage_grade that there was in the first frame already; -1: as damage_grade
  double collapse_time = kNeverReached;     // of the first frame in which the building is collapsed, s
  std::int64_t damage_grade = -1;           // EMS-98, 0 to 5; -1: there are no walls, or no frames
  std::array<double, 5> grade_time{};       // from when on damage was of grade 1, ..., 5 at least, s
  double first_fallen_time = kNeverReached, roof_first_fallen_time = kNeverReached;  // s
  std::string first_fallen_wall;                                                     // empty: none
  double roof_fallen_mass_fraction = 0;                                              // NaN: there is no roof
  Debris debris;                                                                     // in the last frame
  double initial_free_volume = 0;                                                    // m3
  double free_volume = 0, least_free_volume = 0;  // of the initial one: in the last frame, in all; NaN: there is no room
  double peak_drift = 0, residual_drift = 0;      // of all walls the largest magnitude; NaN: there is none
  double peak_in_plane_drift = 0;                 // the same along the walls
  // How deep bodies are in each other: see Interpenetration. In the last frame, and at the worst over all frames.
  double penetration = 0, base_penetration = 0;            // m: of any two elements or an element and the base; of elements in the base
  double peak_penetration = 0, peak_base_penetration = 0;  // m
  double peak_penetration_time = kNeverReached;            // s
  std::string peak_penetration_pair;                       // empty: none
  std::int64_t deep_pairs = -1, most_deep_pairs = -1;      // -1: not known
  double most_deep_pairs_time = kNeverReached;             // of the first such frame, s
  std::int64_t touching_pairs = 0;                         // in the last frame
  std::vector<WallMeasures> walls;
  MeasureSeries series;
  PointAccelerations accelerations;
};

/// \throw FileError
Measures measure(const Hdf5File& run);

}  // namespace voussoir::io
