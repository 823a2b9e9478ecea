// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "solver/world/world.h"

namespace voussoir::solver {

/// How the segments of a side were processed.
struct SideLook {
  bool closely = false;     // including open sides, which may have come apart
  bool for_steady = false;  // sides without events are to be made steady, if possible
};

/// Records the result of a side processed segment by segment: bonds left, losses, its new state.
/// \return true if its faces no longer face each other: the side is to be retired
bool record_side(World& w, std::size_t id, const kernels::DamagedSide& result, SideLook look);

}  // namespace voussoir::solver
