// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon.h"

#include <algorithm>

namespace voussoir::geometry {

Region region(std::span<const Point2> polygon) {
  if (polygon.size() < 3) return {};
  const Point2 first = polygon[0];
  double doubled = 0.0, moment_s = 0.0, moment_t = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const double as = polygon[i].s - first.s, at = polygon[i].t - first.t;
    const double bs = polygon[i + 1].s - first.s, bt = polygon[i + 1].t - first.t;
    const double weight = as * bt - at * bs;
    doubled += weight;
    moment_s += weight * (as + bs);
    moment_t += weight * (at + bt);
  }
  if (!(doubled > 0.0)) return {0.0, first};
  return {0.5 * doubled, {first.s + moment_s / (3.0 * doubled), first.t + moment_t / (3.0 * doubled)}};
}

Rectangle bounds(std::span<const Point2> polygon) {
  Rectangle r{polygon[0], polygon[0]};
  for (const Point2& p : polygon) {
    r.low = {std::min(r.low.s, p.s), std::min(r.low.t, p.t)};
    r.high = {std::max(r.high.s, p.s), std::max(r.high.t, p.t)};
  }
  return r;
}

std::optional<Rectangle> as_rectangle(std::span<const Point2> polygon) {
  if (polygon.size() != 4) return std::nullopt;
  const bool along_s =
      polygon[0].t == polygon[1].t && polygon[1].s == polygon[2].s && polygon[2].t == polygon[3].t && polygon[3].s == polygon[0].s;
  const bool along_t =
      polygon[0].s == polygon[1].s && polygon[1].t == polygon[2].t && polygon[2].s == polygon[3].s && polygon[3].t == polygon[0].t;
  if (!along_s && !along_t) return std::nullopt;
  return bounds(polygon);
}

Polygon to_polygon(const Rectangle& r) { return {r.low, {r.high.s, r.low.t}, r.high, {r.low.s, r.high.t}}; }

void clip(Polygon& polygon, Point2 normal, double offset, Polygon& scratch) {
  scratch.clear();
  const auto height = [&](Point2 p) { return normal.s * p.s + normal.t * p.t - offset; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double hp = height(p), hq = height(q);
    if (hp <= 0.0) scratch.push_back(p);
    if ((hp < 0.0 && hq > 0.0) || (hp > 0.0 && hq < 0.0)) {
      const double f = hp / (hp - hq);
      scratch.push_back({p.s + f * (q.s - p.s), p.t + f * (q.t - p.t)});
    }
  }
  polygon.swap(scratch);
}

Polygon intersection(const Polygon& a, const Polygon& b) {
  const auto ra = as_rectangle(a), rb = as_rectangle(b);
  if (ra && rb) {
    const Rectangle r{{std::max(ra->low.s, rb->low.s), std::max(ra->low.t, rb->low.t)},
                      {std::min(ra->high.s, rb->high.s), std::min(ra->high.t, rb->high.t)}};
    return r.low.s < r.high.s && r.low.t < r.high.t ? to_polygon(r) : Polygon{};
  }
  Polygon out = a, scratch;
  for (std::size_t i = 0; i < b.size() && !out.empty(); ++i) {
    const Point2 p = b[i], q = b[(i + 1) % b.size()];
    const Point2 outward{q.t - p.t, p.s - q.s};
    clip(out, outward, outward.s * p.s + outward.t * p.t, scratch);
  }
  return region(out).area > 0.0 ? out : Polygon{};
}

}  // namespace voussoir::geometry
