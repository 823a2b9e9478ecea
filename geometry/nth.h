// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace voussoir {

/// Element `i` of an array, counted from 0. Numbers of elements, joints and points are signed, and some are enumerations; containers take
/// unsigned numbers. \pre i is at least 0 and below the length
template <typename Array, typename Index>
requires(std::integral<Index> || std::is_enum_v<Index>) [[nodiscard]] constexpr decltype(auto) nth(Array&& array, Index i) {
  return std::forward<Array>(array)[static_cast<std::size_t>(i)];
}

}  // namespace voussoir
