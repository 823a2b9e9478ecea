// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/wall_dimensions.h"

#include <algorithm>
#include <cmath>

namespace voussoir::io {
namespace {

using cases::OutlinedOpening;
using cases::WallOutline;
using geometry::Point2;

constexpr double kChain = 16.0, kWithin = 14.0;  // user units: of dimensions from a face, and from the edge of an opening
constexpr double kLetters = 11.0, kName = 8.0;   // size; of a name from the face
constexpr double kSquare = 1e-3;                 // rad, of a wall to the view

bool meets(const OutlinedOpening& o, double height) { return o.low < height && height < o.high; }

Vec3 point(const WallOutline& w, double s, double d, double z) {
  const Vec3 p = w.from + s * w.along + d * w.left;
  return {p.x, p.y, z};
}

/// The middle of all walls in plan.
Vec3 middle(const std::vector<WallOutline>& walls) {
  Vec3 sum;
  double length = 0.0;
  for (const WallOutline& w : walls) sum += w.length * (w.from + 0.5 * w.length * w.along), length += w.length;
  return (1.0 / length) * sum;
}

/// The side of a wall that looks away from the middle of all: 1: left, −1: right.
double outer_side(const WallOutline& w, Vec3 middle) { return dot(w.from + 0.5 * w.length * w.along - middle, w.left) < 0.0 ? -1.0 : 1.0; }

/// Lengths from corner to opening to opening to corner, `kChain` off the outer face.
void draw_chain(Svg& svg, const WallOutline& w, double z, double height, double side, const Projection& at) {
  std::vector<double> places{0.0, w.length};
  for (const OutlinedOpening& o : w.openings) {
    if (meets(o, height)) places.insert(places.end(), {o.from, o.to});
  }
  std::ranges::sort(places);
  const Point2 inner = at(point(w, 0.0, 0.0, z)), outer = at(point(w, 0.0, side * w.half, z));
  const double units = std::hypot(outer.s - inner.s, outer.t - inner.t);
  const double off = side * w.half * (units + kChain) / units;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    draw_dimension(svg, at(point(w, places[i], off, z)), at(point(w, places[i + 1], off, z)), w.along_line * (places[i + 1] - places[i]));
}

/// Whether a wall lies before the middle of an opening in the view.
bool hides(const WallOutline& front, const WallOutline& w, const OutlinedOpening& o, const Sight& sight) {
  const Vec3 a = point(front, 0.0, 0.0, 0.0), b = point(front, front.length, 0.0, 0.0), m = point(w, 0.5 * (o.from + o.to), 0.0, 0.0);
  const double one = dot(a, sight.right), other = dot(b, sight.right), here = dot(m, sight.right), height = 0.5 * (o.low + o.high);
  return std::min(one, other) < here && here < std::max(one, other) && front.foot < height && height < front.top &&
         dot(0.5 * (a + b), sight.into) < dot(m, sight.into) - w.half;
}

/// The name and the thickness of a wall, beside its inner face.
void draw_name(Svg& svg, const WallOutline& w, double z, double side, const Projection& at) {
  const Point2 middle = at(point(w, 0.5 * w.length, 0.0, z)), face = at(point(w, 0.5 * w.length, -side * w.half, z));
  const double units = std::hypot(face.s - middle.s, face.t - middle.t);
  const Point2 out{(face.s - middle.s) / units, (face.t - middle.t) / units};
  const char* anchor = std::abs(out.s) < 0.5 ? "middle" : out.s > 0.0 ? "start" : "end";
  svg.text({face.s + kName * out.s, face.t + 1.4 * kName * out.t + 4.0}, w.name + ", " + metres_text(2.0 * w.half), kLetters, anchor);
}

void draw_opening(Svg& svg, const WallOutline& w, const OutlinedOpening& o, double base, const Projection& at) {
  Point2 low = at(point(w, o.from, 0.0, base + o.low)), high = at(point(w, o.to, 0.0, base + o.high));
  if (low.s > high.s) std::swap(low.s, high.s);
  draw_dimension(svg, {low.s, low.t - kWithin}, {high.s, low.t - kWithin}, w.along_line * (o.to - o.from));
  draw_dimension(svg, {low.s + kWithin, low.t}, {low.s + kWithin, high.t}, o.high - o.low);
  const double foot = at(point(w, o.from, 0.0, base + w.foot)).t;
  if (o.low > w.foot + 1e-6) draw_dimension(svg, {low.s + kWithin, foot}, {low.s + kWithin, low.t}, o.low - w.foot);
}

}  // namespace

std::vector<double> plan_heights(const std::vector<WallOutline>& walls, std::size_t most) {
  std::vector<OutlinedOpening> left;
  for (const WallOutline& w : walls) left.insert(left.end(), w.openings.begin(), w.openings.end());
  std::vector<double> heights;
  while (!left.empty() && heights.size() < most) {
    double best = 0.0;
    std::ptrdiff_t count = -1;
    for (const OutlinedOpening& o : left) {  // a little below the top of an opening it meets all that any height meets
      const double height = o.high - 0.1 * (o.high - o.low);
      const auto met = std::ranges::count_if(left, [&](const OutlinedOpening& p) { return meets(p, height); });
      if (met > count || (met == count && height < best)) best = height, count = met;
    }
    heights.push_back(best);
    std::erase_if(left, [&](const OutlinedOpening& o) { return meets(o, best); });
  }
  if (heights.empty() && !walls.empty()) {
    const WallOutline& lowest = *std::ranges::min_element(walls, {}, &WallOutline::foot);
    heights.push_back(0.5 * (lowest.foot + lowest.top));
  }
  std::ranges::sort(heights);
  return heights;
}

void draw_wall_plan(Svg& svg, const std::vector<WallOutline>& walls, double base, double height, const Projection& at) {
  if (walls.empty()) return;
  const Vec3 centre = middle(walls);
  const WallOutline* before = nullptr;
  for (const WallOutline& w : walls) {
    const auto met = [&](const OutlinedOpening& o) { return meets(o, height); };
    if ((height < w.foot || height > w.top) && std::ranges::none_of(w.openings, met)) continue;
    const double z = base + height, side = outer_side(w, centre);
    if (before == nullptr || before->name != w.name) draw_name(svg, w, z, side, at);
    if (!w.bent) draw_chain(svg, w, z, height, side, at);
    before = &w;
  }
}

void draw_wall_openings(Svg& svg, const std::vector<WallOutline>& walls, double base, const Sight& sight, const Projection& at) {
  for (const WallOutline& w : walls) {
    if (std::abs(dot(w.along, sight.into)) > kSquare) continue;
    for (const OutlinedOpening& o : w.openings) {
      const auto hidden = [&](const WallOutline& front) { return hides(front, w, o, sight); };
      if (std::ranges::none_of(walls, hidden)) draw_opening(svg, w, o, base, at);
    }
  }
}

}  // namespace voussoir::io
