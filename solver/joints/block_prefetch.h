// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kernels/side.h"
#include "solver/world/world.h"

/// Prefetches of damaged blocks of sides, whose memory lies where no hardware foresees it. Both read what is there and change nothing.
namespace voussoir::solver {

/// What the sides of a block need in which something has happened: the rows of their elements, their constants, and, of those whose
/// segments are looked at, where these lie.
void prefetch_block(const Sides& s, const kernels::Rows& rows, std::int32_t block);

/// Then, once these are there: the histories of the segments.
void prefetch_histories(const Sides& s, std::int32_t block);

}  // namespace voussoir::solver
