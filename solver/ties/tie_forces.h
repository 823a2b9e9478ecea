// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Ties: bars between points of elements (cases/ties.h), whose law is kernels/laws/tie_law.h.
namespace voussoir::solver {

/// Adds the forces of all ties to the wrench rows, in a fixed order.
/// \param share  of the pretension that has been put on, 0 to 1 (it grows with gravity while settling)
/// \return J, work of the jack that puts it on, since the last call
double apply_ties(World& w, double share);

/// What a tie does at one of its holds, by the last step: where it acts [m], as things stand, and the force [N] on what is held.
struct HeldForce {
  Vec3 point, force;
};
HeldForce force_of_hold(const World& w, const Ties::Hold& h);

/// J
double stored_energy(const Ties& t) noexcept;

}  // namespace voussoir::solver
