// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kernels/integrate.h"

/// How far elements have moved since somebody looked for what is near them (THEORY.md, "Who is near").
namespace voussoir::kernels {

/// Poses in which elements were searched last, as in ElementsView.
struct SearchedPoses {
  const double *ux, *uy, *uz;       // m
  const double *qw, *qx, *qy, *qz;  // orientation
  const double* radius;             // m, of each element round its centroid
};

/// What any point of an element has moved since [m], or a little more.
double move_of(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept;

/// The largest of `move_of` of the elements [first, last), both multiples of kLanes. Adds to `path` [m] a bound on the way that any point
/// of each goes in a step of dt with the velocities it has.
double measure_moves(const ElementsView& e, const SearchedPoses& at, double dt, double* path, std::int64_t first,
                     std::int64_t last) noexcept;

}  // namespace voussoir::kernels
