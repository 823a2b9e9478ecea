// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/hanging_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/nth.h"
#include "io/input/files/errors.h"
#include "io/output/replay/joint_cracks.h"

namespace voussoir::io {
namespace {

constexpr double kBed = 0.5;     // |z| of the normal of a bed joint, at least
constexpr double kMeet = 1e-2;   // m: two gaps with less masonry between them are one
constexpr double kSunkBy = 0.5;  // of the gap: by so much what is below has sunk, at least; else the wall has risen

/// A bed joint that is open.
struct Gap {
  std::int32_t wall = -1;
  std::size_t row = 0;  // of /model/joint
  double width = 0;     // m
  double z = 0;         // m
};

/// Height of a point of an element now [m]. \param element  −1: the base
double height_now(std::int32_t element, Vec3 at, const std::vector<Pose>& start, const std::vector<Pose>& poses) {
  if (element < 0) return at.z;
  return nth(poses, element).point(at - nth(start, element).centre).z;
}

/// Whether a point lies within a wall, as that of a brick at a corner does that is counted to the wall beside.
bool is_within(const Wall& w, Vec3 point) {
  const Vec3 at = w.axes.of(point);
  for (const std::size_t axis : {0UL, 1UL, 2UL})
    if (component(at, axis) < w.box.low[axis] - kMeet || component(at, axis) > w.box.high[axis] + kMeet) return false;
  return true;
}

std::vector<Gap> gaps_of(const Hdf5File& run, const Building& b, const std::vector<Pose>& start, const std::vector<Pose>& poses) {
  const auto first = run.read<std::int32_t>("/model/joint/element_a"), second = run.read<std::int32_t>("/model/joint/element_b");
  const auto centre = run.read<double>("/model/joint/centre"), normal = run.read<double>("/model/joint/normal");
  if (second.size() != first.size() || centre.size() != 3 * first.size() || normal.size() != centre.size())
    throw FileError(run.path(), "/model/joint does not fit together");
  std::vector<Gap> gaps;
  for (std::size_t j = 0; j < first.size(); ++j) {
    if (std::abs(normal[3 * j + 2]) < kBed) continue;
    std::int32_t above = first[j], below = second[j];
    if (below >= 0 && nth(start, below).centre.z > nth(start, above).centre.z) std::swap(above, below);
    const std::int32_t wall = nth(b.wall, above);
    if (wall < 0) continue;
    const Vec3 at{centre[3 * j], centre[3 * j + 1], centre[3 * j + 2]};
    const double low = height_now(below, at, start, poses), width = height_now(above, at, start, poses) - low;
    if (width < HangingWall::kGap || at.z - low < kSunkBy * width) continue;
    for (std::int32_t w = 0; w < static_cast<std::int32_t>(b.walls.size()); ++w) {
      const Wall& beside = nth(b.walls, w);
      const bool same_storey = beside.house == nth(b.walls, wall).house && beside.storey == nth(b.walls, wall).storey;
      if (w == wall || (same_storey && is_within(beside, at))) gaps.push_back({w, j, width, at.z});
    }
  }
  return gaps;
}

using Span = std::array<double, 2>;

/// Spans without overlap, in order.
std::vector<Span> united(std::vector<Span> spans) {
  std::ranges::sort(spans);
  std::vector<Span> out;
  for (const Span& s : spans) {
    if (!out.empty() && s[0] <= out.back()[1] + kMeet)
      out.back()[1] = std::max(out.back()[1], s[1]);
    else
      out.push_back(s);
  }
  return out;
}

}  // namespace

std::vector<HangingWall> hanging_walls(const Hdf5File& run, const Building& b, const std::vector<Pose>& start,
                                       const std::vector<Pose>& poses) {
  const std::vector<Gap> gaps = gaps_of(run, b, start, poses);
  std::vector<std::size_t> rows;
  for (const Gap& g : gaps) rows.push_back(g.row);
  const auto corners = joint_corners(run, rows);
  std::map<std::int32_t, std::vector<Span>> spans;
  std::map<std::int32_t, HangingWall> of_wall;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Wall& w = nth(b.walls, gaps[i].wall);
    Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vec3& p : corners[i]) {
      const double along = w.along(p);
      const double at = w.right() > 0 ? along - w.box.low[1 - w.across] : w.box.high[1 - w.across] - along;
      const double inside = std::clamp(at, 0.0, w.length());
      span = {std::min(span[0], inside), std::max(span[1], inside)};
    }
    spans[gaps[i].wall].push_back(span);
    HangingWall& h = of_wall[gaps[i].wall];
    if (gaps[i].width > h.gap) h.gap = gaps[i].width, h.height = b.height_of(gaps[i].z);
  }
  std::vector<HangingWall> out;
  for (auto& [wall, h] : of_wall) {
    const std::vector<Span> all = united(spans[wall]);
    h.wall = nth(b.walls, wall).name, h.from = all.front()[0], h.to = all.back()[1];
    for (const Span& s : all) h.length += s[1] - s[0];
    out.push_back(h);
  }
  return out;
}

}  // namespace voussoir::io
