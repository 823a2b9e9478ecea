// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "cases/model.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/building/wall_axes.h"

/// The building of a run as the collapse measures need it: elements and position of each wall, rooms between the walls.
namespace voussoir::io {

/// Along x (0), y (1) or z (2).
inline double component(Vec3 v, std::size_t axis) noexcept { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// One side of a storey of a house, or one of its inner walls: bricks, lintels and the gable on it.
struct Wall {
  std::string name;        // "front wall"; "front wall, storey 1"; with "of house 1" where there are several houses
  std::int32_t house = 0;  // copy of the house; −1: of free blocks with a part name
  int storey = 1;
  bool inner = false;
  WallAxes axes;                  // in which all of the following is
  Box box;                        // bounding box of its bricks without the gable
  std::size_t across = 0;         // axis normal to its plane: 0 x, 1 y
  double outward = 1.0;           // 1: the outside of the house is in the positive direction of that axis, −1: in the negative
  std::vector<std::size_t> foot;  // elements of its lowest course
  std::vector<std::vector<std::size_t>> top;  // elements of its uppermost course without the gable, in pieces of about 1 m along the wall

  [[nodiscard]] double length() const noexcept { return box.size(1 - across); }
  [[nodiscard]] double thickness() const noexcept { return box.size(across); }
  [[nodiscard]] double height() const noexcept { return box.size(2); }
  /// Of a point or a vector of the model: along the wall, and normal to its plane.
  [[nodiscard]] double along(Vec3 v) const noexcept { return component(axes.of(v), 1 - across); }
  [[nodiscard]] double through(Vec3 v) const noexcept { return component(axes.of(v), across); }
  /// 1: the wall's axis runs to the right when seen from outside, −1: to the left.
  [[nodiscard]] double right() const noexcept { return across == 1 ? -outward : outward; }
};

/// A gable: a part of its own on the wall whose mass it counts to. As a wall, its top is its upper third.
struct Gable {
  std::int32_t wall = 0;  // index into Building::walls
  Wall part;              // "left gable, storey 2"
};

/// The space between walls of one storey, up to their height.
struct Room {
  std::array<double, 2> low, high;  // x and y, m
  double floor = 0, ceiling = 0;    // z, m
  int storey = 1;
  bool top = true;  // no storey above
};

struct Building {
  static constexpr int kAll = std::numeric_limits<int>::max();  // value of `covers`

  double base = 0;  // m, z of the base; without one, of the lowest corner, from which the solver counts what has fallen
  bool has_base = false;
  double datum = 0;          // m, z from which heights count that are shown: of the base; without one, z = 0 of the case
  std::vector<double> mass;  // kg, by element like the following vectors; 0 for fixed elements
  std::vector<cases::PartKind> kind;
  std::vector<std::int32_t> wall;  // index into walls; −1: of no wall
  std::vector<int> covers;         // number of storeys under the element (floor, roof), counted from the first; 0: neither floor nor roof
  std::vector<Box> box;            // in the reference configuration, along the axes of the model
  ElementVertices vertices;
  std::vector<Wall> walls;  // empty without a house
  std::vector<Gable> gables;
  std::vector<std::uint8_t> gable;  // by element, 1: a brick of a gable
  std::vector<Room> rooms;          // of houses whose walls enclose one
  Box footprint;                    // of the houses; without a house, of all elements that are not fixed

  /// The box of an element along the axes of a wall.
  [[nodiscard]] Box box_in(const Wall& w, std::size_t e) const { return w.axes.turned() ? vertices.box(e, w.axes) : box[e]; }
  /// Height as a drawing has it, for all that is shown [m]: above the base; without one, z of the case.
  [[nodiscard]] double height_of(double z) const noexcept { return z - datum; }
  [[nodiscard]] double z_of(double height) const noexcept { return height + datum; }
  [[nodiscard]] bool is_roof(std::size_t element) const noexcept {
    return kind[element] == cases::PartKind::beam || kind[element] == cases::PartKind::voussoir;
  }
  /// Whether the element is timber on walls, in their pockets or beside them: a rafter, a beam of a roof or floor, a ring beam, a column. A
  /// lintel belongs to its wall instead.
  [[nodiscard]] bool is_timber(std::size_t element) const noexcept {
    using enum cases::PartKind;
    return kind[element] == beam || kind[element] == floor_beam || kind[element] == ring_beam || kind[element] == column;
  }
  /// Whether timber meets a wall, the base or other timber between these elements: an opening there is a slip of timber, not a crack of a
  /// wall.
  /// \param b  −1: the base
  [[nodiscard]] bool is_seat(std::int32_t a, std::int32_t b) const noexcept {
    return is_timber(static_cast<std::size_t>(a)) || (b >= 0 && is_timber(static_cast<std::size_t>(b)));
  }
};

/// The part of the building from an element's tag: "roof beam 11" belongs to "roof beam", "front wall, storey 1" to itself.
std::string part_of(const std::string& tag);

/// Reads the building of a run. \param run  with its model and its case, for the height of the base and the rotation of the house \throw
/// FileError
Building building_of(const Hdf5File& run);

}  // namespace voussoir::io
