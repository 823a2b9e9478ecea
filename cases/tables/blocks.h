// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec3.h"

/// Tables [[block]] of the case file.
namespace voussoir::cases {

/// Number of cells of a unit along three edges: its length, its thickness, its height.
using CellCounts = std::array<int, 3>;
inline constexpr int kMostCells = 16;  // along one edge

struct Rotation {
  Vec3 axis{0, 0, 1};
  double angle = 0.0;  // degrees
  Vec3 about;          // m
};
/// Motion of a fixed block: a constant velocity; a file of t [s], x, y, z [m] and, where it turns, rx, ry, rz [rad]; or an end.
struct SupportMotion {
  std::optional<Vec3> velocity;  // m/s
  std::optional<std::string> file;
  std::optional<Vec3> to{}, turn{};  // m, degrees (a rotation vector): the end of a way that a quasi-static analysis goes
  std::optional<Vec3> about{};       // m, the point that x, y, z are of and about which it turns; none: its centroid
};
/// A free block. Exactly one of box, vertices, polygon + extrude. `vertices` without `faces` are the eight of a hexahedron in VTK order;
/// with `faces` (loops of vertex numbers, counter-clockwise seen from outside) any convex polyhedron.
struct BlockSpec {
  BlockSpec();  // this and the next five are in compiled_once.cpp
  BlockSpec(const BlockSpec&);
  BlockSpec(BlockSpec&&) noexcept;
  BlockSpec& operator=(const BlockSpec&);
  BlockSpec& operator=(BlockSpec&&) noexcept;
  ~BlockSpec();

  std::string name, material;
  std::string part;  // of a building: "front wall", "front wall, storey 2"; empty: no part
  std::optional<std::array<Vec3, 2>> box;
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::array<double, 2>> polygon;
  std::optional<std::array<double, 2>> extrude;
  bool halves = false;              // a box in two cells, cut at mid-length
  std::optional<CellCounts> cells;  // elements along length, thickness and height; materials.<name>.inside is the law between them
  bool fixed = false, free = false;
  Vec3 velocity, angular_velocity;  // m/s, rad/s, global axes
  std::optional<Rotation> rotate;
  std::optional<SupportMotion> motion;
};

}  // namespace voussoir::cases
