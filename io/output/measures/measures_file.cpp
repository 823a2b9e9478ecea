// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/measures_file.h"

#include <map>
#include <nlohmann/json.hpp>

#include "io/input/files/hdf5_file.h"
#include "io/output/measures/chance.h"

namespace voussoir::io {
namespace {

template <class T>
void put(Hdf5File& file, const std::string& name, const std::vector<T>& values, const Shape& shape, const Hdf5Note& note) {
  std::size_t row_bytes = sizeof(T);
  for (std::size_t i = 1; i < shape.size(); ++i) row_bytes *= shape[i];
  file.write_dataset(name, Hdf5TypeOf<T>::value, shape, values.data(), row_bytes > 0 ? checked_layout(row_bytes) : Hdf5Layout{}, note);
}

void write_walls(Hdf5File& file, const std::vector<WallMeasures>& walls) {
  std::vector<std::string> names;
  for (const WallMeasures& w : walls) names.push_back(w.name);
  file.write_strings("/summary/wall/name", names, {"1", "walls in the order of the other datasets here"});
  for (const WallColumn& column : kWallColumns) {
    std::vector<double> values;
    for (const WallMeasures& w : walls) values.push_back(w.*column.value);
    put(file, std::string("/summary/wall/") + column.name, values, {walls.size()}, {column.unit, column.description});
  }
}

void write_series(Hdf5File& file, const MeasureSeries& s, std::size_t walls) {
  const Shape rows{s.time.size()};
  put(file, "/measures/time", s.time, rows, {"s", "time of the rows, those of /frames"});
  put(file, "/measures/damage_grade", s.damage_grade, rows,
      {"1", "EMS-98, 0 to 5: the least from here to the end; -1: there are no walls"});
  put(file, "/measures/fallen_mass_fraction", s.fallen_mass_fraction, rows, {"1", "of all mass"});
  put(file, "/measures/free_volume", s.free_volume, rows, {"1", "left between floor and roof, of that at first; NaN: there is no room"});
  put(file, "/measures/penetration", s.penetration, rows, {"m", "deepest of any two elements, or of an element in the base"});
  put(file, "/measures/deep_pairs", s.deep_pairs, rows, {"1", "pairs deeper in each other than half a segment; -1: not known"});
  put(file, "/measures/drift", s.drift, {s.time.size(), walls},
      {"1", "out-of-plane drift of each wall of /summary/wall, outward positive; NaN: it does not stand"});
  put(file, "/measures/in_plane_drift", s.in_plane_drift, {s.time.size(), walls},
      {"1", "in-plane drift of each wall of /summary/wall, along x or y positive; NaN: it does not stand"});
  put(file, "/measures/storey_drift", s.storey_drift, {s.time.size(), walls},
      {"1", "storey drift of each wall of /summary/wall, positive to the right as seen from outside; NaN: it does not stand"});
  put(file, "/measures/seat_slip", s.seat_slip, rows, {"m", "largest slip of a beam or rafter on a wall; NaN: there is none"});
}

void write_ties(Hdf5File& file, const std::vector<TieMeasures>& ties) {
  if (ties.empty()) return;
  std::vector<std::string> names;
  for (const TieMeasures& t : ties) names.push_back(t.name);
  file.write_strings("/summary/tie/name", names, {"1", "ties, then decks and meshes, in the order of the other datasets here"});
  for (const TieColumn& column : kTieColumns) {
    std::vector<double> values;
    for (const TieMeasures& t : ties) values.push_back(t.*column.value);
    put(file, std::string("/summary/tie/") + column.name, values, {ties.size()}, {column.unit, column.description});
  }
}

void write_loads(Hdf5File& file, const std::vector<LoadMeasures>& loads) {
  if (loads.empty()) return;
  std::vector<std::string> names, places;
  for (const LoadMeasures& l : loads) names.push_back(l.name), places.push_back(l.place);
  file.write_strings("/summary/load/name", names, {"1", "loads that have a force, in the order of the other datasets here"});
  file.write_strings("/summary/load/place", places, {"1", "where each acts, in the axes of the case file"});
  for (const LoadColumn& column : kLoadColumns) {
    std::vector<double> values;
    for (const LoadMeasures& l : loads) values.push_back(l.*column.value);
    put(file, std::string("/summary/load/") + column.name, values, {loads.size()}, {column.unit, column.description});
  }
}

}  // namespace

std::vector<Figure> figures_of(const Measures& m) {
  return {{"damage_grade", m.damage_grade, "EMS-98 (below 0: there are no walls)"},
          {"settling_damage_grade", m.settling_damage_grade, "EMS-98 (below 0: there are no walls)"},
          {"settling_cracks", m.settling_cracks, "segments"},
          {"settling_first_crack_time", m.settling_first_crack_time, "s (below 0: before the shaking; NaN: none)"},
          {"shaking_cracks", m.shaking_cracks, "segments"},
          {"collapse_time", m.collapse_time, "s (below 0: never)"},
          {"first_fallen_time", m.first_fallen_time, "s (below 0: never)"},
          {"first_fallen_wall", m.first_fallen_wall, "a name of wall/name (empty: none)"},
          {"roof_first_fallen_time", m.roof_first_fallen_time, "s (below 0: never)"},
          {"roof_fallen_mass_fraction", m.roof_fallen_mass_fraction, "1 (NaN: there is no roof)"},
          {"debris_area", m.debris.area, "m2"},
          {"debris_reach", m.debris.reach, "m"},
          {"debris_reach_95", m.debris.reach_95, "m"},
          {"initial_free_volume", m.initial_free_volume, "m3"},
          {"free_volume", m.free_volume, "1 (NaN: there is no room)"},
          {"least_free_volume", m.least_free_volume, "1 (NaN: there is no room)"},
          {"peak_drift", m.peak_drift, "1 (NaN: there is no wall)"},
          {"residual_drift", m.residual_drift, "1 (NaN: no wall stands)"},
          {"peak_in_plane_drift", m.peak_in_plane_drift, "1 (NaN: there is no wall)"},
          {"peak_drift_time", m.peak_drift_time, "s (below 0: never)"},
          {"peak_drift_wall", m.peak_drift_wall, "a name of wall/name (empty: none)"},
          {"peak_gable_drift", m.peak_gable_drift, "1 (NaN: there is no gable)"},
          {"peak_gable", m.peak_gable, "the gable of it (empty: none)"},
          {"peak_storey_drift", m.peak_storey_drift, "1 (NaN: there is no wall)"},
          {"peak_storey_drift_wall", m.peak_storey_drift_wall, "a name of wall/name (empty: none)"},
          {"peak_seat_slip", m.peak_seat_slip, "m (NaN: no timber lies on a wall)"},
          {"peak_seat_slip_time", m.peak_seat_slip_time, "s (below 0: never)"},
          {"peak_seat_slip_place", m.peak_seat_slip_place, "timber and wall (empty: none)"},
          {"seat_slip", m.seat_slip, "m (NaN: no timber lies on a wall)"},
          {"lost_seats", m.lost_seats, "seats of timber"},
          {"penetration", m.penetration, "m"},
          {"peak_penetration", m.peak_penetration, "m"},
          {"peak_penetration_time", m.peak_penetration_time, "s (below 0: never)"},
          {"peak_penetration_pair", m.peak_penetration_pair, "two bodies (empty: none)"},
          {"base_penetration", m.base_penetration, "m"},
          {"peak_base_penetration", m.peak_base_penetration, "m"},
          {"deep_pairs", m.deep_pairs, "pairs (below 0: not known)"},
          {"most_deep_pairs", m.most_deep_pairs, "pairs (below 0: not known)"},
          {"most_deep_pairs_time", m.most_deep_pairs_time, "s (below 0: never)"},
          {"touching_pairs", m.touching_pairs, "pairs"}};
}

std::string figure_units() {
  std::map<std::string, std::string> names;  // by unit
  for (const Figure& f : figures_of(Measures{})) {
    std::string& of_unit = names[f.unit];
    of_unit += (of_unit.empty() ? "" : ", ") + f.name;
  }
  std::string text;
  for (const auto& [unit, all] : names) text.append(text.empty() ? "" : "; ").append(all).append(": ").append(unit);
  return text;
}

std::string measures_json(const Measures& m) {
  nlohmann::ordered_json out;
  for (const Figure& f : figures_of(m)) std::visit([&](const auto& value) { out[f.name] = value; }, f.value);
  out["grade_time"] = m.grade_time;
  out["walls"] = nlohmann::ordered_json::array();
  for (const WallMeasures& w : m.walls) {
    nlohmann::ordered_json& wall = out["walls"].emplace_back(nlohmann::ordered_json{{"name", w.name}});
    for (const WallColumn& column : kWallColumns) wall[column.name] = w.*column.value;
  }
  out["ties"] = nlohmann::ordered_json::array();
  for (const TieMeasures& t : m.ties) {
    nlohmann::ordered_json& tie = out["ties"].emplace_back(nlohmann::ordered_json{{"name", t.name}});
    for (const TieColumn& column : kTieColumns) tie[column.name] = t.*column.value;
  }
  if (!m.loads.empty()) out["loads"] = nlohmann::ordered_json::array();
  for (const LoadMeasures& l : m.loads) {
    nlohmann::ordered_json& load = out["loads"].emplace_back(nlohmann::ordered_json{{"name", l.name}, {"place", l.place}});
    for (const LoadColumn& column : kLoadColumns) load[column.name] = l.*column.value;
  }
  out["points"] = nlohmann::ordered_json::array();
  for (const PointAcceleration& p : m.accelerations.points)
    out["points"].push_back({{"name", p.name}, {"peak_acceleration", p.peak_horizontal}});
  if (has_chance(m)) out["chance"] = {{"from", m.first_fallen_time}, {"figures", figures_of_chance()}, {"note", words_of_chance(m)}};
  return out.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void write_measures(Hdf5File& file, const Measures& m) {
  for (const Figure& f : figures_of(m)) std::visit([&](const auto& value) { file.set_attribute("/summary", f.name, value); }, f.value);
  put(file, "/summary/grade_time", std::vector<double>(m.grade_time.begin(), m.grade_time.end()), {m.grade_time.size()},
      {"s", "from when on damage was of grade 1, 2, 3, 4, 5 of EMS-98 at least; below 0: never"});
  write_walls(file, m.walls);
  write_ties(file, m.ties);
  write_loads(file, m.loads);
  write_series(file, m.series, m.walls.size());
  write_accelerations(file, m.accelerations);
}

}  // namespace voussoir::io
