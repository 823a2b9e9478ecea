// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

/// The threads of this layer: a model of a million blocks is assembled by all cores.
namespace voussoir::geometry {

/// So many blocks are one piece of work for a thread.
inline constexpr std::size_t kBlocksAtATime = 512;

/// How many ranges for_ranges makes of `count` blocks.
constexpr std::size_t range_count(std::size_t count) { return (count + kBlocksAtATime - 1) / kBlocksAtATime; }

/// Calls work(range, first, last) once for every range [first, last) of kBlocksAtATime of `count` blocks, on `threads` threads. What comes
/// out must not depend on who does which range, or when: `work` writes only what belongs to its range, or what it locks.
/// \throw what `work` throws; if it does so in several ranges, that of the lowest one, as on one thread
void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t range, std::size_t first, std::size_t last)>& work);

}  // namespace voussoir::geometry
