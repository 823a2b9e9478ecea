// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/face_grid.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <limits>

#include "geometry/message.h"
#include "geometry/nth.h"

namespace voussoir::geometry {

namespace {

constexpr double kEqualAreas = 1e-9;  // relative: pieces that differ by less are as large
// Of an edge, and of a cell: differences that are no more than the raster of a micrometre on which walls are laid out.
constexpr double kLaidOut = 2e-4;
constexpr double kRoundOff = 1e-9;  // of an edge, by which lengths of two that are equal differ

/// Grid line before column (or row) i of n, on the raster of the corners, so that an edge on a line is on it exactly. The outermost cells
/// are unbounded, so parts that stick out by round-off are not lost.
double line(std::int32_t i, std::int32_t n, double step, double quantum) {
  if (i <= 0) return -std::numeric_limits<double>::infinity();
  if (i >= n) return std::numeric_limits<double>::infinity();
  return snapped(static_cast<double>(i) * step, quantum);
}

struct IndexRange {
  std::int32_t first, last;
};

/// Cells that an interval may touch. The interval is widened by 1e-6 of a cell, since the lines are rounded.
IndexRange cells_between(double low, double high, double step, std::int32_t n) {
  const auto index = [&](double x) { return static_cast<std::int32_t>(std::clamp(std::floor(x), 0.0, static_cast<double>(n - 1))); };
  return {index(low / step - 1e-6), index(high / step + 1e-6)};
}

struct CellCounts {
  std::int32_t columns, rows;
};

CellCounts count_cells(const Rectangle& box, double size, int subject, int face) {
  const double columns = cells_along(box.high.s - box.low.s, size), rows = cells_along(box.high.t - box.low.t, size);
  if (columns * rows <= 1e8) return {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows)};
  throw ModelError(block_prefix(subject) + "the segment size of " + figure(size) + " m is too small: face " + std::to_string(face) +
                       " would have " + figure(columns) + " x " + figure(rows) + " segments (allowed 1e8)",
                   subject);
}

/// The first of the longest edges, but for round-off, or one before it that is as long within kLaidOut and parallel or square to it: sides
/// of rectangles differ by the raster, which must not turn the grid. Edges at another angle need not be so near to be told apart: of a
/// nearly regular stone the same one is the longest in whatever order its corners stand.
Vec3 longest_edge(const std::vector<Vec3>& corners) {
  const auto edge = [&](std::size_t i) { return corners[(i + 1) % corners.size()] - corners[i]; };
  double longest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) longest = std::max(longest, norm(edge(i)));
  std::size_t first = 0;
  while (norm(edge(first)) < (1.0 - kRoundOff) * longest) ++first;
  for (std::size_t i = 0; i < first; ++i) {
    const double least = kLaidOut * longest * longest;
    const bool of_rectangle = norm(cross(edge(i), edge(first))) <= least || std::abs(dot(edge(i), edge(first))) <= least;
    if (of_rectangle && norm(edge(i)) >= (1.0 - kLaidOut) * longest) return edge(i);
  }
  return edge(first);
}

/// A length without its round-off: to twelve decimals for cells of some centimetres. Lengths are drawn in decimals, and 7 cells of 0.1 must
/// end at 0.7; on the binary raster they would drift by a unit and leave slivers.
double as_drawn(double length, double cell) {
  const double digits = std::clamp(10.0 - std::floor(std::log10(1.001 * cell)), 0.0, 22.0);
  const double scale = std::pow(10.0, digits);
  return std::round(length * scale) / scale;
}

/// A whole cell with its nominal area and centre instead of those from rounded lines, so that equal cells have equal bits.
Piece whole_cell(const FaceGrid& g, std::int32_t i, std::int32_t j) {
  return {j * g.columns + i, g.cell_area(), {(i + 0.5) * g.cell_width, (j + 0.5) * g.cell_height}};
}

/// Not by ==, for which 0 is −0.
bool have_same_bits(const FaceGrid& a, const FaceGrid& b) {
  const auto numbers = [](const FaceGrid& g) {
    return std::array{g.axis_s.x, g.axis_s.y, g.axis_s.z, g.axis_t.x, g.axis_t.y,   g.axis_t.z,    g.normal.x,
                      g.normal.y, g.normal.z, g.width,    g.height,   g.cell_width, g.cell_height, g.quantum};
  };
  const auto x = numbers(a), y = numbers(b);
  return a.columns == b.columns && a.rows == b.rows && a.polygon.size() == b.polygon.size() &&
         std::memcmp(x.data(), y.data(), sizeof x) == 0 &&
         std::memcmp(a.polygon.data(), b.polygon.data(), a.polygon.size() * sizeof(Point2)) == 0;
}

}  // namespace

