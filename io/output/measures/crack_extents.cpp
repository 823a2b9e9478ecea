// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/crack_extents.h"

#include <utility>

#include "geometry/nth.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {

Cracks::Cracks(const Hdf5File& run, const Building& building, const std::vector<Pose>& start) {
  const auto area = run.read<double>("/model/joint/area");
  for (const OpenJoint& j : open_joints(run, start)) {
    if (building.is_seat(j.a, j.b)) continue;
    const std::int32_t wall_a = nth(building.wall, j.a);
    const std::int32_t other = j.b < 0 ? -1 : nth(building.wall, j.b), wall_b = other == wall_a ? -1 : other;
    if (wall_a >= 0 || wall_b >= 0) joints_.push_back({j, area[j.row], wall_a, wall_b});
  }
  for (const Wall& w : building.walls) section_.push_back(w.length() * w.thickness());
}

std::vector<CrackExtent> Cracks::extents(double time, const std::vector<Pose>& poses) const {
  std::vector<CrackExtent> extents(section_.size());
  for (const CrackedJoint& j : joints_) {
    if (j.joint.time > time) continue;
    const double width = j.joint.width(poses);
    for (const std::int32_t w : {j.wall_a, j.wall_b}) {
      if (w < 0) continue;
      CrackExtent& of_wall = nth(extents, w);
      const double share = j.area / nth(section_, w);
      if (j.joint.time >= 0) of_wall.any += share;
      if (width >= kFineCrack) of_wall.fine += share;
      if (width >= kLargeCrack) of_wall.large += share;
    }
  }
  return extents;
}

std::optional<double> Cracks::first_time(std::size_t wall) const {
  std::optional<double> first;
  for (const CrackedJoint& j : joints_) {
    if (!std::cmp_equal(j.wall_a, wall) && !std::cmp_equal(j.wall_b, wall)) continue;
    if (j.joint.time >= 0 && !(first && *first <= j.joint.time)) first = j.joint.time;
  }
  return first;
}

}  // namespace voussoir::io
