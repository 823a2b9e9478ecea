// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kernels/integrate.h"

/// Upper bounds on the travel of elements since contacts were searched for them (THEORY.md, "Who is near").
namespace voussoir::kernels {

/// Poses of elements at their last search, as in ElementsView.
struct SearchedPoses {
  const double *ux, *uy, *uz;       // m
  const double *qw, *qx, *qy, *qz;  // orientation
  const double* radius;             // m, radius of each element about its centroid
};

/// Upper bound on the displacement [m] of any point of element i since its search, exceeding the true value by little.
double displacement_since_search(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept;

/// Upper bounds on travel, and the value up to which they need no check.
struct TravelBounds {
  double* bound;  // m, bound on the path of any point since the search
  double* safe;   // m; while the bound is at most this, the displacement is within the limit
};

/// Travel of all elements. The elements of an inactive batch (ElementRows::active) share one bound, which saves memory traffic.
struct TravelView {
  SearchedPoses at;
  double dt;                               // s
  const double* reach;                     // m, by element: its displacement needs no search up to here, less the margin
  double margin;                           // m
  TravelBounds element;                    // by element, of active batches
  const std::uint8_t* active = nullptr;    // by batch; nullptr: all are active
  TravelBounds batch{};                    // by batch, of inactive batches
  const double* largest_radius = nullptr;  // m, by batch
};

/// Adds the travel of one step, from the current velocities, to the bounds of the elements [first, last), whole batches. Computes the
/// displacement only of elements whose bound exceeds `safe`.
/// \return the largest displacement above the reach of its element less the margin [m], 0 if there is none
double advance_travel(const ElementsView& e, const TravelView& t, std::int64_t first, std::int64_t last) noexcept;

}  // namespace voussoir::kernels