const FaceGrid& FaceGridStore::keep(const FaceGrid& g) {
  const auto last = grids_.rbegin() + std::min(kLooks, std::ssize(grids_));
  const auto found = std::find_if(grids_.rbegin(), last, [&](const FaceGrid& known) { return have_same_bits(known, g); });
  return found != last ? *found : grids_.emplace_back(g);
}

double snapped(double value, double quantum) noexcept { return std::nearbyint(value / quantum) * quantum; }

double cells_along(double extent, double size) noexcept { return std::max(1.0, std::floor(extent / size + 0.5 + kLaidOut)); }

NewFaceGrid make_face_grid(const Polyhedron& p, int face, double segment_size, int subject) {
  const auto& loop = nth(p.faces, face);
  std::vector<Vec3> corners;
  corners.reserve(loop.size());
  for (const std::int32_t i : loop) corners.push_back(nth(p.vertices, i));

  NewFaceGrid g;
  g.normal = face_plane(p, face).normal;
  const Vec3 edge = longest_edge(corners);
  g.axis_s = normalised(edge - dot(edge, g.normal) * g.normal);
  g.axis_t = cross(g.normal, g.axis_s);
  for (const Vec3& c : corners) g.polygon.push_back({dot(c - corners[0], g.axis_s), dot(c - corners[0], g.axis_t)});
  const Rectangle rough = bounds(g.polygon);
  g.origin = corners[0] + rough.low.s * g.axis_s + rough.low.t * g.axis_t;
  const CellCounts counts = count_cells(rough, segment_size, subject, face);
  g.columns = counts.columns, g.rows = counts.rows;

  const double cell = std::min((rough.high.s - rough.low.s) / g.columns, (rough.high.t - rough.low.t) / g.rows);
  g.quantum = std::ldexp(1.0, std::min(-40, std::ilogb(1.001 * cell) - 35));  // 1.001: round-off at a power of two changes nothing
  for (Point2& q : g.polygon) q = {snapped(q.s - rough.low.s, g.quantum), snapped(q.t - rough.low.t, g.quantum)};
  const Rectangle box = bounds(g.polygon);
  g.width = box.high.s, g.height = box.high.t;
  g.cell_width = as_drawn(rough.high.s - rough.low.s, cell) / g.columns;
  g.cell_height = as_drawn(rough.high.t - rough.low.t, cell) / g.rows;
  return g;
}

void Cutter::cut(const FaceGrid& grid, const Polygon& polygon, std::vector<Piece>& out) {
  out.clear();
  if (polygon.size() < 3) return;
  if (const auto r = as_rectangle(polygon)) {
    cut_rectangle(grid, *r, out);
  } else {
    cut_general(grid, polygon, out);
  }
}

void Cutter::cut_rectangle(const FaceGrid& g, const Rectangle& r, std::vector<Piece>& out) {
  const IndexRange columns = cells_between(r.low.s, r.high.s, g.cell_width, g.columns);
  const IndexRange rows = cells_between(r.low.t, r.high.t, g.cell_height, g.rows);
  for (std::int32_t j = rows.first; j <= rows.last; ++j) {
    const double line_low_t = line(j, g.rows, g.cell_height, g.quantum), line_high_t = line(j + 1, g.rows, g.cell_height, g.quantum);
    const double low_t = std::max(r.low.t, line_low_t), high_t = std::min(r.high.t, line_high_t);
    const bool whole_row = low_t == std::max(0.0, line_low_t) && high_t == std::min(g.height, line_high_t);
    for (std::int32_t i = columns.first; i <= columns.last; ++i) {
      const double line_low_s = line(i, g.columns, g.cell_width, g.quantum), line_high_s = line(i + 1, g.columns, g.cell_width, g.quantum);
      const double low_s = std::max(r.low.s, line_low_s), high_s = std::min(r.high.s, line_high_s);
      if (!(high_s > low_s && high_t > low_t)) continue;
      if (whole_row && low_s == std::max(0.0, line_low_s) && high_s == std::min(g.width, line_high_s)) {
        out.push_back(whole_cell(g, i, j));
      } else {
        out.push_back({j * g.columns + i, (high_s - low_s) * (high_t - low_t), {0.5 * (low_s + high_s), 0.5 * (low_t + high_t)}});
      }
    }
  }
}

