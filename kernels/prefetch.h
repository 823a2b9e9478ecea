// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace voussoir::kernels {

/// Prefetches memory some time before it is needed, for rows of elements, patches and points, which are scattered where no hardware
/// prefetcher foresees them. The empty asm marks the function as having an effect: g++ 12 otherwise drops calls of a function that only
/// prefetches.
inline void prefetch(const void* from, std::size_t bytes) noexcept {
  const char* at = static_cast<const char*>(from);
  for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(at + line);
  asm volatile("");
}

/// Prefetches into the second-level cache, for data needed only after much other work: the first cache is small.
inline void prefetch_to_second_cache(const void* from, std::size_t bytes) noexcept {
  const char* at = static_cast<const char*>(from);
  for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(at + line, 0, 2);
  asm volatile("");
}

/// Orders the streaming stores of this thread before all its later stores, which a barrier alone does not guarantee.
inline void finish_stores() noexcept {
#if defined(__AVX__)
  _mm_sfence();
#endif
}

}  // namespace voussoir::kernels
