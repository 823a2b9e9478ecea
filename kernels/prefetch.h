// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace voussoir::kernels {

/// Prefetches memory some time before it is needed: rows of elements, patches and points lie all over it, where no hardware foresees them.
/// The empty asm says that this has an effect: g++ 12 takes a function that only prefetches for one without, and leaves out its calls.
inline void prefetch(const void* from, std::size_t bytes) noexcept {
  const char* at = static_cast<const char*>(from);
  for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(at + line);
  asm volatile("");
}

/// The same into the second cache, for what is needed only after much else: the first cache is small.
inline void prefetch_to_second_cache(const void* from, std::size_t bytes) noexcept {
  const char* at = static_cast<const char*>(from);
  for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(at + line, 0, 2);
  asm volatile("");
}

/// Orders the streaming stores of this thread before all its later stores: a barrier alone does not promise that.
inline void finish_stores() noexcept {
#if defined(__AVX__)
  _mm_sfence();
#endif
}

}  // namespace voussoir::kernels
