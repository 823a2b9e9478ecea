// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/levers.h"

#include <algorithm>
#include <cmath>

#include "cases/case.h"
#include "geometry/segments/face_grid.h"

namespace voussoir::cases {

namespace {

constexpr double kMostAcross = 1e3;  // segments across; greater values come from joints that are no rectangles, where n is undefined

/// Extent of a joint along one axis and the cells along it, without its grid: the centres of n equal cells lie over b (1 − 1/n) and have
/// the second moment A b² (1 − 1/n²)/12. Clipped cells make n a fraction.
Lever lever_along(double low, double high, double area, double second_moment) {
  const double span = high - low;
  if (span <= 1e-9) return {0.0, 0.0, 1.0};
  const double width = std::sqrt(std::max(0.0, 12.0 * second_moment / area));  // b √(1 − 1/n²)
  const double ratio = std::max(1.0, width * width / (span * span));           // (1 + 1/n)/(1 − 1/n)
  const double short_by = (ratio - 1.0) / (ratio + 1.0);
  return {span / (1.0 - short_by), 0.0, 1.0 / std::max(short_by, 1e-9)};
}

/// The axis of a joint with fewer segments. The points of one row of cells give no extent; there it follows from the other axis and the
/// area.
Lever coarser(const geometry::Joint& j) {
  double s[2] = {1e300, -1e300}, t[2] = {1e300, -1e300}, area = 0.0, ss = 0.0, tt = 0.0;
  for (const geometry::Segment& p : j.side_a) {
    s[0] = std::min(s[0], p.s), s[1] = std::max(s[1], p.s), t[0] = std::min(t[0], p.t), t[1] = std::max(t[1], p.t);
    area += p.area, ss += p.area * p.s * p.s, tt += p.area * p.t * p.t;
  }
  Lever along_s = lever_along(s[0], s[1], area, ss), along_t = lever_along(t[0], t[1], area, tt);
  const bool one_s = along_s.width == 0.0, one_t = along_t.width == 0.0;
  if (one_s) along_s.width = one_t ? std::sqrt(area) : area / along_t.width;
  if (one_t) along_t.width = one_s ? std::sqrt(area) : area / along_s.width;
  return along_s.segments < along_t.segments ? along_s : along_t;
}

/// Adds the lever of a wall, unless one as thick is there.
void add_lever(double width, double height, double segment, std::vector<Lever>& out) {
  if (std::ranges::find(out, width, &Lever::width) == out.end()) out.push_back({width, height, geometry::cells_along(width, segment)});
}

std::vector<Lever> levers_of_walls(const House& h, const Model& model) {
  const auto brick = std::ranges::find(model.blocks, PartKind::brick, &Block::kind);
  if (brick == model.blocks.end()) return {};
  const auto built = [&h](const char* wall) { return std::ranges::find(h.walls, wall) != h.walls.end(); };
  std::vector<Lever> out;
  if (built("front") || built("rear")) add_lever(h.bearing_wall, h.height, brick->segment_size, out);
  if (built("left") || built("right")) add_lever(h.nonbearing_wall, h.height, brick->segment_size, out);
  return out;
}

std::vector<Lever> levers_of_plan(const Case& c, const Model& model) {
  std::vector<Lever> out;
  for (std::size_t i = 0; i < c.walls.size(); ++i) {
    const auto brick = std::ranges::find(model.blocks, static_cast<std::int32_t>(i), &Block::wall);
    add_lever(c.walls[i].thickness, c.walls[i].height, brick->segment_size, out);
  }
  return out;
}

}  // namespace

std::vector<Lever> levers(const Case& c, const Model& model) {
  if (c.segment_rule != geometry::SegmentRule::centres) return {};
  if (c.house) return levers_of_walls(*c.house, model);
  if (!c.walls.empty()) return levers_of_plan(c, model);
  Lever coarsest;
  for (std::size_t i = 0; i < model.assembly.joints.size(); ++i) {
    Lever l = coarser(model.assembly.joints[i]);
    if (l.segments > kMostAcross) continue;
    if (coarsest.joint >= 0 && l.segments >= coarsest.segments - 1e-6) continue;
    coarsest = l;
    coarsest.joint = static_cast<std::int32_t>(i);
  }
  return coarsest.joint >= 0 ? std::vector{coarsest} : std::vector<Lever>{};
}

}  // namespace voussoir::cases
