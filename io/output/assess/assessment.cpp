// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/assessment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cases/case.h"
#include "cases/names.h"
#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/members/peak_base_shear.h"
#include "solver/run/collapse.h"

namespace voussoir::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPiece = 0.5;         // m, size of a piece along a wall and upwards
constexpr double kSameLevel = 1e-3;    // m
constexpr double kSameTime = 1e-3;     // s
constexpr double kLeastStorey = 0.25;  // m: feet and tops of walls that are nearer belong to one level

constexpr double kGone = 1.0;  // m: an element displaced by more no longer belongs to its wall

/// By element, 1: fallen, or displaced by more than kGone.
std::vector<std::uint8_t> fallen_in(const Building& b, const std::vector<Pose>& start, const std::vector<Pose>& poses) {
  std::vector<std::uint8_t> fallen(start.size());
  for (std::size_t e = 0; e < start.size(); ++e) {
    const double sunk = start[e].centre.z - poses[e].centre.z;
    const bool gone = norm(poses[e].centre - start[e].centre) > kGone;
    fallen[e] = b.mass[e] > 0 && (gone || solver::FallenMass::has_fallen(sunk, start[e].centre.z - b.base)) ? 1 : 0;
  }
  return fallen;
}

/// Displacement of some elements, weighted by mass, of those not fallen; nothing once half of the mass has fallen.
std::optional<Vec3> mean_of(const std::vector<std::size_t>& elements, const Building& b, const std::vector<Pose>& start,
                            const std::vector<Pose>& poses, const std::vector<std::uint8_t>& fallen) {
  Vec3 sum;
  double mass = 0, down = 0;
  for (const std::size_t e : elements) {
    if (fallen[e] != 0) {
      down += b.mass[e];
      continue;
    }
    mass += b.mass[e];
    sum += b.mass[e] * (poses[e].centre - start[e].centre);
  }
  if (mass <= 0 || down >= mass) return {};
  return sum / mass;
}

/// The pieces of a wall, each about half a metre long and high.
std::vector<std::vector<std::size_t>> pieces_of(const Building& b, std::int32_t wall) {
  const Wall& w = nth(b.walls, wall);
  const std::size_t axis = 1 - w.across;
  std::map<std::pair<long, long>, std::vector<std::size_t>> pieces;
  for (std::size_t e = 0; e < b.wall.size(); ++e) {
    if (b.wall[e] != wall) continue;
    const auto place = [&](double at, double from, double size) {
      return std::lround(std::floor((at - from) / size * std::max(1.0, std::round(size / kPiece))));
    };
    pieces[{place(b.box_in(w, e).centre(axis), w.box.low[axis], w.length()), place(b.box[e].centre(2), w.box.low[2], w.height())}]
        .push_back(e);
  }
  std::vector<std::vector<std::size_t>> all;
  for (auto& [at, elements] : pieces) all.push_back(std::move(elements));
  return all;
}

struct Level {
  double z = 0;  // m
  std::vector<std::size_t> elements;
};

/// Bricks of a house cut by each level; at foot and top those of the lowest and the uppermost course.
std::vector<Level> levels_of(const Building& b, std::int32_t house, std::vector<double> heights) {
  Box box = Box::empty();
  for (const Wall& w : b.walls)
    if (w.house == house) box.include(w.box);
  if (heights.empty()) {
    for (const Wall& w : b.walls)
      if (w.house == house)
        for (const double h : {w.box.low[2], w.box.high[2]})
          if (std::ranges::none_of(heights, [&](double other) { return std::abs(h - other) < kLeastStorey; })) heights.push_back(h);
    std::ranges::sort(heights);
  } else {
    for (double& h : heights) h = b.z_of(h);
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  }
  std::vector<Level> levels;
  for (const double z : heights) {
    if (z < box.low[2] - kSameLevel || z > box.high[2] + kSameLevel) continue;  // crosses no course of this house
    Level level{z, {}};
    const double inside = std::clamp(z, box.low[2] + kSameLevel, box.high[2] - kSameLevel);
    for (std::size_t e = 0; e < b.wall.size(); ++e) {
      if (b.wall[e] < 0 || nth(b.walls, b.wall[e]).house != house) continue;
      if (b.box[e].low[2] < inside && b.box[e].high[2] >= inside) level.elements.push_back(e);
    }
    if (!level.elements.empty()) levels.push_back(std::move(level));
  }
  return levels;
}

