// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <mutex>
#include <span>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace voussoir::geometry {

/// A segment: its contact point (s, t) [m] in the frame of its patch, and its area [m2].
struct Segment {
  double s = 0.0, t = 0.0, area = 0.0;
};

/// Segments of one side of a joint, or of a free patch: a view of a list that a SegmentStore keeps.
using SegmentList = std::span<const Segment>;

/// Keeps each distinct list of segments once: thousands of equal bricks of a building share their lists.
class SegmentStore {
 public:
  SegmentStore() = default;
  SegmentStore(const SegmentStore&) = delete;
  SegmentStore& operator=(const SegmentStore&) = delete;

  /// Returns the stored list that equals `segments` bit for bit, added if new. Valid as long as the store. Safe to call from any number of
  /// threads at once.
  SegmentList keep(SegmentList segments);

 private:
  struct Hashed {
    std::string_view bytes;  // the bytes of a list
    std::size_t hash;
    friend bool operator==(const Hashed& a, const Hashed& b) { return a.bytes == b.bytes; }
  };
  struct HashOf {
    std::size_t operator()(const Hashed& h) const noexcept { return h.hash; }
  };
  /// The lists whose hashes have the same remainder. Each shelf has its own lock, so threads seldom wait for each other.
  struct Shelf {
    std::mutex lock;
    std::deque<std::vector<Segment>> lists;    // a deque, since its elements never move
    std::unordered_set<Hashed, HashOf> known;  // hashes of `lists`
  };
  std::array<Shelf, 64> shelves_;
};

}  // namespace voussoir::geometry
