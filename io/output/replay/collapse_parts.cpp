// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/collapse_parts.h"

#include <algorithm>
#include <utility>

#include "io/input/files/hdf5_file.h"
#include "io/output/replay/placed_elements.h"
#include "solver/analysis/rigid_parts.h"

namespace voussoir::io {
namespace {

constexpr double kMisfit = 0.2;  // of the motion: greatest residual of rigid parts, 4 % of the mean square
constexpr double kSmall = 0.02;  // of the height: limit of the displacement for which rotations are small
constexpr double kMoves = 5e-4;  // m: smaller displacements count as none

double largest(const std::vector<Pose>& from, const std::vector<Pose>& to) {
  double most = 0.0;
  for (std::size_t e = 0; e < from.size(); ++e) most = std::max(most, norm(to[e].centre - from[e].centre));
  return most;
}

double height_of(const std::vector<Pose>& start) {
  const auto [low, high] = std::ranges::minmax_element(start, {}, [](const Pose& p) { return p.centre.z; });
  return high->centre.z - low->centre.z;
}

}  // namespace

CollapseParts collapse_parts(const Hdf5File& run, const FrameReader& frames, const std::vector<double>& mass, double peak) {
  const auto& times = frames.times();
  const std::vector<Pose> start = first_poses(frames);
  CollapseParts out;
  out.from = std::min(static_cast<std::uint64_t>(std::ranges::lower_bound(times, peak) - times.begin()), frames.frames() - 1);
  std::vector<Pose> before = poses_of(frames, out.from), after = before;
  const double far = std::max(kMoves, kSmall * height_of(start));
  for (out.to = out.from; out.to + 1 < frames.frames() && largest(before, after) < far;) after = poses_of(frames, ++out.to);
  if (largest(before, after) < kMoves) after = std::exchange(before, start), out.to = std::exchange(out.from, 0);
  solver::ElementMotion motion;
  motion.mass = mass;
  for (std::size_t e = 0; e < start.size(); ++e) {
    motion.centre.push_back(before[e].centre);
    motion.displacement.push_back(after[e].centre - before[e].centre);
  }
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  for (std::size_t j = 0; j < std::min(a.size(), b.size()); ++j) motion.touching.push_back({a[j], b[j]});
  out.part = solver::rigid_parts(motion, kMisfit);
  return out;
}

}  // namespace voussoir::io
