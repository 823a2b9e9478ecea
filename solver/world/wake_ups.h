// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Which of many items (patches, pairs of bodies) are to be looked at in a step. An item is asleep while each element that it is linked to
/// has a travel bound below the limit of the link: then nothing can have changed, and nobody reads a line of it. Only elements whose bound
/// has come to the least limit of their links are looked at, one comparison an element. No bit of a run depends on it.
namespace voussoir::solver {

class WakeUps {
 public:
  struct Link {
    std::int32_t element = kNone, item = 0;
  };
  static constexpr std::int32_t kNone = -1;  // an element that does not move: the link needs no limit

  /// New links, known by their place in the list; all items are awake.
  void reset(std::int32_t elements, std::int32_t items, std::span<const Link> links);

  /// Wakes the items of links whose limit the bound [m, by element] of their element has come to. By one thread, before awake() is read.
  void wake(const double* bound);

  /// Ascending, as of the last wake().
  [[nodiscard]] std::span<const std::int32_t> awake() const noexcept { return awake_; }

  // Threads may put different items to sleep at the same time: first the limits [m] of all its links, then the item.
  void set_limit(std::size_t link, std::int32_t element, double limit) noexcept;
  void put_to_sleep(std::int32_t item) noexcept { is_awake_[static_cast<std::size_t>(item)] = 0; }

  /// Bytes that it holds.
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  void wake_items_of(std::size_t element, double bound);

  std::vector<std::int64_t> first_;      // by element, into those by place
  std::vector<std::int32_t> item_;       // by place
  std::vector<double> limit_;            // m, by place; of an item that is awake: anything that no bound comes to
  std::vector<std::int32_t> place_;      // by link
  std::vector<double> next_;             // m, by element: no more than the least limit of its links
  std::vector<std::uint8_t> is_awake_;   // by item, and zeros to a multiple of 8
  std::vector<std::int32_t> awake_;
};

}  // namespace voussoir::solver
