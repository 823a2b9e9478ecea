// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/polyhedron.h"

namespace voussoir::geometry {

/// The cells of one face, but not where it lies. Its plane coordinates (s, t) [m] start at the corner of the bounding rectangle; s runs
/// along the longest edge (of rectangles the first within 2e-4), t = normal × s. Corners lie on a raster of
/// `quantum`, far finer than building tolerances, so that faces equal up to round-off have equal bits.
struct FaceGrid : FrameAxes {
  Polygon polygon;                             // the face
  double width = 0.0, height = 0.0;            // m, of the rectangle
  std::int32_t columns = 1, rows = 1;          // n = max(1, round(edge / size))
  double cell_width = 0.0, cell_height = 0.0;  // m
  double quantum = 0.0;                        // m, a power of two, at most 2^-40 and 2^-35 of a cell

  [[nodiscard]] double cell_area() const noexcept { return cell_width * cell_height; }
  [[nodiscard]] std::int32_t cell_count() const noexcept { return columns * rows; }
};

/// The grid of a face and its place.
struct NewFaceGrid : FaceGrid {
  Vec3 origin;  // m, the corner of the rectangle, global axes
};
/// The same, of many faces: those that are alike share a grid.
struct PlacedGrid {
  Vec3 origin;
  const FaceGrid* grid = nullptr;
};

/// Keeps grids of faces, those that are alike once. For one thread.
class FaceGridStore {
 public:
  /// A kept grid that equals `g` bit for bit, added if it is not among the last kLooks. Valid as long as the store.
  const FaceGrid& keep(const FaceGrid& g);

 private:
  static constexpr std::ptrdiff_t kLooks = 64;  // a wall has some forty kinds of faces
  std::deque<FaceGrid> grids_;                  // a deque, since its elements never move
};

/// Rounds to a multiple of `quantum`, a power of two.
double snapped(double value, double quantum) noexcept;

/// Number of cells n = max(1, the whole number nearest to extent / size, halves up within 2e-4), so that neither round-off nor the raster
/// of a micrometre, on which walls are laid out, gives one of two equal faces one cell more.
double cells_along(double extent, double size) noexcept;

/// The grid of a face, with cells of about segment_size [m]. \pre p is valid, segment_size > 0. \throw ModelError if the face would have
/// more than 1e8 cells.
NewFaceGrid make_face_grid(const Polyhedron& p, int face, double segment_size, int subject = -1);

/// Intersection of a cell and a polygon: area [m2] and centroid [m] in the coordinates of the face.
struct Piece {
  std::int32_t cell = 0;  // column + row × columns
  double area = 0.0;
  Point2 centroid;
};

/// Cuts convex polygons of a face into the face's cells. Keeps scratch memory between cuts.
class Cutter {
 public:
  /// Overwrites `out` with the pieces, row by row. Their areas sum to the polygon's (1e-10 relative).
  void cut(const FaceGrid& grid, const Polygon& polygon, std::vector<Piece>& out);

 private:
  void cut_rectangle(const FaceGrid& grid, const Rectangle& r, std::vector<Piece>& out);
  void cut_general(const FaceGrid& grid, const Polygon& polygon, std::vector<Piece>& out);

  Polygon strip_, piece_, scratch_;
};

/// Adds every piece under 1 % of a cell to the largest of its eight neighbours that are no such pieces, of equal ones to the nearest.
/// Without any it stays.
void merge_small(const FaceGrid& grid, std::vector<Piece>& pieces);

/// Share of a cell below which a piece is not made a segment.
inline constexpr double kSmallPiece = 0.01;

}  // namespace voussoir::geometry
