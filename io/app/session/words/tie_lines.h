// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/forward.h"
#include "solver/world/world.h"

/// Output about ties; nothing for a model without ties.
namespace voussoir::io {

/// Prints a line per tie: length, stiffness, yield force, number of elements at each end.
void print_ties(const cases::Model& model);

/// Prints the material needed for [[tie]], [[house.tie]] and [[house.mesh]]: m of rod, m2 of mesh, anchors.
void print_tie_bill(const cases::Model& model);

/// Prints a warning for each tie whose stiffness is limited by the step (THEORY.md (32)).
void print_bounded_ties(const solver::Ties& ties, const cases::Model& model);

/// Prints the numbers of ties that have yielded and broken, and the force and plastic elongation of each.
void print_tie_outcome(const solver::Ties& ties, const cases::Model& model);

}  // namespace voussoir::io
