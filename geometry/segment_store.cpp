// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/segment_store.h"

namespace voussoir::geometry {

namespace {

std::string_view bytes_of(SegmentList list) { return {reinterpret_cast<const char*>(list.data()), list.size_bytes()}; }
SegmentList list_of(std::string_view bytes) { return {reinterpret_cast<const Segment*>(bytes.data()), bytes.size() / sizeof(Segment)}; }

}  // namespace

SegmentList SegmentStore::keep(SegmentList segments) {
  if (segments.empty()) return {};
  const auto found = by_bytes_.find(bytes_of(segments));
  if (found != by_bytes_.end()) return list_of(*found);
  const std::vector<Segment>& kept = lists_.emplace_back(segments.begin(), segments.end());
  by_bytes_.insert(bytes_of(kept));
  return kept;
}

}  // namespace voussoir::geometry
