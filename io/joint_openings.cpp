// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/joint_openings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "io/errors.h"
#include "io/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kHalf = 0.499;  // of a joint: areas of segments are sums with round-off

}  // namespace

std::vector<double> joint_opening_times(const Hdf5File& run) {
  const auto area = run.read<double>("/model/joint/area"), broken = run.read<double>("/cracks/area"),
             time = run.read<double>("/cracks/time");
  const auto element_a = run.read<std::int32_t>("/model/joint/element_a"), joint = run.read<std::int32_t>("/cracks/joint"),
             from = run.read<std::int32_t>("/cracks/element_a");
  if (area.size() != element_a.size() || broken.size() != joint.size() || from.size() != joint.size() || time.size() != joint.size())
    throw FileError(run.path(), "/cracks does not fit together, or to /model/joint");
  std::vector<std::array<double, 2>> open(area.size());  // m2, of the segments that either face masters
  std::vector<double> since(area.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const auto j = static_cast<std::size_t>(joint[i]);
    if (j >= area.size()) throw FileError(run.path(), "/cracks/joint: row " + std::to_string(i) + " refers to no joint");
    double& of_side = open[j][from[i] == element_a[j] ? 0 : 1];
    of_side += broken[i];
    if (of_side >= kHalf * area[j]) since[j] = std::min(since[j], time[i]);
  }
  return since;
}

}  // namespace voussoir::io
