// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vec3.h"

/// Which elements move as one: parts whose motions come near those of rigid bodies.
namespace voussoir::solver {

/// Small displacements of elements, and which of them touch.
struct ElementMotion {
  std::vector<double> mass;                           // kg; none: it belongs to no part, such as a fixed block
  std::vector<Vec3> centre, displacement;             // m
  std::vector<std::array<std::int32_t, 2>> touching;  // elements; −1: the base, which does not move
};

/// Neighbours are put together two by two, those first whose union differs least from a rigid motion (Ward 1963, on graphs), until what
/// rigid motions of the parts leave over would exceed `misfit` times the motion itself, as roots of sums of mass times displacement
/// squared. \return of each element the least element of its part; −1: the part of the base, and elements without mass
std::vector<std::int32_t> rigid_parts(const ElementMotion& motion, double misfit);

}  // namespace voussoir::solver
