// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/replay/joint_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "io/input/files/errors.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/replay/joint_openings.h"
#include "io/output/replay/placed_elements.h"

namespace voussoir::io {
namespace {

constexpr std::size_t kMostEdges = 255;  // of a joint: limit of a byte

}  // namespace

std::uint8_t crack_level(double width) noexcept {
  return static_cast<std::uint8_t>(std::ranges::upper_bound(kCrackWidths, std::max(width, 0.0)) - kCrackWidths.begin());
}

JointCracks joint_cracks(const Hdf5File& run, const FrameReader& frames) {
  const std::vector<OpenJoint> joints = open_joints(run, first_poses(frames));
  JointCracks out;
  out.shown.assign(run.shape("/model/joint/element_a")[0], std::numeric_limits<double>::infinity());
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
