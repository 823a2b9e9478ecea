// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/measures/crack_extents.h"

#include <cmath>

#include "io/files/errors.h"
#include "io/replay/joint_openings.h"

namespace voussoir::io {

Cracks::Cracks(const Hdf5File& run, const Building& building, const std::vector<Pose>& start) {
  const std::vector<double> since = joint_opening_times(run);
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto area = run.read<double>("/model/joint/area"), centre = run.read<double>("/model/joint/centre");
  if (b.size() != since.size() || centre.size() != 3 * since.size()) throw FileError(run.path(), "/model/joint does not fit together");
  const auto elements = static_cast<std::int64_t>(start.size());
  for (std::size_t j = 0; j < since.size(); ++j) {
    if (a[j] < 0 || a[j] >= elements || b[j] >= elements)
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no element");
    if (!std::isfinite(since[j])) continue;
    const auto ea = static_cast<std::size_t>(a[j]), eb = static_cast<std::size_t>(b[j]);
    const Vec3 c{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    const std::int32_t wall_a = building.wall[ea], wall_b = b[j] < 0 || building.wall[eb] == wall_a ? -1 : building.wall[eb];
    if (wall_a >= 0 || wall_b >= 0)
      joints_.push_back({since[j], area[j], a[j], b[j], wall_a, wall_b, c - start[ea].centre, b[j] < 0 ? c : c - start[eb].centre});
  }
  for (const Wall& w : building.walls) section_.push_back(w.length() * w.thickness());
}

std::vector<CrackExtent> Cracks::extents(double time, const std::vector<Pose>& poses) const {
  std::vector<CrackExtent> extents(section_.size());
  for (const OpenJoint& j : joints_) {
    if (j.time > time) continue;
    const Vec3 b = j.b < 0 ? j.from_b : poses[static_cast<std::size_t>(j.b)].point(j.from_b);
    const double width = norm(b - poses[static_cast<std::size_t>(j.a)].point(j.from_a));
    for (const std::int32_t w : {j.wall_a, j.wall_b}) {
      if (w < 0) continue;
      CrackExtent& of_wall = extents[static_cast<std::size_t>(w)];
      const double share = j.area / section_[static_cast<std::size_t>(w)];
      if (j.time >= 0) of_wall.any += share;
      if (width >= kFineCrack) of_wall.fine += share;
      if (width >= kLargeCrack) of_wall.large += share;
    }
  }
  return extents;
}

}  // namespace voussoir::io
