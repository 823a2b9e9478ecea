// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/world/wake_ups.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <limits>

namespace voussoir::solver {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kFlags = sizeof(std::uint64_t);
constexpr std::size_t kAtATime = 64;  // elements

}  // namespace

void WakeUps::reset(std::int32_t elements, std::int32_t items, std::span<const Link> links) {
  const auto n = static_cast<std::size_t>(elements);
  first_.assign(n + 1, 0);
  for (const Link& l : links) {
    if (l.element != kNone) ++first_[static_cast<std::size_t>(l.element) + 1];
  }
  for (std::size_t e = 0; e < n; ++e) first_[e + 1] += first_[e];
  const auto places = static_cast<std::size_t>(first_[n]);
  item_.resize(places);
  limit_.assign(places, kNever);
  place_.assign(links.size(), kNone);
  next_.assign(n, kNever);
  std::vector<std::int64_t> at(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].element == kNone) continue;
    const std::int64_t place = at[static_cast<std::size_t>(links[i].element)]++;
    item_[static_cast<std::size_t>(place)] = links[i].item;
    place_[i] = static_cast<std::int32_t>(place);
  }
  is_awake_.assign((static_cast<std::size_t>(items) + kFlags - 1) / kFlags * kFlags, 0);
  std::fill_n(is_awake_.begin(), items, std::uint8_t{1});
}

void WakeUps::wake_items_of(std::size_t element, double bound) {
  double least = kNever;
  for (auto k = static_cast<std::size_t>(first_[element]); k < static_cast<std::size_t>(first_[element + 1]); ++k) {
    if (bound >= limit_[k]) {
      limit_[k] = kNever;
      is_awake_[static_cast<std::size_t>(item_[k])] = 1;
    }
    least = std::min(least, limit_[k]);
  }
  next_[element] = least;
}

void WakeUps::wake(const double* bound) {
  const std::size_t n = next_.size();
  for (std::size_t e = 0; e < n; e += kAtATime) {
    const std::size_t last = std::min(n, e + kAtATime);
    int due = 0;
    for (std::size_t k = e; k < last; ++k) due |= static_cast<int>(bound[k] >= next_[k]);
    if (due == 0) continue;
    for (std::size_t k = e; k < last; ++k) {
      if (bound[k] >= next_[k]) wake_items_of(k, bound[k]);
    }
  }
  awake_.clear();
  for (std::size_t i = 0; i < is_awake_.size(); i += kFlags) {
    std::uint64_t flags;
    std::memcpy(&flags, &is_awake_[i], sizeof flags);
    for (; flags != 0; flags &= flags - 1) awake_.push_back(static_cast<std::int32_t>(i) + std::countr_zero(flags) / 8);
  }
}

void WakeUps::set_limit(std::size_t link, std::int32_t element, double limit) noexcept {
  if (place_[link] == kNone) return;
  limit_[static_cast<std::size_t>(place_[link])] = limit;
  const std::atomic_ref<double> next(next_[static_cast<std::size_t>(element)]);
  double now = next.load(std::memory_order_relaxed);
  while (limit < now && !next.compare_exchange_weak(now, limit, std::memory_order_relaxed)) {
  }
}

std::size_t WakeUps::bytes() const noexcept {
  return first_.size() * sizeof first_[0] + item_.size() * sizeof item_[0] + limit_.size() * sizeof limit_[0] +
         place_.size() * sizeof place_[0] + next_.size() * sizeof next_[0] + is_awake_.size() + awake_.size() * sizeof awake_[0];
}

}  // namespace voussoir::solver
