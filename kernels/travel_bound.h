// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kernels/integrate.h"

/// How far elements have moved since contact was searched for them (THEORY.md, "Who is near").
namespace voussoir::kernels {

/// Poses at which elements were searched last, as in ElementsView.
struct SearchedPoses {
  const double *ux, *uy, *uz;       // m
  const double *qw, *qx, *qy, *qz;  // orientation
  const double* radius;             // m, of each element round its centroid
};

/// m, by how much the point of an element that has moved most has moved since its search, or a little more.
double displacement_since_search(const ElementsView& e, const SearchedPoses& at, std::int64_t i) noexcept;

/// Upper bounds on travel, and what follows from the last displacement that was computed.
struct TravelBounds {
  double* bound;  // m, on the path of any point since the search
  double* safe;   // m; as long as the bound is not over this, the displacement is not over the limit
};

/// How all elements travel. The elements of a batch that is not active (ElementRows::active) share one bound: fewer numbers to go through.
struct TravelView {
  SearchedPoses at;
  double dt;                               // s
  double limit;                            // m, a displacement that matters to nobody; always the same
  TravelBounds element;                    // by element, of active batches
  const std::uint8_t* active = nullptr;    // by batch; nullptr: all are
  TravelBounds batch{};                    // by batch, of the others
  const double* largest_radius = nullptr;  // m, by batch
};

/// Adds to the bounds of the elements [first, last), whole batches, what they travel in a step with the velocities they have. Computes the
/// displacement of those only whose bound is over what is safe.
/// \return the largest displacement over the limit [m], 0 if none is
double advance_travel(const ElementsView& e, const TravelView& t, std::int64_t first, std::int64_t last) noexcept;

}  // namespace voussoir::kernels