void Cutter::cut_general(const FaceGrid& g, const Polygon& polygon, std::vector<Piece>& out) {
  const auto clip_between = [&](Polygon& p, Point2 axis, double low, double high) {
    if (std::isfinite(low)) clip(p, {-axis.s, -axis.t}, -low, scratch_);
    if (std::isfinite(high)) clip(p, axis, high, scratch_);
  };
  const Rectangle box = bounds(polygon);
  const IndexRange rows = cells_between(box.low.t, box.high.t, g.cell_height, g.rows);
  for (std::int32_t j = rows.first; j <= rows.last; ++j) {
    strip_.assign(polygon.begin(), polygon.end());
    clip_between(strip_, {0.0, 1.0}, line(j, g.rows, g.cell_height, g.quantum), line(j + 1, g.rows, g.cell_height, g.quantum));
    if (strip_.size() < 3) continue;
    const Rectangle strip_box = bounds(strip_);
    const IndexRange columns = cells_between(strip_box.low.s, strip_box.high.s, g.cell_width, g.columns);
    for (std::int32_t i = columns.first; i <= columns.last; ++i) {
      piece_.assign(strip_.begin(), strip_.end());
      clip_between(piece_, {1.0, 0.0}, line(i, g.columns, g.cell_width, g.quantum), line(i + 1, g.columns, g.cell_width, g.quantum));
      const Region r = region(piece_);
      if (!(r.area > 0.0)) continue;
      const bool whole = std::abs(r.area - g.cell_area()) <= 1e-10 * g.cell_area();
      out.push_back(whole ? whole_cell(g, i, j) : Piece{j * g.columns + i, r.area, r.centroid});
    }
  }
}

void merge_small(const FaceGrid& g, std::vector<Piece>& pieces) {
  const double least = kSmallPiece * g.cell_area();
  const auto is_small = [&](const Piece& p) { return p.area < least; };
  if (std::none_of(pieces.begin(), pieces.end(), is_small)) return;

  // Neighbours are looked at as they were cut, and of equal ones the nearest has the piece: what has been added before decides nothing, so
  // a row of slivers goes to the cells beside it one by one, in whichever order cells are numbered. A strip of slivers alone stays as it
  // is.
  const std::vector<Piece> as_cut = pieces;
  const auto find = [&](std::int32_t column, std::int32_t row) -> std::ptrdiff_t {
    if (column < 0 || column >= g.columns || row < 0 || row >= g.rows) return -1;
    const std::int32_t cell = row * g.columns + column;
    const auto at = std::lower_bound(as_cut.begin(), as_cut.end(), cell, [](const Piece& p, std::int32_t c) { return p.cell < c; });
    return at != as_cut.end() && at->cell == cell && !is_small(*at) ? at - as_cut.begin() : -1;
  };
  const auto distance2 = [](const Piece& a, const Piece& b) {
    const double s = a.centroid.s - b.centroid.s, t = a.centroid.t - b.centroid.t;
    return s * s + t * t;
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!is_small(as_cut[i])) continue;
    const std::int32_t column = as_cut[i].cell % g.columns, row = as_cut[i].cell / g.columns;
    std::ptrdiff_t best = -1;
    for (std::int32_t k = 0; k < 9; ++k) {
      const std::ptrdiff_t other = find(column + k % 3 - 1, row + k / 3 - 1);
      if (other < 0) continue;
      const auto at = [&](std::ptrdiff_t n) -> const Piece& { return nth(as_cut, n); };
      const bool larger = best < 0 || at(other).area > (1.0 + kEqualAreas) * at(best).area;
      const bool alike = !larger && at(other).area >= (1.0 - kEqualAreas) * at(best).area;
      if (larger || (alike && distance2(at(other), as_cut[i]) < distance2(at(best), as_cut[i]))) best = other;
    }
    if (best < 0) continue;
    Piece &piece = pieces[i], &largest = nth(pieces, best);
    const double sum = largest.area + piece.area, share = piece.area / sum;
    largest.centroid.s += share * (piece.centroid.s - largest.centroid.s);
    largest.centroid.t += share * (piece.centroid.t - largest.centroid.t);
    largest.area = sum;
    piece.area = 0.0;
  }
  std::erase_if(pieces, [](const Piece& p) { return p.area == 0.0; });
}

}  // namespace voussoir::geometry
