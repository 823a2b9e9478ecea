// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/assess/wall_cracks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/joint_openings.h"

namespace voussoir::io {
namespace {

constexpr double kSamePlace = 1e-6;  // m

/// Sorted values, without duplicates.
std::vector<double> lines(std::vector<double> at) {
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < kSamePlace; }), at.end());
  return at;
}

/// A wall's elevation divided by all edges of its elements into cells, with or without masonry.
struct Elevation {
  std::vector<double> u, z;   // m, lines
  std::vector<char> masonry;  // by cell, row by row

  [[nodiscard]] std::size_t columns() const { return u.size() - 1; }
  [[nodiscard]] std::size_t rows() const { return z.size() - 1; }
  [[nodiscard]] bool has(std::size_t column, std::size_t row) const { return masonry[row * columns() + column] != 0; }
};

bool overlap(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] - kSamePlace || b.low[k] > a.high[k] - kSamePlace) return false;
  return true;
}

Elevation elevation_of(const Building& b, std::int32_t wall) {
  const Wall& w = nth(b.walls, wall);
  const std::size_t axis = 1 - w.across;
  std::vector<Box> boxes;
  std::vector<double> u{w.box.low[axis], w.box.high[axis]}, z{w.box.low[2], w.box.high[2]};
  for (std::size_t e = 0; e < b.wall.size(); ++e) {
    const Box box = b.box_in(w, e);
    if (!overlap(box, w.box)) continue;  // also elements of adjoining walls, which alternate with those of this wall at corners
    boxes.push_back(box);
    for (const double at : {box.low[axis], box.high[axis]}) u.push_back(std::clamp(at, w.box.low[axis], w.box.high[axis]));
    for (const double at : {box.low[2], box.high[2]}) z.push_back(std::clamp(at, w.box.low[2], w.box.high[2]));
  }
  Elevation e{lines(std::move(u)), lines(std::move(z)), {}};
  e.masonry.assign(e.columns() * e.rows(), 0);
  for (const Box& box : boxes) {
    for (std::size_t i = 0; i < e.columns(); ++i) {
      const double at_u = 0.5 * (e.u[i] + e.u[i + 1]);
      if (at_u < box.low[axis] || at_u > box.high[axis]) continue;
      for (std::size_t k = 0; k < e.rows(); ++k) {
        const double at_z = 0.5 * (e.z[k] + e.z[k + 1]);
        if (at_z > box.low[2] && at_z < box.high[2]) e.masonry[k * e.columns() + i] = 1;
      }
    }
  }
  return e;
}

/// Numbers the openings: by cell, 0 for masonry, else 1, 2, ... by the leftmost cell (as seen from outside).
std::vector<int> openings_of(const Elevation& e, bool from_right) {
  std::vector<int> number(e.masonry.size(), 0);
  int last = 0;
  for (std::size_t c = 0; c < e.columns(); ++c) {
    const std::size_t column = from_right ? e.columns() - 1 - c : c;
    for (std::size_t row = 0; row < e.rows(); ++row) {
      if (e.has(column, row) || number[row * e.columns() + column] != 0) continue;
      ++last;
      std::vector<std::pair<std::size_t, std::size_t>> pending{{column, row}};
      while (!pending.empty()) {
        const auto [i, k] = pending.back();
        pending.pop_back();
        if (i >= e.columns() || k >= e.rows() || e.has(i, k) || number[k * e.columns() + i] != 0) continue;
        number[k * e.columns() + i] = last;
        for (const auto& [di, dk] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          pending.emplace_back(i + static_cast<std::size_t>(di), k + static_cast<std::size_t>(dk));
      }
    }
  }
  return number;
}

}  // namespace

