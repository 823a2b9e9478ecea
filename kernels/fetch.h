// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace voussoir::kernels {

/// Asks for memory some time before it is needed: rows of elements, patches and points lie all over it, where no hardware foresees them.
/// The empty asm says that this has an effect: g++ 12 takes a function that only prefetches for one without, and leaves out its calls.
inline void fetch(const void* from, std::size_t bytes) noexcept {
  const char* at = static_cast<const char*>(from);
  for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(at + line);
  asm volatile("");
}

}  // namespace voussoir::kernels
