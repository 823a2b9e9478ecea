// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/nth.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/building/building.h"
#include "io/output/measures/building/wall_drift.h"
#include "io/output/measures/crack_extents.h"
#include "io/output/measures/damage_grade.h"
#include "io/output/measures/debris/free_volume.h"
#include "io/output/measures/members/seat_slip.h"
#include "io/output/measures/penetration.h"
#include "io/output/replay/frame_reader.h"
#include "io/output/replay/placed_elements.h"
#include "solver/run/collapse.h"

namespace voussoir::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Fallen mass of a part, and the times at which the first element, and a quarter of the mass, had fallen.
struct Part {
  double mass = 0, fallen = 0;          // kg; fallen: in this frame
  double first_time = kNeverReached;    // s
  double quarter_time = kNeverReached;  // s

  [[nodiscard]] double share() const noexcept { return mass > 0 ? fallen / mass : 0.0; }
};

void keep_larger(double& kept, double value) {
  if (!(std::abs(value) <= std::abs(kept))) kept = value;  // also replaces a NaN
}

/// Evaluates all frames of a run in one pass.
class Measurer {
 public:
  explicit Measurer(const Hdf5File& run)
      : frames_(run),
        building_(building_of(run)),
        shapes_(run, frames_.elements()),
        start_(first_poses(frames_)),
        cracks_(run, building_, start_),
        volume_(building_, shapes_, start_),
        penetration_(run, building_, start_),
        tags_(run.read_strings("/model/element/tag")),
        seats_(run, building_, tags_, start_),
        fallen_(frames_.elements()),
        walls_(building_.walls.size()) {
    for (const Wall& w : building_.walls)
      m_.walls.push_back({.name = w.name,
                          .peak_drift = kNone,
                          .residual_drift = kNone,
                          .peak_in_plane_drift = kNone,
                          .storey = static_cast<double>(w.storey),
                          .foot = building_.height_of(w.box.low[2]),
                          .top = building_.height_of(w.box.high[2]),
                          .peak_gable_drift = kNone,
                          .peak_storey_drift = kNone,
                          .residual_storey_drift = kNone,
                          .peak_seat_slip = kNone,
                          .seat_slip = kNone});
    m_.peak_seat_slip = m_.seat_slip = seats_.seats().empty() ? kNone : 0.0;
    for (std::size_t e = 0; e < building_.mass.size(); ++e) {
      all_.mass += building_.mass[e];
      if (Part* part = part_of(e)) part->mass += building_.mass[e];
    }
    read_cracks(run);
    m_.initial_free_volume = volume_.initial();
  }

  Measures all() {
    for (std::uint64_t f = 0; f < frames_.frames(); ++f) take(frames_.times()[f], poses_of(frames_, f));
    finish_grades();
    finish_walls();
    finish_gables();
    finish_penetration();
    m_.fallen_mass_fraction = all_.share();
    m_.first_fallen_time = all_.first_time;
    m_.roof_first_fallen_time = roof_.first_time;
    m_.roof_fallen_mass_fraction = roof_.mass > 0 ? roof_.share() : kNone;
    m_.free_volume = m_.series.free_volume.empty() ? kNone : m_.series.free_volume.back();
    m_.least_free_volume = m_.series.free_volume.empty() ? kNone : *std::ranges::min_element(m_.series.free_volume);
    if (frames_.frames() > 0) m_.debris = debris_of(building_, shapes_, poses_of(frames_, frames_.frames() - 1), fallen_);
    return std::move(m_);
  }

 private:
  void read_cracks(const Hdf5File& run) {
    m_.settling_first_crack_time = kNone;
    for (const double t : run.read<double>("/cracks/time")) {
      if (t < 0 && m_.settling_cracks++ == 0) m_.settling_first_crack_time = t;
      if (t >= 0 && m_.shaking_cracks++ == 0) m_.first_crack_time = t;
    }
  }

  Part* part_of(std::size_t element) {
    if (building_.is_roof(element)) return &roof_;
    return building_.wall[element] < 0 ? nullptr : &nth(walls_, building_.wall[element]);
  }

  void take(double time, const std::vector<Pose>& poses) {
    take_fallen(time, poses);
    BuildingDamage damage{{}, roof_.share(), all_.share(), m_.collapsed};
    const std::vector<CrackExtent> cracks = cracks_.extents(time, poses);
    for (std::size_t w = 0; w < walls_.size(); ++w) damage.walls.push_back(damage_of(time, w, cracks[w], poses));
    take_gables(time, poses);
    m_.series.time.push_back(time);
    m_.series.damage_grade.push_back(damage.walls.empty() ? -1 : damage_grade(damage));
    m_.series.fallen_mass_fraction.push_back(all_.share());
    m_.series.free_volume.push_back(volume_.initial() > 0 ? volume_.at(poses) / volume_.initial() : kNone);
    take_seats(time, poses);
    take_penetration(time, poses);
  }