std::vector<JointWidth> joint_widths(const Hdf5File& run, const Building& building, const std::vector<Pose>& start, double time,
                                     const std::vector<Pose>& poses) {
  const auto area = run.read<double>("/model/joint/area"), normal = run.read<double>("/model/joint/normal");
  if (normal.size() != 3 * area.size()) throw FileError(run.path(), "/model/joint does not fit together");
  std::vector<JointWidth> out;
  for (const OpenJoint& j : open_joints(run, start)) {
    if (j.time > time) continue;
    const auto ea = static_cast<std::size_t>(j.a), eb = static_cast<std::size_t>(std::max(j.b, 0));
    const Vec3 n{normal[3 * j.row], normal[3 * j.row + 1], normal[3 * j.row + 2]}, apart = j.apart(poses);
    const Vec3 across = j.b < 0 ? n : normalised(poses[ea].rotation * n + poses[eb].rotation * n);  // the mean normal, as in THEORY.md (7)
    JointWidth w{j.row, dot(apart, across), 0, norm(apart), area[j.row], j.centre, {building.wall[ea], -1}, OpeningKind::crack};
    if (w.width > JointWidth::kWidestCrack) w.kind = OpeningKind::parted;
    if (building.is_seat(j.a, j.b)) w.kind = OpeningKind::seat;
    w.sliding = norm(apart - w.opening * across);
    if (j.b >= 0 && building.wall[eb] != w.wall[0]) w.wall[1] = building.wall[eb];
    out.push_back(w);
  }
  return out;
}

std::vector<OpeningCorner> opening_corners(const Building& building, std::int32_t wall) {
  const Wall& w = nth(building.walls, wall);
  const Elevation e = elevation_of(building, wall);
  const bool mirrored = w.right() < 0;
  const std::vector<int> opening = openings_of(e, mirrored);
  std::vector<OpeningCorner> corners;
  for (std::size_t i = 1; i < e.columns(); ++i) {
    for (std::size_t k = 1; k < e.rows(); ++k) {
      int open = 0, number = 0;
      bool low_side = false, left = false;  // position of the opening's cell relative to the corner
      for (const std::size_t row : {k - 1, k}) {
        for (const std::size_t column : {i - 1, i}) {
          if (e.has(column, row)) continue;
          ++open, number = opening[row * e.columns() + column];
          low_side = row == k - 1, left = (column == i - 1) != mirrored;
        }
      }
      if (open != 1) continue;
      // An opening is below its upper corners, and to the left of its right ones.
      corners.push_back(
          {wall, "opening " + std::to_string(number) + (low_side ? ", upper " : ", lower ") + (left ? "right" : "left"), e.u[i], e.z[k]});
    }
  }
  std::ranges::stable_sort(corners, {}, &OpeningCorner::name);
  return corners;
}

void CrackFigures::add(const JointWidth& j) {
  if (j.width < kHair) return;
  ++joints;
  largest = std::max(largest, j.width);
  largest_opening = std::max(largest_opening, j.opening), largest_sliding = std::max(largest_sliding, j.sliding);
  area_ += j.area, sum_ += j.area * j.width;
}

void CrackFigures::finish() { mean = area_ > 0 ? sum_ / area_ : 0.0; }

bool is_crack_of(const JointWidth& joint, std::int32_t wall) {
  return joint.kind == OpeningKind::crack && joint.is_of(wall) && joint.width >= CrackFigures::kHair;
}

CrackFigures wall_figures(const std::vector<JointWidth>& joints, std::int32_t wall) {
  CrackFigures f;
  for (const JointWidth& j : joints)
    if (is_crack_of(j, wall)) f.add(j);
  f.finish();
  return f;
}

CrackFigures seat_figures(const std::vector<JointWidth>& joints, std::int32_t wall) {
  CrackFigures f;
  for (const JointWidth& j : joints)
    if (j.kind == OpeningKind::seat && j.is_of(wall)) f.add(j);
  f.finish();
  return f;
}

std::size_t parted_joints(const std::vector<JointWidth>& joints, std::int32_t wall) {
  return static_cast<std::size_t>(
      std::ranges::count_if(joints, [&](const JointWidth& j) { return j.kind == OpeningKind::parted && j.is_of(wall); }));
}

CrackFigures corner_figures(const std::vector<JointWidth>& joints, const Building& building, const OpeningCorner& corner) {
  const Wall& w = nth(building.walls, corner.wall);
  CrackFigures f;
  for (const JointWidth& j : joints) {
    if (is_crack_of(j, corner.wall) && std::hypot(w.along(j.centre) - corner.along, j.centre.z - corner.z) <= CrackFigures::kNear) f.add(j);
  }
  f.finish();
  return f;
}

}  // namespace voussoir::io
