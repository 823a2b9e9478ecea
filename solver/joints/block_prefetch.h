// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kernels/side.h"
#include "solver/world/world.h"

/// Prefetches for damaged blocks of sides, whose memory access no hardware prefetcher foresees. They read only, and change nothing.
namespace voussoir::solver {

/// Prefetches the data of a damaged block: the rows of its elements, its constants, and, for sides processed segment by segment, their
/// pointers.
void prefetch_block(const Sides& s, const kernels::Rows& rows, std::int32_t block);

/// Prefetches the histories of the segments. To be called later, when the pointers have arrived.
void prefetch_histories(const Sides& s, std::int32_t block);

}  // namespace voussoir::solver
