// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec3.h"

/// Cuts the sides of all joints into tasks that threads run without atomics: two tasks of one colour share no element.
///
/// The model is cut into columns of square cells in the plane of its two longest extents. A task holds the sides between one cell and the
/// next, so it writes to at most 2 × 2 cells, and cells whose two numbers are both even (or odd, ...) never meet: four colours. (Colouring
/// single sides takes 13 colours in a house of English bond, and every colour passes through all of memory again.)
namespace voussoir::solver {

/// Two elements that one side writes to; −1: nothing (the base).
using Writes = std::array<std::int32_t, 2>;

struct Decomposition {
  std::vector<std::vector<std::vector<std::int32_t>>> colours;  // [colour][task]: sides, in the order in which they run
  std::vector<std::int32_t> overflow;                           // sides that span more than two cells: a single task, after all others
};

/// Edge of the cells [m]: long enough for nearly all sides, and for tasks of a useful size. \param out_of_cache  see World::out_of_cache
double choose_cell(std::span<const Writes> sides, std::span<const Vec3> centroids, bool out_of_cache);

/// Divides sides into tasks and colours. Within a task, sides of one kind are adjacent (solver/setup/side_kinds.h).
/// \param kinds  by side
/// \param out_of_cache  see World::out_of_cache: within a task, sides of each kind that fill blocks come first, then the remaining sides of
/// all kinds. This gives fewer kinds of blocks, whose constants take less of the caches
/// \pre cell > 0
Decomposition decompose(std::span<const Writes> sides, std::span<const std::int32_t> kinds, std::span<const Vec3> centroids, double cell,
                        bool out_of_cache);

}  // namespace voussoir::solver
