// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Ties: bars between points of elements (cases/ties.h), with the law of kernels/laws/tie_law.h.
namespace voussoir::solver {

/// Adds the forces of all ties to the wrench rows, in a fixed order.
/// \param share  applied fraction of the pretension, 0 to 1 (it grows with gravity while settling)
/// \return work of the pretensioning jack since the last call [J]
double apply_ties(World& w, double share);

/// Force of a tie at one of its holds in the last step: current point of action [m], and force [N] on the held element.
struct HeldForce {
  Vec3 point, force;
};
HeldForce force_of_hold(const World& w, const Ties::Hold& h);

/// Elastic energy of all ties [J].
double stored_energy(const Ties& t) noexcept;

}  // namespace voussoir::solver
