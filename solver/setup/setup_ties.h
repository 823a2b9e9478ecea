// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

namespace voussoir::solver {

/// Ties with the stiffness that the case gives them, for masses that are found from it (solver/equilibrium/masses.h).
void set_up_stiff_ties(World& w);

}  // namespace voussoir::solver
