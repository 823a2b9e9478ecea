// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace voussoir::solver {

/// Distance in bytes between arrays written by different threads. The hardware prefetcher fetches some twenty lines past the end of an
/// array; if another thread writes there, the lines move to this core and have to move back.
inline constexpr std::size_t kApart = 4096;

/// Allocator for arrays on cache lines, so that vector loads never straddle two lines, with kApart between arrays; large arrays on huge
/// pages if the system has them, since joints access rows of elements all over a building, and with small pages each access would be a TLB
/// miss.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;

  CacheAligned() = default;
  template <class U>
  explicit CacheAligned(const CacheAligned<U>& /*other*/) noexcept {}

  T* allocate(std::size_t n) {
    void* p = ::operator new(n * sizeof(T) + kApart, alignment(n));
#ifdef MADV_HUGEPAGE
    if (n * sizeof(T) >= kHugePage) madvise(p, n * sizeof(T), MADV_HUGEPAGE);  // advice, which may be ignored
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

/// An array of numbers that are initially zero and mostly stay so: the system allocates a page when it is first written, so the history of
/// unchanged segments takes no memory, and a page is near the thread that wrote it first.
template <class T>
class ZeroArray {
 public:
  using value_type = T;
  static_assert(std::is_trivially_copyable_v<T>);

  ZeroArray() = default;
  ZeroArray(ZeroArray&& other) noexcept { swap(other); }
  ZeroArray& operator=(ZeroArray&& other) noexcept {
    ZeroArray(std::move(other)).swap(*this);
    return *this;
  }
  ZeroArray(const ZeroArray&) = delete;
  ZeroArray& operator=(const ZeroArray&) = delete;
  ~ZeroArray() {
    if (data_ != nullptr) munmap(data_, room_ * sizeof(T));
  }

  void assign_zeros(std::size_t n) {
    *this = {};
    resize(n);
  }
  /// Keeps the contents; new entries are zero. \pre n is not less than size()
  void resize(std::size_t n) {
    if (n > room_) make_room(std::max(n, 2 * room_));
    size_ = n;
  }

  [[nodiscard]] T* data() noexcept { return data_; }
  [[nodiscard]] const T* data() const noexcept { return data_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] const T* begin() const noexcept { return data_; }
  [[nodiscard]] const T* end() const noexcept { return data_ + size_; }
  /// Bytes of the pages with values other than zero.
  [[nodiscard]] std::size_t in_use() const {
    constexpr std::size_t kPage = 4096;
    const auto* bytes = reinterpret_cast<const unsigned char*>(data_);
    std::size_t pages = 0;
    for (std::size_t at = 0; at < size_ * sizeof(T); at += kPage) {
      const auto *from = bytes + at, *to = bytes + std::min(size_ * sizeof(T), at + kPage);
      pages += std::any_of(from, to, [](unsigned char x) { return x != 0; });
    }
    return pages * kPage;
  }
  T& operator[](std::size_t i) noexcept { return data_[i]; }
  const T& operator[](std::size_t i) const noexcept { return data_[i]; }

 private:
  void swap(ZeroArray& other) noexcept { std::swap(data_, other.data_), std::swap(size_, other.size_), std::swap(room_, other.room_); }

  void make_room(std::size_t n) {
    // Moved pages keep their state: pages never written to still take no memory.
    void* p = data_ == nullptr ? mmap(nullptr, n * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)
                               : mremap(data_, room_ * sizeof(T), n * sizeof(T), MREMAP_MAYMOVE);
    if (p == MAP_FAILED) throw std::bad_alloc();
    madvise(p, n * sizeof(T), MADV_NOHUGEPAGE);  // with huge pages a single crack would take two megabytes
    data_ = static_cast<T*>(p), room_ = n;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
};

constexpr std::int64_t round_up(std::int64_t n, std::int64_t multiple) { return (n + multiple - 1) / multiple * multiple; }

}  // namespace voussoir::solver
