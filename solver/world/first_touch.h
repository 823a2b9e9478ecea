// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Memory near the threads that use it. On a machine with several memories (NUMA) the system places a page in the memory of the core that
/// first writes to it. This helps where threads stay on their cores (OMP_PROC_BIND=close).
namespace voussoir::solver {

/// Has each of `threads` threads be the first to write to its share of an array that nobody has written to: of each section of entries
/// from one border to the next, thread k writes to the k-th of as many equal parts.
/// \param width    bytes of an entry
/// \param borders  ascending; entries that lie in no section are left alone
void touch_in_shares(void* data, std::size_t width, int threads, std::span<const std::int64_t> borders);

/// Reserves as v.reserve(room) does. Memory that is new is first written to by the threads in whose shares it lies. The contents stay.
template <class Vector>
void reserve_in_shares(Vector& v, std::size_t room, int threads, std::span<const std::int64_t> borders) {
  if (room <= v.capacity()) return;
  Vector larger;
  larger.reserve(room);
  touch_in_shares(larger.data(), sizeof(typename Vector::value_type), threads, borders);
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// For arrays that grow: room for n entries, in one section, and for half as many more, which nobody has written to.
template <class Vector>
void reserve_in_shares(Vector& v, std::size_t n, int threads) {
  if (n > v.capacity()) reserve_in_shares(v, n + n / 2, threads, std::array<std::int64_t, 2>{0, static_cast<std::int64_t>(n)});
}

/// As v.assign(n, value), with room made in shares. \param borders  of sections; none: one section
template <class Vector>
void assign_in_shares(Vector& v, std::size_t n, const typename Vector::value_type& value, int threads,
                      std::span<const std::int64_t> borders = {}) {
  const std::array<std::int64_t, 2> whole{0, static_cast<std::int64_t>(n)};
  reserve_in_shares(v, n, threads, borders.empty() ? std::span<const std::int64_t>(whole) : borders);
  v.assign(n, value);
}

}  // namespace voussoir::solver
