// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

/// Work on many blocks by several threads. Nothing else in this layer starts threads.
namespace voussoir::geometry {

/// A thread works on so many blocks at a time.
inline constexpr std::size_t kBlocksAtATime = 512;

/// How many ranges for_ranges makes of `count` blocks.
constexpr std::size_t range_count(std::size_t count) { return (count + kBlocksAtATime - 1) / kBlocksAtATime; }

/// Calls work(range, first, last) once for every range [first, last) of kBlocksAtATime of `count` blocks, on `threads` threads. What comes
/// out must not depend on who does which range, or when: `work` writes only what belongs to its range, or what it locks.
/// \throw what `work` throws; if it does so in several ranges, that of the lowest one, as on one thread
void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t range, std::size_t first, std::size_t last)>& work);

}  // namespace voussoir::geometry
