// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/replay/joint_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "io/files/errors.h"
#include "io/files/hdf5_file.h"
#include "io/replay/joint_openings.h"
#include "io/replay/placed_elements.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kMostEdges = 255;  // of a joint: as many as a byte holds

struct OpenJoint {
  std::size_t row;      // of /model/joint
  double time;          // when it came open, s
  std::int32_t a, b;    // elements; b = −1: the base
  Vec3 from_a, from_b;  // its centre from the elements' centroids, m; from_b of the base: from the origin

  [[nodiscard]] double width(const std::vector<Pose>& poses) const {
    const Vec3 at_b = b < 0 ? from_b : poses[static_cast<std::size_t>(b)].point(from_b);
    return norm(at_b - poses[static_cast<std::size_t>(a)].point(from_a));
  }
};

std::vector<OpenJoint> open_joints(const Hdf5File& run, const std::vector<double>& since, const std::vector<Pose>& start) {
  const auto a = run.read<std::int32_t>("/model/joint/element_a"), b = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre");
  if (a.size() != since.size() || b.size() != since.size() || centre.size() != 3 * since.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  const auto elements = static_cast<std::int64_t>(start.size());
  std::vector<OpenJoint> joints;
  for (std::size_t j = 0; j < since.size(); ++j) {
    if (!std::isfinite(since[j])) continue;
    if (a[j] < 0 || a[j] >= elements || b[j] >= elements)
      throw FileError(run.path(), "/model/joint: row " + std::to_string(j) + " refers to no element");
    const Vec3 c{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    joints.push_back({j, since[j], a[j], b[j], c - start[static_cast<std::size_t>(a[j])].centre,
                      b[j] < 0 ? c : c - start[static_cast<std::size_t>(b[j])].centre});
  }
  return joints;
}

}  // namespace

std::uint8_t crack_level(double width) noexcept {
  return static_cast<std::uint8_t>(std::ranges::upper_bound(kCrackWidths, std::max(width, 0.0)) - kCrackWidths.begin());
}

JointCracks joint_cracks(const Hdf5File& run, const FrameReader& frames) {
  const std::vector<double> since = joint_opening_times(run);
  const std::vector<OpenJoint> joints = open_joints(run, since, first_poses(frames));
  JointCracks out;
  out.shown.assign(since.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> rows;
  for (const OpenJoint& j : joints) rows.push_back(j.row);
  const auto edges = joint_edges(run, rows);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    out.elements.insert(out.elements.end(), {joints[i].a, joints[i].b});
    const std::size_t count = std::min(edges[i].size(), kMostEdges);
    out.edges.push_back(static_cast<std::uint8_t>(count));
    for (std::size_t k = 0; k < count; ++k)
      for (const Vec3& v : {edges[i][k].from, edges[i][k].to})
        for (const double x : {v.x, v.y, v.z}) out.ends.push_back(static_cast<float>(x));
  }
  for (std::uint64_t f = 0; f < frames.frames(); ++f) {
    const double time = frames.times()[f];
    const std::vector<Pose> poses = poses_of(frames, f);
    for (const OpenJoint& j : joints) {
      const double width = j.time > time ? -1.0 : j.width(poses);
      out.level.push_back(width < 0 ? std::uint8_t{0} : crack_level(width));
      if (width >= kFacesShow) out.shown[j.row] = std::min(out.shown[j.row], time);
    }
  }
  return out;
}

}  // namespace voussoir::io
