// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

/// Parallel work on ranges of blocks. Nothing else in this layer starts threads.
namespace voussoir::geometry {

/// Blocks in a range, the unit of work of a thread.
inline constexpr std::size_t kBlocksAtATime = 512;

/// Number of ranges that for_ranges makes of `count` blocks.
constexpr std::size_t range_count(std::size_t count) { return (count + kBlocksAtATime - 1) / kBlocksAtATime; }

/// Calls work(range, first, last) once for every range [first, last) of kBlocksAtATime of `count` blocks, on `threads` threads, or on fewer
/// if the system does not give so many. The result must not depend on which thread does which range, or when: `work` writes only data of
/// its own range, or data that it locks. \throw the exception of `work`; if several ranges throw, that of the lowest range, as on one
/// thread
void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t range, std::size_t first, std::size_t last)>& work);

}  // namespace voussoir::geometry
