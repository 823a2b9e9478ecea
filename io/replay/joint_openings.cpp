// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/replay/joint_openings.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "io/files/errors.h"
#include "io/files/hdf5_file.h"

namespace voussoir::io {
namespace {

constexpr double kHalf = 0.499;  // of a joint: areas of segments are sums with round-off

}  // namespace

std::vector<double> joint_opening_times(const Hdf5File& run) {
  const auto area = run.read<double>("/model/joint/area"), broken = run.read<double>("/cracks/area"),
             time = run.read<double>("/cracks/time");
  const auto joint = run.read<std::int32_t>("/cracks/joint");
  if (broken.size() != joint.size() || time.size() != joint.size())
    throw FileError(run.path(), "/cracks does not fit together, or to /model/joint");
  std::vector<double> open(area.size());  // m2; where both faces have springs of their own, each spring has half of its segment's area
  std::vector<double> since(area.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const auto j = static_cast<std::size_t>(joint[i]);
    if (j >= area.size()) throw FileError(run.path(), "/cracks/joint: row " + std::to_string(i) + " refers to no joint");
    open[j] += broken[i];
    if (open[j] >= kHalf * area[j]) since[j] = std::min(since[j], time[i]);
  }
  return since;
}

}  // namespace voussoir::io
