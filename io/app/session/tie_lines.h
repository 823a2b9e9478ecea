// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"
#include "solver/world/world.h"

/// What commands print of ties; nothing for a model without.
namespace voussoir::io {

/// A line a tie: length, stiffness, yield force, how many elements each end holds.
void print_ties(const cases::Model& model);

/// What [[tie]], [[house.tie]] and [[house.mesh]] take: m of rod, m2 of mesh, anchors.
void print_tie_bill(const cases::Model& model);

/// A warning for each tie whose stiffness the step bounds (THEORY.md (32)).
void print_bounded_ties(const solver::Ties& ties, const cases::Model& model);

/// How many have yielded and broken, and the force and plastic elongation of each.
void print_tie_outcome(const solver::Ties& ties, const cases::Model& model);

}  // namespace voussoir::io
