// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kLeast = 16 * kPage;  // what is smaller stays in the caches, wherever its memory is

}  // namespace

void touch_in_shares(void* data, std::size_t width, Team& team, std::span<const std::int64_t> borders) {
  if (team.size() < 2 || borders.size() < 2 || static_cast<std::size_t>(borders.back() - borders.front()) * width < kLeast) return;
  auto* bytes = static_cast<volatile unsigned char*>(data);
  team.run_on_all([&](int thread) {
    const auto threads = static_cast<std::size_t>(team.size()), own = static_cast<std::size_t>(thread);
    for (std::size_t s = 0; s + 1 < borders.size(); ++s) {
      const auto first = static_cast<std::size_t>(borders[s]) * width, size = static_cast<std::size_t>(borders[s + 1]) * width - first;
      for (std::size_t at = first + size * own / threads; at < first + size * (own + 1) / threads; at += kPage) bytes[at] = 0;
    }
  });
}

}  // namespace voussoir::solver
