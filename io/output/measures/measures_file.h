// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "io/output/measures/measures.h"

/// Names of measures, common to run.h5, `voussoir summary` and the report page.
namespace voussoir::io {

/// A measure with a single value: an attribute of /summary.
struct Figure {
  std::string name;
  std::variant<std::int64_t, double, std::string> value;
  const char* unit;
};

/// The measures other than those of solver::Summary. Times below 0: never; NaN: undefined.
std::vector<Figure> figures_of(const Measures& m);

/// A measure by wall: a dataset of /summary/wall.
struct WallColumn {
  const char* name;
  double WallMeasures::*value;
  const char* unit;
  const char* description;
};
inline constexpr std::array kWallColumns{
    WallColumn{"fallen_mass_fraction", &WallMeasures::fallen_mass_fraction, "1", "of the mass of the wall with its gable and lintels"},
    WallColumn{"first_fallen_time", &WallMeasures::first_fallen_time, "s", "when its first element had fallen; below 0: none has"},
    WallColumn{"quarter_fallen_time", &WallMeasures::quarter_fallen_time, "s", "when a quarter of its mass had fallen; below 0: never"},
    WallColumn{"first_open_joint_time", &WallMeasures::first_open_joint_time, "s",
               "when the first of its joints came open; below 0: never"},
    WallColumn{"peak_drift", &WallMeasures::peak_drift, "1", "out-of-plane drift while it stood, outward positive; NaN: it never stood"},
    WallColumn{"residual_drift", &WallMeasures::residual_drift, "1", "out-of-plane drift at the end; NaN: the wall does not stand"},
    WallColumn{"peak_in_plane_drift", &WallMeasures::peak_in_plane_drift, "1",
               "in-plane drift while it stood, along x or y positive; NaN: it never stood"},
    WallColumn{"crack_extent", &WallMeasures::crack_extent, "1", "area of joints 1 mm open or more over the wall's horizontal section"},
    WallColumn{"opened_extent", &WallMeasures::opened_extent, "1", "area of joints that came open since time zero over the section"},
    WallColumn{"settling_crack_extent", &WallMeasures::settling_crack_extent, "1", "crack_extent when the shaking began"},
    WallColumn{"large_crack_extent", &WallMeasures::large_crack_extent, "1", "the same with 5 mm"},
    WallColumn{"storey", &WallMeasures::storey, "1", "number of the storey, from below"},
    WallColumn{"foot", &WallMeasures::foot, "m", "height of the wall's foot (above the base; without one, z of the case)"},
    WallColumn{"top", &WallMeasures::top, "m", "height of its top, without a gable"},
    WallColumn{"peak_drift_time", &WallMeasures::peak_drift_time, "s", "of peak_drift; below 0: never"},
    WallColumn{"peak_gable_drift", &WallMeasures::peak_gable_drift, "1",
               "out-of-plane drift of its gable while that stood, outward positive; NaN: it has none, or that never stood"},
    WallColumn{"peak_gable_drift_time", &WallMeasures::peak_gable_drift_time, "s", "of it; below 0: never"},
    WallColumn{"peak_storey_drift", &WallMeasures::peak_storey_drift, "1",
               "drift of its storey along the wall while it stood, positive to the right as seen from outside; NaN: it never stood"},
    WallColumn{"peak_storey_drift_time", &WallMeasures::peak_storey_drift_time, "s", "of it; below 0: never"},
    WallColumn{"residual_storey_drift", &WallMeasures::residual_storey_drift, "1", "the same at the end; NaN: the wall does not stand"},
    WallColumn{"peak_seat_slip", &WallMeasures::peak_seat_slip, "m", "largest slip of a beam or rafter on it; NaN: it bears none"},
    WallColumn{"seat_slip", &WallMeasures::seat_slip, "m", "the same at the end; NaN: it bears none"},
};

/// A measure by tie: a dataset of /summary/tie.
struct TieColumn {
  const char* name;
  double TieMeasures::*value;
  const char* unit;
  const char* description;
};
inline constexpr std::array kTieColumns{
    TieColumn{"bars", &TieMeasures::bars, "1",
              "0: a separate tie; else number of the bars of a deck or mesh, whose figures are of its bar "
              "in which they are largest"},
    TieColumn{"peak_force", &TieMeasures::peak_force, "N", "largest in magnitude; tension is positive"},
    TieColumn{"peak_force_time", &TieMeasures::peak_time, "s", "of it"},
    TieColumn{"peak_elongation", &TieMeasures::peak_elongation, "m", "largest in magnitude"},
    TieColumn{"plastic", &TieMeasures::plastic, "m", "elongation that stays, at the end; NaN: a deck or mesh"},
    TieColumn{"utilisation", &TieMeasures::utilisation, "1", "largest force over yield force; NaN: elastic, or not known"},
    TieColumn{"yielded", &TieMeasures::yielded, "1", "ties or bars that have yielded and hold, at the end"},
    TieColumn{"broken", &TieMeasures::broken, "1", "ties or bars that have broken, at the end"},
};

/// A measure by load: a dataset of /summary/load.
struct LoadColumn {
  const char* name;
  double LoadMeasures::*value;
  const char* unit;
  const char* description;
};
inline constexpr std::array kLoadColumns{
    LoadColumn{"peak_force", &LoadMeasures::peak_force, "N", "the largest"},
    LoadColumn{"peak_force_time", &LoadMeasures::peak_force_time, "s", "of it"},
    LoadColumn{"displacement_at_peak_force", &LoadMeasures::displacement_at_peak, "m",
               "of the loaded place at that time, along the force; NaN: the load acted nowhere"},
    LoadColumn{"peak_displacement", &LoadMeasures::peak_displacement, "m", "of the loaded place along the force, largest in magnitude"},
    LoadColumn{"peak_displacement_time", &LoadMeasures::peak_displacement_time, "s", "of it"},
    LoadColumn{"force_at_peak_displacement", &LoadMeasures::force_at_peak_displacement, "N", "at that time"},
    LoadColumn{"end_force", &LoadMeasures::end_force, "N", "at the end"},
    LoadColumn{"end_displacement", &LoadMeasures::end_displacement, "m", "at the end, along the force; NaN: it acts nowhere then"},
};

/// Units of the figures, for the attribute `units` of /summary: "name, name: unit; ...".
std::string figure_units();

/// Figures, `grade_time`, `walls` and `points` as one JSON object; null for NaN.
std::string measures_json(const Measures& m);

/// Writes figures as attributes of /summary (which exists), /summary/wall, /summary/grade_time, and the group /measures. \throw FileError
void write_measures(Hdf5File& file, const Measures& m);

}  // namespace voussoir::io