  /// Stores the slip of beams and rafters on the walls, while less than half of their seat is gone.
  void take_seats(double time, const std::vector<Pose>& poses) {
    const std::vector<SeatSlip::Slip> slips = seats_.at(poses, fallen_);
    m_.lost_seats = 0, m_.seat_slip = kNone;
    for (WallMeasures& w : m_.walls) w.seat_slip = kNone;
    for (std::size_t i = 0; i < slips.size(); ++i) {
      const Seat& seat = seats_.seats()[i];
      WallMeasures* wall = seat.wall < 0 ? nullptr : &nth(m_.walls, seat.wall);
      if (wall != nullptr && std::isnan(wall->peak_seat_slip)) wall->peak_seat_slip = 0.0;
      if (slips[i].lost) {  // its last slip stays the largest
        ++m_.lost_seats;
        continue;
      }
      const double slip = slips[i].metres;
      keep_larger(m_.seat_slip, slip);
      if (wall != nullptr) keep_larger(wall->seat_slip, slip), keep_larger(wall->peak_seat_slip, slip);
      if (slip <= m_.peak_seat_slip) continue;
      m_.peak_seat_slip = slip, m_.peak_seat_slip_time = time;
      m_.peak_seat_slip_place = seat.timber + " on the " + (wall != nullptr ? wall->name : "ring beam");
    }
    m_.series.seat_slip.push_back(m_.seat_slip);
  }

  void take_fallen(double time, const std::vector<Pose>& poses) {
    solver::FallenMass sum;
    all_.fallen = roof_.fallen = 0;
    for (Part& w : walls_) w.fallen = 0;
    for (std::size_t e = 0; e < poses.size(); ++e) {
      const double height = start_[e].centre.z - building_.base, sunk = start_[e].centre.z - poses[e].centre.z;
      sum.add(building_.kind[e], building_.mass[e], sunk, height);
      fallen_[e] = building_.mass[e] > 0 && solver::FallenMass::has_fallen(sunk, height) ? 1 : 0;  // fixed elements have mass 0 here
      if (fallen_[e] == 0) continue;
      for (Part* part : {&all_, part_of(e)}) {
        if (part == nullptr) continue;
        part->fallen += building_.mass[e];
        if (part->first_time == kNeverReached) part->first_time = time;
      }
    }
    for (Part& w : walls_)
      if (w.quarter_time == kNeverReached && w.share() >= 0.25) w.quarter_time = time;
    m_.collapsed = sum.is_collapse();
    if (m_.collapsed && m_.collapse_time == kNeverReached) m_.collapse_time = time;
  }

  /// Damage of one wall in this frame; stores its drift and cracks.
  WallDamage damage_of(double time, std::size_t w, const CrackExtent& cracks, const std::vector<Pose>& poses) {
    const Wall& wall = building_.walls[w];
    WallMeasures& measures = m_.walls[w];
    const std::optional<double> drift = wall_drift(wall, start_, poses, fallen_);
    measures.opened_extent = cracks.any, measures.crack_extent = cracks.fine, measures.large_crack_extent = cracks.large;
    if (m_.series.time.empty()) measures.settling_crack_extent = cracks.fine;
    measures.residual_drift = drift.value_or(kNone);
    m_.series.drift.push_back(measures.residual_drift);
    if (drift && !(std::abs(*drift) <= std::abs(measures.peak_drift))) measures.peak_drift = *drift, measures.peak_drift_time = time;
    const double storey = storey_drift(wall, start_, poses, fallen_).value_or(kNone);
    measures.residual_storey_drift = storey;
    m_.series.storey_drift.push_back(storey);
    if (!std::isnan(storey) && !(std::abs(storey) <= std::abs(measures.peak_storey_drift)))
      measures.peak_storey_drift = storey, measures.peak_storey_drift_time = time;
    const std::optional<double> in_plane = wall_drift(wall, start_, poses, fallen_, DriftDirection::in_plane);
    m_.series.in_plane_drift.push_back(in_plane.value_or(kNone));
    if (in_plane) keep_larger(measures.peak_in_plane_drift, *in_plane);
    return {cracks, walls_[w].share(), std::abs(drift.value_or(0.0)) * wall.height() / wall.thickness()};
  }

  void take_gables(double time, const std::vector<Pose>& poses) {
    for (const Gable& g : building_.gables) {
      WallMeasures& wall = nth(m_.walls, g.wall);
      const std::optional<double> drift = wall_drift(g.part, start_, poses, fallen_);
      if (drift && !(std::abs(*drift) <= std::abs(wall.peak_gable_drift)))
        wall.peak_gable_drift = *drift, wall.peak_gable_drift_time = time;
    }
  }

