// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/rim_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/segments/face_grid.h"

namespace voussoir::geometry {

namespace {

constexpr double kSame = 1e-11;  // m, distance below which points are equal: above the raster of coordinates, far below any edge

Point2 operator-(Point2 a, Point2 b) { return {a.s - b.s, a.t - b.t}; }
double cross(Point2 a, Point2 b) { return a.s * b.t - a.t * b.s; }
double length(Point2 a) { return std::hypot(a.s, a.t); }

/// The polygon without corners that coincide with, or lie in line with, their neighbours.
Polygon cleaned(const Polygon& p) {
  Polygon out;
  for (const Point2 q : p) {
    if (out.empty() || length(q - out.back()) > kSame) out.push_back(q);
  }
  while (out.size() > 1 && length(out.front() - out.back()) <= kSame) out.pop_back();
  for (std::size_t i = 0; out.size() > 3 && i < out.size();) {
    const Point2 before = out[(i + out.size() - 1) % out.size()], chord = out[(i + 1) % out.size()] - before;
    if (cross(out[i] - before, chord) > kSame * length(chord)) {
      ++i;
    } else {
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return out;
}

int whole_cells_along(double extent, double size) { return static_cast<int>(cells_along(extent, size)); }

/// Points in [0, 1] and weights that sum to 1.
struct LineRule {
  std::vector<double> x, w;
};

/// Gauss-Lobatto rule on panels; rules of 3 and 4 points a panel are exact to the third and the fifth degree.
LineRule line_rule(int cells) {
  const bool three = cells < 4 || cells == 5;
  const int panels = three ? (cells == 5 ? 2 : 1) : (2 * cells + 1) / 6;  // round((cells − 1) / 3)
  const double at = 0.5 * (1.0 - std::sqrt(0.2));
  const std::vector<double> x = three ? std::vector{0.0, 0.5} : std::vector{0.0, at, 1.0 - at};  // without the last, 1
  const std::vector<double> w = three ? std::vector{1.0 / 6.0, 4.0 / 6.0} : std::vector{1.0 / 12.0, 5.0 / 12.0, 5.0 / 12.0};
  LineRule r;
  for (int k = 0; k < panels; ++k) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      r.x.push_back((k + x[i]) / panels);
      r.w.push_back((i == 0 && k > 0 ? 2.0 : 1.0) * w[i] / panels);
    }
  }
  r.x.push_back(1.0);
  r.w.push_back(w[0] / panels);
  for (std::size_t i = 0; i < r.x.size() / 2; ++i) r.x[r.x.size() - 1 - i] = 1.0 - r.x[i];  // exact mirror images, bit by bit
  return r;
}

void append_rectangle(const Rectangle& box, double size, std::vector<Segment>& out) {
  const double width = box.high.s - box.low.s, height = box.high.t - box.low.t;
  const LineRule s = line_rule(whole_cells_along(width, size)), t = line_rule(whole_cells_along(height, size));
  for (std::size_t j = 0; j < t.x.size(); ++j) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      out.push_back({box.low.s + s.x[i] * width, box.low.t + t.x[j] * height, (s.w[i] * t.w[j]) * (width * height)});
    }
  }
}

/// Points of a convex quadrilateral. The map x = bilinear in (ξ, η) has a Jacobian of first degree in each, so x² times the Jacobian is of
/// third degree.
void append_quadrilateral(const Polygon& p, double size, std::vector<Segment>& out) {
  const Point2 bottom = p[1] - p[0], top = p[2] - p[3], left = p[3] - p[0], right = p[2] - p[1];
  const LineRule s = line_rule(whole_cells_along(std::max(length(bottom), length(top)), size));
  const LineRule t = line_rule(whole_cells_along(std::max(length(left), length(right)), size));
  const Point2 twist = top - bottom;
  for (std::size_t j = 0; j < t.x.size(); ++j) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const double x = s.x[i], y = t.x[j];
      const Point2 along_x{bottom.s + y * twist.s, bottom.t + y * twist.t}, along_y{left.s + x * twist.s, left.t + x * twist.t};
      out.push_back(
          {p[0].s + x * bottom.s + y * along_y.s, p[0].t + x * bottom.t + y * along_y.t, (s.w[i] * t.w[j]) * cross(along_x, along_y)});
    }
  }
}

/// Points of triangles with one common corner, the apex. Coincident points become one; they are identified by number, since the same point
/// computed in two triangles need not have the same bits.
class TriangleFan {
 public:
  /// \param parts  into which each edge is cut; a triangle becomes parts × parts triangles
  TriangleFan(Point2 apex, int parts, std::vector<Segment>& out) : apex_(apex), parts_(parts), out_(out) {}

  /// Adds the triangle from the apex to corner number `k` and the next corner, `l`.
  void add(Point2 to_k, int k, Point2 to_l, int l) {
    b_ = to_k - apex_, c_ = to_l - apex_;
    k_ = k, l_ = l;
    for (int j = 0; j < parts_; ++j) {
      for (int i = 0; i + j < parts_; ++i) {
        add_seven(2 * i, 2 * j, 1);
        if (i + j + 1 < parts_) add_seven(2 * (i + 1), 2 * (j + 1), -1);
      }
    }
  }

