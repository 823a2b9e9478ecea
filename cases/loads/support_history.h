// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Histories of supports and of loads.
namespace voussoir::cases {

/// Displacement of a fixed block, or force of a load [N], as a function of time: piecewise linear, constant after its end, 0 before t[0].
/// With two samples and `open_ended`, the last slope continues (constant velocity).
struct SupportHistory {
  std::vector<double> time;        // s, ascending
  std::vector<Vec3> displacement;  // m; where the support turns: of `about`
  bool open_ended = false;
  std::string file{};            // not empty: file still to be read (t, x, y, z and for supports also rx, ry, rz); relative to Case::folder
  std::string key{};             // of the file in the case file, for messages
  std::vector<Vec3> rotation{};  // rad, rotation vectors by sample, the first one zero; empty: the support does not turn
  std::optional<Vec3> about{};   // m, point of the model about which it turns; none: the centroid of the block
};

/// Value of a history at a time [s]. \pre its file has been read
Vec3 value_at(const SupportHistory& h, double t);

/// Where a support is: displacement of its centroid [m] and orientation.
struct SupportPose {
  Vec3 displacement;
  Quaternion orientation;
};
/// \param centroid  of the support where it stands at first [m] \pre the history's file has been read
SupportPose pose_at(const SupportHistory& h, Vec3 centroid, double t);

}  // namespace voussoir::cases
