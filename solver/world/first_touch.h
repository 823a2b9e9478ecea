// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/team/team.h"

/// Placement of memory near the threads that use it. On a machine with several memories (NUMA) the system places a page in the memory of
/// the core that first writes to it. Effective if threads stay on their cores (OMP_PROC_BIND=close).
namespace voussoir::solver {

/// Lets each thread of a team write first to its share of a new array: each section of entries from one border to the next is divided into
/// as many equal parts as there are threads, and thread k writes to the k-th part.
/// \param width  bytes of an entry
/// \param borders  ascending; entries outside all sections are not written
void touch_in_shares(void* data, std::size_t width, Team& team, std::span<const std::int64_t> borders);

/// Reserves memory like v.reserve(room). New memory is first written by the threads in whose shares it lies. Contents are kept.
template <class Vector>
void reserve_in_shares(Vector& v, std::size_t room, Team& team, std::span<const std::int64_t> borders) {
  if (room <= v.capacity()) return;
  Vector larger;
  larger.reserve(room);
  touch_in_shares(larger.data(), sizeof(typename Vector::value_type), team, borders);
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// Reserves memory for a growing array: n entries, as one section, and half as many more, which are not written.
template <class Vector>
void reserve_in_shares(Vector& v, std::size_t n, Team& team) {
  if (n > v.capacity()) reserve_in_shares(v, n + n / 2, team, std::array<std::int64_t, 2>{0, static_cast<std::int64_t>(n)});
}

/// Assigns like v.assign(n, value), with memory reserved in shares. \param borders  of sections; none: one section
template <class Vector>
void assign_in_shares(Vector& v, std::size_t n, const typename Vector::value_type& value, Team& team,
                      std::span<const std::int64_t> borders = {}) {
  const std::array<std::int64_t, 2> whole{0, static_cast<std::int64_t>(n)};
  reserve_in_shares(v, n, team, borders.empty() ? std::span<const std::int64_t>(whole) : borders);
  v.assign(n, value);
}

}  // namespace voussoir::solver