 private:
  /// Adds a rule of degree 3: corners 1/20, middles of edges 2/15, centroid 9/20. Corner (i, j) in half parts; `up` −1: the triangle is
  /// upside down.
  void add_seven(int i, int j, int up) {
    for (const auto& [x, y] : {std::pair(i, j), {i + 2 * up, j}, {i, j + 2 * up}}) add_point(x, y, 0.05);
    for (const auto& [x, y] : {std::pair(i + up, j), {i, j + up}, {i + up, j + up}}) add_point(x, y, 2.0 / 15.0);
    const Point2 centroid = at(i + 2.0 * up / 3.0, j + 2.0 * up / 3.0);
    out_.push_back({centroid.s, centroid.t, 0.45 * part_area()});
  }
  /// Adds a point i half parts along the edge to corner k and j along the edge to corner l; either edge may also belong to another
  /// triangle.
  void add_point(int i, int j, double weight) {
    using Number = std::array<int, 3>;
    const Number number = i == 0 && j == 0 ? Number{-1, 0, 0} : j == 0 ? Number{k_, i, 0} : i == 0 ? Number{l_, j, 0} : Number{k_, i, j};
    const auto [known, is_new] = known_.try_emplace(number, out_.size());
    const Point2 p = at(i, j);
    if (is_new) out_.push_back({p.s, p.t, 0.0});
    out_[known->second].area += weight * part_area();
  }
  [[nodiscard]] Point2 at(double i, double j) const {
    const double x = i / (2.0 * parts_), y = j / (2.0 * parts_);
    return {apex_.s + x * b_.s + y * c_.s, apex_.t + x * b_.t + y * c_.t};
  }
  [[nodiscard]] double part_area() const { return 0.5 * cross(b_, c_) / (parts_ * parts_); }

  Point2 apex_, b_, c_;
  int parts_, k_ = 0, l_ = 0;
  std::vector<Segment>& out_;
  std::map<std::array<int, 3>, std::size_t> known_;
};

void append_triangles(const Polygon& p, double size, std::vector<Segment>& out) {
  const bool one = p.size() == 3;
  const Point2 apex = one ? p[0] : region(p).centroid;
  const auto corner = [&](std::size_t i) { return p[i % p.size()]; };
  double longest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) longest = std::max({longest, length(corner(i + 1) - corner(i)), length(corner(i) - apex)});
  TriangleFan fan(apex, whole_cells_along(longest, 2.0 * size), out);
  for (std::size_t i = one ? 1 : 0; i < (one ? 2 : p.size()); ++i) {
    const std::size_t next = (i + 1) % p.size();
    fan.add(p[i], static_cast<int>(i), p[next], static_cast<int>(next));
  }
}

/// Outward normal of an edge, not normalised.
Point2 outward(Point2 from, Point2 to) { return {to.t - from.t, from.s - to.s}; }

}  // namespace

void append_rim_points(const Polygon& polygon, double size, std::vector<Segment>& out) {
  const std::size_t first = out.size();
  if (const auto box = as_rectangle(polygon)) {
    append_rectangle(*box, size, out);
    return;
  }
  const Polygon p = cleaned(polygon);
  if (p.size() < 3) return;
  p.size() == 4 ? append_quadrilateral(p, size, out) : append_triangles(p, size, out);
  double sum = 0.0;
  for (std::size_t i = first; i < out.size(); ++i) sum += out[i].area;
  const double scale = region(polygon).area / sum;  // restores the area of corners that cleaned() dropped
  for (std::size_t i = first; i < out.size(); ++i) out[i].area *= scale;
}

void append_corner_points(const Polygon& polygon, std::vector<Segment>& out) {
  const Polygon p = cleaned(polygon);
  if (p.size() < 3) return;
  const auto corner = [&](std::size_t i) { return p[i % p.size()]; };
  const Region whole = region(polygon);
  // Of the triangle from the centroid to each edge: twice its area. Of each corner: by Wachspress, the area of the triangle that it makes
  // with its neighbours over the two triangles beside it.
  std::vector<double> edge(p.size()), coordinate(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) edge[i] = cross(p[i] - whole.centroid, corner(i + 1) - whole.centroid);
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 before = corner(i + p.size() - 1);
    coordinate[i] = cross(p[i] - before, corner(i + 1) - before) / (edge[(i + p.size() - 1) % p.size()] * edge[i]);
    sum += coordinate[i];
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double beside = (edge[(i + p.size() - 1) % p.size()] + edge[i]) / 6.0;
    out.push_back({p[i].s, p[i].t, beside + whole.area / 3.0 * coordinate[i] / sum});
  }
}

Polygon moved_in(const Polygon& polygon, double inset) {
  Polygon out = polygon, scratch;
  for (std::size_t i = 0; i < polygon.size() && !out.empty(); ++i) {
    const Point2 p = polygon[i], n = outward(p, polygon[(i + 1) % polygon.size()]);
    clip(out, n, n.s * p.s + n.t * p.t - inset * length(n), scratch);
  }
  if (region(out).area > 0.0) return out;
  const Point2 c = region(polygon).centroid;
  out = polygon;
  for (Point2& p : out) p = {0.5 * (p.s + c.s), 0.5 * (p.t + c.t)};
  return out;
}

void append_difference(const Polygon& a, const Polygon& b, std::vector<Polygon>& out) {
  Polygon rest = a, scratch;
  if (intersection(a, b).empty()) {
    out.push_back(a);
    return;
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Point2 p = b[i], next = b[(i + 1) % b.size()], n = outward(p, next);
    if (length(next - p) <= kSame) continue;  // between corners that coincide there is no edge: all would lie beyond it
    const double offset = n.s * p.s + n.t * p.t;
    Polygon beyond = rest;
    clip(beyond, {-n.s, -n.t}, -offset, scratch);
    if (region(beyond).area > 0.0) out.push_back(std::move(beyond));
    clip(rest, n, offset, scratch);
  }
}

}  // namespace voussoir::geometry
