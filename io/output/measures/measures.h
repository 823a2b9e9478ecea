// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/output/measures/debris/debris.h"
#include "io/output/measures/members/load_measures.h"
#include "io/output/measures/members/tie_measures.h"
#include "io/output/measures/point_accelerations.h"

/// Measures of a collapse, from the model, the cracks and the frames of a run. The single source for the summary of a run, the report page
/// and studies; definitions and limits: io/MEASURES.md. "Fallen" and "collapsed" are defined in solver/run/collapse.h.
namespace voussoir::io {

class FrameReader;
class Hdf5File;

/// Value of a time that was never reached.
inline constexpr double kNeverReached = -1.0;

struct WallMeasures {
  std::string name;
  double fallen_mass_fraction = 0;                  // of the wall's mass, at the end
  double first_fallen_time = kNeverReached;         // s, first frame in which one of its elements has fallen
  double quarter_fallen_time = kNeverReached;       // s, first frame in which a quarter of its mass has fallen
  double first_open_joint_time = kNeverReached;     // s, first opening of one of its joints, at or after time zero
  double peak_drift = 0;                            // largest magnitude while the wall stood; NaN: never stood
  double residual_drift = 0;                        // at the end; NaN: the wall does not stand
  double peak_in_plane_drift = 0;                   // as peak_drift, along the wall
  double storey = 1;                                // number, from below
  double foot = 0, top = 0;                         // m, of the wall: Building::height_of
  double peak_drift_time = kNeverReached;           // s, of peak_drift
  double peak_gable_drift = 0;                      // as peak_drift, of its gable; NaN: it has none, or that never stood
  double peak_gable_drift_time = kNeverReached;     // s, of it
  double peak_storey_drift = 0;                     // storey_drift of largest magnitude while the wall stood; NaN: never stood
  double peak_storey_drift_time = kNeverReached;    // s, of it
  double residual_storey_drift = 0;                 // at the end; NaN: the wall does not stand
  double peak_seat_slip = 0, seat_slip = 0;         // m, largest of beams and rafters on it (seat_slip.h), at the end; NaN: it bears none
  double crack_extent = 0, large_crack_extent = 0;  // at the end: CrackExtent::fine and large
  double opened_extent = 0;                         // CrackExtent::any at the end
  double settling_crack_extent = 0;                 // CrackExtent::fine in the first frame
};

/// Values by frame.
struct MeasureSeries {
  std::vector<double> time;  // s
  std::vector<std::int64_t> damage_grade;
  std::vector<double> fallen_mass_fraction;
  std::vector<double> free_volume;       // fraction of the initial one; NaN: there is no room
  std::vector<double> penetration;       // m, of the deepest pair of bodies
  std::vector<std::int64_t> deep_pairs;  // pairs deeper than half a segment
  std::vector<double> drift;             // by wall within each frame; NaN: the wall does not stand
  std::vector<double> in_plane_drift;    // likewise, along the wall
  std::vector<double> storey_drift;      // likewise
  std::vector<double> seat_slip;         // m, the largest of all seats that are not lost; NaN: there are none
};

struct Measures {
  bool collapsed = false;                   // in the last frame
  double fallen_mass_fraction = 0;          // in the last frame
  double first_crack_time = kNeverReached;  // s, of the first row of /cracks at or after time zero
  // Cracks due to the building's own weight before the shaking, and cracks afterwards: rows of /cracks before and from time zero.
  std::int64_t settling_cracks = 0, shaking_cracks = 0;
  double settling_first_crack_time = 0;     // s, below 0; NaN: no break before time zero
  std::int64_t settling_damage_grade = -1;  // damage grade in the first frame; -1: as damage_grade
  double collapse_time = kNeverReached;     // s, first frame in which the building is collapsed
  std::int64_t damage_grade = -1;           // EMS-98, 0 to 5; -1: no walls, or no frames
  std::array<double, 5> grade_time{};       // s, time from which damage was of grade 1, ..., 5 or more
  double first_fallen_time = kNeverReached, roof_first_fallen_time = kNeverReached;  // s
  std::string first_fallen_wall;                                                     // empty: none
  double roof_fallen_mass_fraction = 0;                                              // NaN: there is no roof
  Debris debris;                                                                     // in the last frame
  double initial_free_volume = 0;                                                    // m3
  double free_volume = 0, least_free_volume = 0;  // fraction of the initial one: in the last frame, least; NaN: there is no room
  double peak_drift = 0, residual_drift = 0;      // largest magnitude of all walls; NaN: undefined
  double peak_in_plane_drift = 0;                 // likewise, along the walls
  double peak_drift_time = kNeverReached;         // s, of peak_drift
  std::string peak_drift_wall;                    // empty: there is no wall
  double peak_gable_drift = 0;                    // largest magnitude of all gables; NaN: there are none
  std::string peak_gable;                         // its name: "left gable, storey 2"; empty: there are none
  double peak_storey_drift = 0;                   // likewise, of storey_drift
  std::string peak_storey_drift_wall;             // empty: there is no wall
  double peak_seat_slip = 0, seat_slip = 0;       // m, largest slip of a beam or rafter, at the end; NaN: none lies on a wall
  double peak_seat_slip_time = kNeverReached;     // s
  std::string peak_seat_slip_place;               // empty: no slip
  std::int64_t lost_seats = 0;                    // at the end
  // Overlap of bodies, see Interpenetration: in the last frame, and greatest over all frames.
  double penetration = 0, base_penetration = 0;            // m: of any two elements, or an element and the base; of elements and the base
  double peak_penetration = 0, peak_base_penetration = 0;  // m
  double peak_penetration_time = kNeverReached;            // s
  std::string peak_penetration_pair;                       // empty: no overlap
  std::int64_t deep_pairs = -1, most_deep_pairs = -1;      // -1: unknown
  double most_deep_pairs_time = kNeverReached;             // s, first frame with the most deep pairs
  std::int64_t touching_pairs = 0;                         // in the last frame
  std::vector<WallMeasures> walls;
  std::vector<TieMeasures> ties;  // then decks and meshes
  std::vector<LoadMeasures> loads;
  MeasureSeries series;
  PointAccelerations accelerations;
};

/// Computes all measures of a run. \throw FileError
Measures measure(const Hdf5File& run);

}  // namespace voussoir::io