void read_cuts(const Hdf5File& run, const cases::Case& c, Assessment& out) {
  for (const cases::Cut& cut : c.output.cuts) {
    const std::string group = "/cuts/" + cut.name;
    if (!run.exists(group + "/force")) throw FileError(run.path(), group + " is missing");
    const auto time = run.read<double>("/cuts/time"), force = run.read<double>(group + "/force"),
               moment = run.read<double>(group + "/moment");
    if (force.size() != 3 * time.size() || moment.size() != force.size()) throw FileError(run.path(), group + " does not fit together");
    CutAssessment& a = out.cuts.emplace_back();
    a.name = cut.name, a.normal = normalised(cut.normal);
    for (std::size_t i = 0; i < time.size(); ++i) {
      const Vec3 f{force[3 * i], force[3 * i + 1], force[3 * i + 2]}, m{moment[3 * i], moment[3 * i + 1], moment[3 * i + 2]};
      const double axial = dot(f, a.normal), torsion = dot(m, a.normal);
      a.axial.take(axial, time[i]);
      if (axial < 0) a.compression.take(axial, time[i]);
      a.shear.take(norm(f - axial * a.normal), time[i]);
      a.bending.take(norm(m - torsion * a.normal), time[i]);
      a.torsion.take(torsion, time[i]);
    }
  }
}

void read_base_shear(const Hdf5File& run, Assessment& out) {
  const PeakBaseShear peak = peak_base_shear(run);
  out.base_shear = {peak.value, peak.time};
  out.base_shear_over_weight = peak.over(out.weight);
}

/// Refuses heights of storeys that lie outside the walls.
void check_levels(const Building& b, const std::vector<double>& heights) {
  double foot = b.has_base ? 0.0 : std::numeric_limits<double>::infinity(), top = 0.0;
  for (const Wall& w : b.walls) foot = std::min(foot, b.height_of(w.box.low[2])), top = std::max(top, b.height_of(w.box.high[2]));
  if (foot > top) foot = 0.0;  // no walls
  for (const double h : heights) {
    if (!(h >= foot - kSameLevel && h <= top + kSameLevel))
      throw cases::InputError("--levels", "= " + cases::text(h) + " m; allowed: from " + cases::text(foot) + " to " + cases::text(top) +
                                              " m, the top of the walls");
  }
}

/// Evaluates all frames in one pass.
class Assessor {
 public:
  Assessor(const Hdf5File& run, const Building& building, const std::vector<double>& heights)
      : frames_(run), building_(building), start_(first_poses(frames_)) {
    check_levels(building, heights);
    std::vector<std::int32_t> houses;
    for (std::size_t w = 0; w < building.walls.size(); ++w) {
      out_.walls.push_back({building.walls[w].name, building.walls[w].thickness(), {}, 0, {}, 0, {}});
      pieces_.push_back(pieces_of(building, static_cast<std::int32_t>(w)));
      houses.push_back(building.walls[w].house);
    }
    std::ranges::sort(houses);
    houses.erase(std::unique(houses.begin(), houses.end()), houses.end());
    for (const std::int32_t house : houses) {
      levels_.push_back(levels_of(building, house, heights));
      for (std::size_t k = 1; k < levels_.back().size(); ++k)
        out_.storeys.push_back({house, building.height_of(levels_.back()[k - 1].z), building.height_of(levels_.back()[k].z), {}, {}});
    }
  }

