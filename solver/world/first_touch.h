// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Memory near the threads that use it. A machine with several memories (NUMA) gives a page out of that of the core that writes there
/// first.
namespace voussoir::solver {

/// Has each of `threads` threads write first to its own share of an array that nobody has written to. Shares are equal parts of each
/// section from border to border (ascending), as threads deal out what they do; none: one section. \param width  bytes of an entry
void touch_in_shares(void* data, std::size_t count, std::size_t width, int threads, std::span<const std::int64_t> borders);

/// Room for n entries in all, touched in shares if it is new. Numbers and their order stay. Worth it only for arrays of the step.
template <class Vector>
void reserve_in_shares(Vector& v, std::size_t n, int threads, std::span<const std::int64_t> borders = {}) {
  if (n <= v.capacity()) return;
  Vector larger;
  larger.reserve(n);
  touch_in_shares(larger.data(), n, sizeof(typename Vector::value_type), threads, borders);
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// As v.assign(n, value).
template <class Vector>
void assign_in_shares(Vector& v, std::size_t n, const typename Vector::value_type& value, int threads,
                      std::span<const std::int64_t> borders = {}) {
  reserve_in_shares(v, n, threads, borders);
  v.assign(n, value);
}

/// As v.resize(n), with room for as much again where the array has to grow.
template <class Vector>
void resize_in_shares(Vector& v, std::size_t n, int threads) {
  if (n > v.capacity()) reserve_in_shares(v, n > 2 * v.capacity() ? n : 2 * v.capacity(), threads);
  v.resize(n);
}

}  // namespace voussoir::solver
