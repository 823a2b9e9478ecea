// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cases/case.h"
#include "geometry/message.h"
#include "geometry/nth.h"

namespace voussoir::io {
namespace {

using geometry::Point2;

constexpr const char* kInk = "#333";
constexpr double kType = 11.0, kStroke = 3.5, kInset = 14.0;  // user units
constexpr double kArrow = 22.0;

bool plain(const cases::Case& c) { return c.house && c.house->turn == 0.0 && c.house->copies == std::array<int, 2>{1, 1}; }
bool along_x(const std::string& wall) { return wall == "front" || wall == "rear"; }
/// Height of a storey's foot above that of the walls [m].
double foot_of(const cases::House& house, int storey) {
  double foot = storey > 1 ? house.height : 0.0;
  for (int above = 2; above < storey; ++above) foot += nth(house.storeys, above - 2).height;
  return foot;
}
bool stands(const cases::House& house, const char* wall) { return std::ranges::find(house.walls, wall) != house.walls.end(); }

}  // namespace

std::string metres_text(double metres) { return geometry::printed("%.2f", metres); }

void draw_dimension(Svg& svg, Point2 a, Point2 b, double metres) {
  svg.line(a, b, kInk, 0.8);
  for (const Point2 p : {a, b}) svg.line({p.s - kStroke, p.t + kStroke}, {p.s + kStroke, p.t - kStroke}, kInk, 1.2);
  const Point2 middle{0.5 * (a.s + b.s), 0.5 * (a.t + b.t)};
  const bool across = std::abs(b.s - a.s) > std::abs(b.t - a.t);
  svg.text(across ? Point2{middle.s, middle.t - 3.0} : Point2{middle.s + 4.0, middle.t + 4.0}, metres_text(metres), kType,
           across ? "middle" : "start", kInk);
}

void draw_opening_dimensions(Svg& svg, const cases::Case& c, const std::string& wall, const geometry::Box3& box, const Projection& at,
                             double below) {
  if (!plain(c)) return;
  const bool x = along_x(wall);
  const double base = c.base ? c.base->z : 0.0;
  // Coordinates in the plane of the wall: along and up. The view ignores the third direction.
  const auto place = [&](double along, double z) { return x ? at({along, box.low.y, z}) : at({box.low.x, along, z}); };
  std::vector<double> edges{x ? box.low.x : box.low.y, x ? box.high.x : box.high.y};
  for (const cases::Opening& o : c.house->openings) {
    if (o.wall != wall) continue;
    const double from = c.house->origin[x ? 0 : 1] + o.from, to = from + o.width, foot = base + foot_of(*c.house, o.storey);
    const double sill = foot + o.sill, top = sill + o.height;
    if (o.storey == 1) edges.insert(edges.end(), {from, to});  // below the view: lengths between edges in the lowest storey
    Point2 low = place(from, sill), high = place(to, top);
    if (low.s > high.s) std::swap(low.s, high.s);
    draw_dimension(svg, {low.s, low.t - kInset}, {high.s, low.t - kInset}, o.width);
    draw_dimension(svg, {low.s + kInset, low.t}, {low.s + kInset, high.t}, o.height);
    if (o.sill > 0.0) draw_dimension(svg, {low.s + kInset, place(from, foot).t}, {low.s + kInset, low.t}, o.sill);
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i + 1 < edges.size() && edges.size() > 2; ++i) {
    const Point2 a = place(edges[i], box.low.z), b = place(edges[i + 1], box.low.z);
    draw_dimension(svg, {std::min(a.s, b.s), a.t + below}, {std::max(a.s, b.s), a.t + below}, edges[i + 1] - edges[i]);
  }
}

void draw_thicknesses(Svg& svg, const cases::Case& c, double z, const Projection& at) {
  if (!plain(c)) return;
  const cases::House& h = *c.house;
  // The outer corner of the front and the left wall is the origin; front and rear walls are bearing walls.
  const double x = h.origin[0], y = h.origin[1], bearing = h.bearing_wall, other = h.nonbearing_wall;
  const double aside = x + other + 0.25 * h.inner_size[0], across = y + bearing + 0.25 * h.inner_size[1];
  if (stands(h, "rear")) {
    const double from = y + bearing + h.inner_size[1];
    draw_dimension(svg, at({aside, from, z}), at({aside, from + bearing, z}), bearing);
  }
  if (stands(h, "left")) draw_dimension(svg, at({x, across, z}), at({x + other, across, z}), other);
}

void draw_axes(Svg& svg, Point2 corner, Vec3 right, Vec3 up) {
  const std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = dot(axes[k], right), t = -dot(axes[k], up);
    if (s * s + t * t < 0.5) continue;
    const Point2 end{corner.s + kArrow * s, corner.t + kArrow * t};
    svg.line(corner, end, kInk, 1.2);
    for (const double side : {-1.0, 1.0})  // arrow heads
      svg.line(end, {end.s - 5.0 * s + 2.5 * side * t, end.t - 5.0 * t + 2.5 * side * s}, kInk, 1.2);
    svg.text({end.s + 7.0 * s, end.t + 7.0 * t + 3.5}, std::string(1, "xyz"[k]), kType, "middle", kInk);
  }
}

void draw_scale_bar(Svg& svg, Point2 left, double scale) {
  double length = 0.1;
  for (const double m : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
    if (m * scale <= 160.0) length = m;
  const double end = left.s + length * scale;
  svg.line(left, {end, left.t}, kInk, 2.0);
  for (const double s : {left.s, 0.5 * (left.s + end), end}) svg.line({s, left.t - 5.0}, {s, left.t}, kInk, 1.5);
  svg.text({left.s, left.t + 12.0}, "0", kType, "middle", kInk);
  svg.text({end, left.t + 12.0}, geometry::printed("%g m", length), kType, "middle", kInk);
}

}  // namespace voussoir::io
