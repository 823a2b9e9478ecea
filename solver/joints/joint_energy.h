// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

namespace voussoir::solver {

struct StoredEnergy {
  double bonds = 0.0, contact = 0.0;  // J
};

/// Energy stored in the springs of all joints after the stage of forces.
StoredEnergy joint_energy(World& w);

}  // namespace voussoir::solver
