// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/limit/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace voussoir::solver {
namespace {

using geometry::Point2;

constexpr double kNothing = 1e-9;  // of the size of the hull

double distance(Point2 a, Point2 b) { return std::hypot(a.s - b.s, a.t - b.t); }
double turn(Point2 o, Point2 a, Point2 b) { return (a.s - o.s) * (b.t - o.t) - (a.t - o.t) * (b.s - o.s); }

/// How far p lies off the segment from a to b.
double off_line(Point2 p, Point2 a, Point2 b) {
  const double length = distance(a, b);
  if (length == 0.0) return distance(p, a);
  const double along = ((p.s - a.s) * (b.s - a.s) + (p.t - a.t) * (b.t - a.t)) / length;
  if (along < 0.0) return distance(p, a);
  return along > length ? distance(p, b) : std::abs(turn(a, b, p)) / length;
}

/// All corners, as exact as differences of coordinates are: equal points and those on an edge are left out.
std::vector<std::size_t> all_corners(const std::vector<Point2>& p, std::vector<std::size_t> order) {
  std::vector<std::size_t> hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t begin = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= begin + 2 && turn(p[hull[hull.size() - 2]], p[hull.back()], p[*first]) <= 0.0) hull.pop_back();
      hull.push_back(*first);
    }
    hull.pop_back();  // it begins the other chain
  };
  chain(order.begin(), order.end());
  chain(order.rbegin(), order.rend());
  return hull;
}

}  // namespace

std::vector<std::size_t> hull_corners(const std::vector<Point2>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    if (p[a].s != p[b].s) return p[a].s < p[b].s;
    return p[a].t != p[b].t ? p[a].t < p[b].t : a < b;
  });
  order.erase(std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] == p[b]; }), order.end());
  if (order.size() < 2) return order;
  std::vector<std::size_t> hull = all_corners(p, order);
  double size = 0.0;
  for (const std::size_t a : hull) size = std::max(size, distance(p[a], p[hull.front()]));
  // The flattest corner first: what is left out lies that near to an edge of what stays.
  while (hull.size() > 2) {
    std::size_t flattest = 0;
    double least = 2.0 * size;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const double off = off_line(p[hull[k]], p[hull[(k + hull.size() - 1) % hull.size()]], p[hull[(k + 1) % hull.size()]]);
      if (off < least) least = off, flattest = k;
    }
    if (least > kNothing * size) break;
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
  if (hull.size() == 2 && distance(p[hull[0]], p[hull[1]]) == 0.0) hull.pop_back();
  return hull;
}

}  // namespace voussoir::solver
