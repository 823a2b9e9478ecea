// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "solver/world/world.h"

namespace voussoir::solver {

/// How the segments of a side were looked at.
struct SideLook {
  bool closely = false;     // open sides too, which may have come apart
  bool for_steady = false;  // a side in which nothing happens is to be made steady, if it can be
};

/// Records what a step has done to a side whose segments were looked at: bonds left, losses, its state from now on.
/// \return true if its faces no longer face each other: the side is to be retired
bool record_side(World& w, std::size_t id, const kernels::DamagedSide& result, SideLook look);

}  // namespace voussoir::solver