  Assessment all(const Hdf5File& run, std::optional<double> time) {
    if (frames_.frames() == 0) throw FileError(run.path(), "/frames has no rows");
    const std::vector<double>& times = frames_.times();
    std::size_t now = times.size() - 1;
    if (time) {
      if (!(*time >= times.front() - kSameTime && *time <= times.back() + kSameTime)) {
        throw cases::InputError("--time", "= " + cases::text(*time) + " s; allowed: from " + cases::text(times.front()) + " to " +
                                              cases::text(times.back()) + " s, the times of the frames");
      }
      for (std::size_t f = 0; f < times.size(); ++f)
        if (std::abs(times[f] - *time) < std::abs(times[now] - *time)) now = f;
    }
    for (std::size_t f = 0; f < times.size(); ++f) take(times[f], poses_of(frames_, f), f == now);
    out_.time = times[now];
    out_.joints = joint_widths(run, building_, start_, out_.time, poses_of(frames_, now));
    out_.cracks = cracks_of(run, building_, out_.joints, out_.fallen);
    follow(run, frames_, out_.cracks);
    for (std::size_t w = 0; w < out_.walls.size(); ++w) {
      out_.walls[w].cracks = wall_figures(out_.joints, static_cast<std::int32_t>(w));
      out_.walls[w].parted = parted_joints(out_.joints, static_cast<std::int32_t>(w));
      out_.walls[w].seats = seat_figures(out_.joints, static_cast<std::int32_t>(w));
      for (OpeningCorner& c : opening_corners(building_, static_cast<std::int32_t>(w))) {
        const CrackFigures f = corner_figures(out_.joints, building_, c);
        c.z = building_.height_of(c.z);
        out_.corners.emplace_back(std::move(c), f);
      }
    }
    return std::move(out_);
  }

 private:
  void take(double time, const std::vector<Pose>& poses, bool now) {
    const std::vector<std::uint8_t> fallen = fallen_in(building_, start_, poses);
    for (std::size_t w = 0; w < out_.walls.size(); ++w) {
      const double value = out_of_plane(building_.walls[w], pieces_[w], poses, fallen);
      out_.walls[w].out_of_plane.take(value, time);
      if (now) out_.walls[w].out_of_plane_now = value;
    }
    std::size_t storey = 0;
    for (const std::vector<Level>& levels : levels_) {
      for (std::size_t k = 1; k < levels.size(); ++k)
        take_drift(levels[k - 1], levels[k], time, poses, fallen, now, out_.storeys[storey++]);
    }
    if (now) out_.fallen = fallen;
  }

  /// Whether a wall stands: at least half of its uppermost course is in place, as for wall_drift.
  static bool stands(const Wall& w, const std::vector<std::uint8_t>& fallen) {
    std::size_t up = 0, down = 0;
    for (const std::vector<std::size_t>& piece : w.top)
      for (const std::size_t e : piece) ++(fallen[e] != 0 ? down : up);
    return down < up;
  }

  /// Out-of-plane displacement over the thickness; NaN: no part of the wall stands.
  [[nodiscard]] double out_of_plane(const Wall& w, const std::vector<std::vector<std::size_t>>& pieces, const std::vector<Pose>& poses,
                                    const std::vector<std::uint8_t>& fallen) const {
    const std::optional<Vec3> foot = mean_of(w.foot, building_, start_, poses, fallen);
    if (!foot || !stands(w, fallen)) return kNone;
    double most = kNone;
    for (const std::vector<std::size_t>& piece : pieces) {
      const std::optional<Vec3> u = mean_of(piece, building_, start_, poses, fallen);
      if (!u) continue;
      const double out = w.outward * (w.through(*u) - w.through(*foot));
      if (!(std::abs(out) <= std::abs(most))) most = out;
    }
    return most / w.thickness();
  }

  void take_drift(const Level& low, const Level& high, double time, const std::vector<Pose>& poses, const std::vector<std::uint8_t>& fallen,
                  bool now, StoreyDrift& to) const {
    const auto below = mean_of(low.elements, building_, start_, poses, fallen),
               above = mean_of(high.elements, building_, start_, poses, fallen);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double drift = below && above ? component(*above - *below, axis) / (high.z - low.z) : kNone;
      to.peak[axis].take(drift, time);
      if (now) to.now[axis] = drift;
    }
  }

  FrameReader frames_;
  const Building& building_;
  std::vector<Pose> start_;
  std::vector<std::vector<std::vector<std::size_t>>> pieces_;  // by wall
  std::vector<std::vector<Level>> levels_;                     // by house
  Assessment out_;
};

}  // namespace

Assessment assess(const Hdf5File& run, const cases::Case& c, const Building& building, std::optional<double> time,
                  const std::vector<double>& levels) {
  Assessment out = Assessor(run, building, levels).all(run, time);
  out.weight = weight_of(run, norm(c.gravity.acceleration));
  read_base_shear(run, out);
  read_cuts(run, c, out);
  return out;
}

}  // namespace voussoir::io
