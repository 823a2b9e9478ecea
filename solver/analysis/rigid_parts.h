// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vec3.h"

/// Elements that move as one: parts whose motion is nearly that of rigid bodies.
namespace voussoir::solver {

/// Small displacements of elements, and pairs of touching elements.
struct ElementMotion {
  std::vector<double> mass;                           // kg; 0: in no part, such as a fixed block
  std::vector<Vec3> centre, displacement;             // m
  std::vector<std::array<std::int32_t, 2>> touching;  // pairs of elements; −1: the base, which does not move
};

/// Divides elements into rigid parts. Neighbours are merged in pairs, in order of the least deviation of their union from a rigid motion
/// (Ward 1963, on graphs), until the residual of rigid motions of the parts would exceed `misfit` times the motion itself, both as roots of
/// sums of mass times displacement squared. \return by element the least element of its part; −1: the part of the base, and elements
/// without mass
std::vector<std::int32_t> rigid_parts(const ElementMotion& motion, double misfit);

}  // namespace voussoir::solver
