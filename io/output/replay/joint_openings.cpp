// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/joint_openings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kHalf = 0.499;  // of a joint's area, to allow for round-off in sums of areas

}  // namespace

std::vector<double> joint_opening_times(const Hdf5File& run) {
  const auto area = run.read<double>("/model/joint/area"), broken = run.read<double>("/cracks/area"),
             time = run.read<double>("/cracks/time");
  const auto joint = run.read<std::int32_t>("/cracks/joint");
  if (broken.size() != joint.size() || time.size() != joint.size())
    throw FileError(run.path(), "/cracks does not fit together, or to /model/joint");
  std::vector<double> open(area.size());  // m2; where both faces have springs of their own, each counts for half of its segment's area
  std::vector<double> since(area.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const auto j = static_cast<std::size_t>(joint[i]);
    if (j >= area.size()) throw FileError(run.path(), "/cracks/joint: row " + std::to_string(i) + " refers to no joint");
    open[j] += broken[i];
    if (open[j] >= kHalf * area[j]) since[j] = std::min(since[j], time[i]);
  }
  return since;
}

std::vector<OpenJoint> open_joints(const Hdf5File& run, const std::vector<Pose>& start) {
  const std::vector<double> since = joint_opening_times(run);
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre");
  if (a.size() != since.size() || b.size() != since.size() || centre.size() != 3 * since.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  const auto elements = static_cast<std::int64_t>(start.size());
  std::vector<OpenJoint> joints;
  for (std::size_t j = 0; j < since.size(); ++j) {
    if (a[j] < 0 || a[j] >= elements || b[j] >= elements)
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no element");
    if (!std::isfinite(since[j])) continue;
    const Vec3 c{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    joints.push_back({j, since[j], a[j], b[j], c, c - nth(start, a[j]).centre, b[j] < 0 ? c : c - nth(start, b[j]).centre});
  }
  return joints;
}

}  // namespace voussoir::io
