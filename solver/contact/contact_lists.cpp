// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/contact_lists.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/nth.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kAtATime = 512;  // patches, or pairs, that a thread takes

/// Calls `work(i)` for all i below `count`.
template <class Work>
void for_all(Team& team, std::size_t count, Work work) {
  team.share_out(static_cast<std::int64_t>(count), kAtATime, [&](std::int64_t first, std::int64_t last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) work(i);
  });
}

/// How many candidates every patch keeps, beside those that a search has found for patches that are searched again. Marks patches whose
/// candidates change.
void count_kept(const Contacts& c, SearchRoom& room, Team& team) {
  std::ranges::copy(room.re_search.patch, room.changed.begin());
  for_all(team, c.active.size(), [&](std::size_t a) {
    const auto p = static_cast<std::size_t>(c.active[a]);
    if (room.re_search.patch[p] != 0) return;
    const auto first = c.element.begin() + c.first_slot[a], last = c.element.begin() + c.first_slot[a + 1];
    const auto kept = std::count_if(first, last, [&](std::int32_t e) { return nth(room.re_search.element, e) == 0; });
    room.candidates[p] = static_cast<std::int32_t>(kept);
    if (kept != last - first) room.changed[p] = 1;
  });
}

/// Gives pairs of patches that are not searched again their places, in the order of the elements that were.
void rank_found(SearchRoom& room) {
  for (const FoundRun& run : room.found) {
    FoundPairs& found = nth(room.by_thread, run.thread).around;
    for (std::size_t i = run.first; i < run.last; ++i) {
      const auto p = static_cast<std::size_t>(found.patch[i]);
      found.rank[i] = room.candidates[p]++;
      room.changed[p] = 1;
    }
  }
}

void reserve_slots(Contacts& c, std::size_t slots, Team& team) {
  reserve_in_shares(c.candidate, slots, team), reserve_in_shares(c.element, slots, team), reserve_in_shares(c.wrench, slots, team);
}

/// Gives every patch that has candidates its slots. Leaves the lists of before in the room.
void lay_out(Contacts& c, SearchRoom& room, Team& team) {
  std::swap(c.active, room.active), std::swap(c.first_slot, room.first_slot), std::swap(c.candidate, room.candidate);
  c.active.clear(), c.first_slot.clear();
  room.first_of.resize(room.candidates.size() + 1);
  std::int64_t at = 0;
  for (std::size_t p = 0; p < room.candidates.size(); ++p) {
    room.first_of[p] = at;
    if (room.candidates[p] != 0) c.active.push_back(static_cast<std::int32_t>(p)), c.first_slot.push_back(at);
    at += room.candidates[p];
  }
  room.first_of.back() = at;
  c.first_slot.push_back(at);
  const auto slots = static_cast<std::size_t>(at);
  reserve_slots(c, slots, team);
  c.candidate.resize(slots), c.element.resize(slots), c.wrench.resize(slots);
  c.on.assign(slots, 0);
}

void put(Contacts& c, std::int64_t slot, const kernels::Candidate& k) {
  nth(c.candidate, slot) = k;
  nth(c.element, slot) = k.element;
}

/// Candidates that stay, in their order, and behind them those found.
void fill_slots(Contacts& c, const SearchRoom& room, Team& team) {
  for_all(team, room.active.size(), [&](std::size_t a) {
    const auto p = static_cast<std::size_t>(room.active[a]);
    if (room.re_search.patch[p] != 0) return;
    std::int64_t to = room.first_of[p];
    for (std::int64_t slot = room.first_slot[a]; slot < room.first_slot[a + 1]; ++slot) {
      const kernels::Candidate& k = nth(room.candidate, slot);
      if (nth(room.re_search.element, k.element) == 0) put(c, to++, k);
    }
  });
  for (const SearchOfThread& t : room.by_thread) {
    for (const FoundPairs* found : {&t.own, &t.around}) {
      for_all(team, found->size(),
              [&](std::size_t i) { put(c, nth(room.first_of, found->patch[i]) + found->rank[i], found->candidate[i]); });
    }
  }
}

/// Lets go of partners that are no candidates any more: they are farther away than the skin.
void release_lost(World& w, std::size_t p, std::span<const std::int32_t> candidates) {
  FreePatch& patch = w.patches.patch[p];
  if (patch.touching == 0) return;
  const kernels::ContactPoints q = w.patches.points(static_cast<std::int64_t>(p));
  const int n = nth(w.points.count, patch.set);
  for (int i = 0; i < n; ++i) {
    const std::int32_t partner = q.partner[i];
    if (partner == kernels::kNobody) continue;
    if (std::ranges::find(candidates, partner) != candidates.end()) continue;
    q.partner[i] = kernels::kNobody;
    q.face[i] = kernels::kNoFace;
    q.set_slip(i, {});
    q.closure(i) = q.recess(i);
    --patch.touching;
  }
  if (patch.touching > 0) return;
  patch.impact += patch.stored;  // nothing, but where a support has jumped away
  patch.stored = 0.0;
}

/// The patches whose candidates are others than before: who touches whom is to be listed again, where anything touches.
void settle_partners(World& w) {
  Contacts& c = w.contacts;
  const SearchRoom& room = c.room;
  for_all(w.team, room.changed.size(), [&](std::size_t p) {
    if (room.changed[p] == 0) return;
    const auto first = static_cast<std::size_t>(room.first_of[p]), last = static_cast<std::size_t>(room.first_of[p + 1]);
    const std::int32_t touching = w.patches.patch[p].touching;
    release_lost(w, p, {c.element.data() + first, last - first});
    const bool released = w.patches.patch[p].touching < touching;
    for (std::size_t slot = first; slot < last; ++slot) {
      c.candidate[slot].face = touching == 0 ? kernels::kNoFace : kernels::kUnknownFace;
      if (released) c.candidate[slot].safe = kernels::kLookNow;  // a point that is free now is a new one for all
    }
  });
}

}  // namespace

kernels::Candidate candidate_of(const World& w, std::int32_t element) {
  const auto e = static_cast<std::size_t>(element);
  kernels::Candidate c;
  c.element = element, c.first_face = w.elements.first_face[e], c.face_count = w.elements.face_count[e];
  return c;
}

void list_candidates(World& w) {
  Contacts& c = w.contacts;
  reserve_slots(c, c.element.size(), w.team);
  c.candidate.clear();
  for (const std::int32_t e : c.element) c.candidate.push_back(candidate_of(w, e));
  c.wrench.assign(c.element.size(), {});
  c.on.assign(c.element.size(), 0);
  c.stale_level = 0;  // the lists know who pushed
}

void replace_candidates(World& w) {
  Contacts& c = w.contacts;
  SearchRoom& room = c.room;
  room.changed.resize(room.re_search.patch.size());
  count_kept(c, room, w.team);
  rank_found(room);
  lay_out(c, room, w.team);
  fill_slots(c, room, w.team);
  settle_partners(w);
  c.searched = static_cast<std::int64_t>(c.active.size());
  w.travel.answer_search();
  c.stale_level = 0;
}

}  // namespace voussoir::solver
