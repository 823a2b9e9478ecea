// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segments/segment_store.h"

#include <functional>

namespace voussoir::geometry {

namespace {

std::string_view bytes_of(SegmentList list) { return {reinterpret_cast<const char*>(list.data()), list.size_bytes()}; }
SegmentList list_of(std::string_view bytes) { return {reinterpret_cast<const Segment*>(bytes.data()), bytes.size() / sizeof(Segment)}; }

}  // namespace

SegmentList SegmentStore::keep(SegmentList segments) {
  if (segments.empty()) return {};
  const std::string_view bytes = bytes_of(segments);
  const std::size_t hash = std::hash<std::string_view>{}(bytes);
  Shelf& shelf = shelves_[hash % shelves_.size()];
  const std::scoped_lock hold(shelf.lock);
  const auto found = shelf.known.find({bytes, hash});
  if (found != shelf.known.end()) return list_of(found->bytes);
  const std::vector<Segment>& kept = shelf.lists.emplace_back(segments.begin(), segments.end());
  shelf.known.insert({bytes_of(kept), hash});
  return kept;
}

}  // namespace voussoir::geometry
