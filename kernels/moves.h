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

/// What elements have moved, by element.
struct Moves {
  SearchedPoses at;
  double dt;      // s
  double limit;   // m, that nobody asks about less; always the same
  double* path;   // m, bound on the way that any point of it has gone since it was searched
  double* until;  // m, as long as the path is no longer than this, `move_of` is at most the limit
};

/// Adds to the paths of the elements [first, last), both multiples of kLanes, what they go in a step with the velocities they have.
/// \return the largest `move_of` over the limit, 0 if none is: most elements need no look at where they were
double measure_moves(const ElementsView& e, const Moves& m, std::int64_t first, std::int64_t last) noexcept;

}  // namespace voussoir::kernels
