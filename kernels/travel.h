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

/// Bounds on the ways that elements have gone, and how far they may go before somebody has to look where they are.
struct Ways {
  double* path;   // m, bound on the way that any point has gone
  double* until;  // m, as long as the path is no longer than this, `move_of` is at most the limit
};

/// What elements have moved. Of batches that nobody watches (ElementRows::active) all elements share one way: fewer numbers to go through.
struct Moves {
  SearchedPoses at;
  double dt;                               // s
  double limit;                            // m, that nobody asks about less; always the same
  Ways element;                            // by element, of active batches; paths begin when an element is searched
  const std::uint8_t* active = nullptr;   // by batch; nullptr: all are
  Ways batch{};                            // by batch, of the others
  const double* largest_radius = nullptr;  // m, by batch
};

/// Adds to the paths of the elements [first, last), whole batches, what they go in a step with the velocities they have.
/// \return the largest `move_of` over the limit, 0 if none is: most elements need no look at where they were
double measure_moves(const ElementsView& e, const Moves& m, std::int64_t first, std::int64_t last) noexcept;

}  // namespace voussoir::kernels
