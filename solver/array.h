// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace voussoir::solver {

/// Allocates on cache lines, so that vector loads never straddle two; large arrays on huge pages where the system has them: joints visit
/// the rows of elements all over a building, and with small pages each visit is a miss of the translation buffer.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;

  CacheAligned() = default;
  template <class U>
  explicit CacheAligned(const CacheAligned<U>& /*other*/) noexcept {}

  T* allocate(std::size_t n) {
    void* p = ::operator new(n * sizeof(T), alignment(n));
#ifdef MADV_HUGEPAGE
    if (n * sizeof(T) >= kHugePage) madvise(p, n * sizeof(T), MADV_HUGEPAGE);  // advice: nothing is lost where it is not taken
#endif
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) noexcept { ::operator delete(p, alignment(n)); }
  friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }

 private:
  static std::align_val_t alignment(std::size_t n) noexcept { return std::align_val_t{n * sizeof(T) >= kHugePage ? kHugePage : 64}; }
};

template <class T>
using Array = std::vector<T, CacheAligned<T>>;

constexpr std::int64_t round_up(std::int64_t n, std::int64_t multiple) { return (n + multiple - 1) / multiple * multiple; }

}  // namespace voussoir::solver