  /// Computes grades over time. Temporary damage, such as a crack that closes again, does not count: the grade at a time is the lowest from
  /// then on.
  void finish_grades() {
    std::vector<std::int64_t>& grade = m_.series.damage_grade;
    for (std::size_t f = grade.size(); f-- > 1;) grade[f - 1] = std::min(grade[f - 1], grade[f]);
    m_.damage_grade = grade.empty() ? -1 : grade.back();
    m_.settling_damage_grade = grade.empty() ? -1 : grade.front();
    for (std::size_t g = 0; g < m_.grade_time.size(); ++g) {
      const auto first = std::ranges::lower_bound(grade, static_cast<std::int64_t>(g) + 1);
      m_.grade_time[g] = first == grade.end() ? kNeverReached : nth(m_.series.time, first - grade.begin());
    }
  }

  [[nodiscard]] std::string name_of(std::int32_t body) const {
    return body == kBaseBody ? "the base" : "element " + std::to_string(body) + " (" + nth(tags_, body) + ")";
  }

  void take_penetration(double time, const std::vector<Pose>& poses) {
    const Interpenetration now = penetration_.at(poses);
    m_.penetration = now.deepest, m_.base_penetration = now.deepest_in_base, m_.deep_pairs = now.deep_pairs;
    m_.series.penetration.push_back(now.deepest);
    m_.series.deep_pairs.push_back(now.deep_pairs);
    m_.peak_base_penetration = std::max(m_.peak_base_penetration, now.deepest_in_base);
    if (now.deepest > m_.peak_penetration) {
      m_.peak_penetration = now.deepest, m_.peak_penetration_time = time;
      m_.peak_penetration_pair = name_of(now.a) + " and " + name_of(now.b);
    }
    if (now.deep_pairs > std::max<std::int64_t>(m_.most_deep_pairs, 0)) m_.most_deep_pairs_time = time;
    m_.most_deep_pairs = std::max(m_.most_deep_pairs, now.deep_pairs);
  }

  void finish_penetration() {
    if (frames_.frames() > 0) m_.touching_pairs = penetration_.touching_pairs(poses_of(frames_, frames_.frames() - 1));
  }

  void finish_walls() {
    m_.peak_drift = m_.residual_drift = m_.peak_in_plane_drift = m_.peak_storey_drift = kNone;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      WallMeasures& measures = m_.walls[w];
      measures.fallen_mass_fraction = walls_[w].share();
      measures.first_fallen_time = walls_[w].first_time;
      measures.quarter_fallen_time = walls_[w].quarter_time;
      measures.first_open_joint_time = cracks_.first_time(w).value_or(kNeverReached);
      if (walls_[w].first_time != kNeverReached && walls_[w].first_time < first) {
        first = walls_[w].first_time;
        m_.first_fallen_wall = measures.name;
      }
      if (!std::isnan(measures.peak_drift) && !(std::abs(measures.peak_drift) <= m_.peak_drift))
        m_.peak_drift = std::abs(measures.peak_drift), m_.peak_drift_time = measures.peak_drift_time, m_.peak_drift_wall = measures.name;
      if (!std::isnan(measures.peak_storey_drift) && !(std::abs(measures.peak_storey_drift) <= m_.peak_storey_drift))
        m_.peak_storey_drift = std::abs(measures.peak_storey_drift), m_.peak_storey_drift_wall = measures.name;
      if (!std::isnan(measures.peak_in_plane_drift)) keep_larger(m_.peak_in_plane_drift, std::abs(measures.peak_in_plane_drift));
      if (!std::isnan(measures.residual_drift)) keep_larger(m_.residual_drift, std::abs(measures.residual_drift));
    }
  }

  void finish_gables() {
    m_.peak_gable_drift = kNone;
    for (const Gable& g : building_.gables) {
      const double drift = std::abs(nth(m_.walls, g.wall).peak_gable_drift);
      if (!std::isnan(drift) && !(drift <= m_.peak_gable_drift)) m_.peak_gable_drift = drift, m_.peak_gable = g.part.name;
    }
  }

  FrameReader frames_;
  Building building_;
  ElementShapes shapes_;
  std::vector<Pose> start_;
  Cracks cracks_;
  FreeVolume volume_;
  InterpenetrationCheck penetration_;
  std::vector<std::string> tags_;
  SeatSlip seats_;
  std::vector<std::uint8_t> fallen_;  // in the current frame
  Part all_, roof_;
  std::vector<Part> walls_;
  Measures m_;
};

}  // namespace

Measures measure(const Hdf5File& run) {
  Measures m = Measurer(run).all();
  m.accelerations = point_accelerations(run);
  m.ties = tie_measures(run);
  m.loads = load_measures(run);
  return m;
}

}  // namespace voussoir::io
