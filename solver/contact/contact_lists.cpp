// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/contact_lists.h"

#include <algorithm>

namespace voussoir::solver {

namespace {

struct Pair {
  std::int32_t patch = 0;
  kernels::Candidate candidate;
};

/// With the travel of both bodies before they can touch.
kernels::Candidate candidate_found(const World& w, const Found& f, std::size_t i) {
  kernels::Candidate k = candidate_of(w, f.element[i]);
  const std::int32_t master = w.patches.patch[static_cast<std::size_t>(f.patch[i])].element;
  k.safe = w.travel.bound(master) + w.travel.bound(f.element[i]) + f.gap[i] - kernels::kRoundOff;
  return k;
}

/// Pairs that stay. Marks patches that lose some.
std::vector<Pair> kept_pairs(const Contacts& c, const ReSearch& re_search, std::vector<std::uint8_t>& changed) {
  std::vector<Pair> pairs;
  pairs.reserve(c.candidate.size());
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    const auto p = static_cast<std::size_t>(c.active[a]);
    if (re_search.patch[p] != 0) continue;
    for (auto slot = static_cast<std::size_t>(c.first_slot[a]); slot < static_cast<std::size_t>(c.first_slot[a + 1]); ++slot) {
      const kernels::Candidate& k = c.candidate[slot];
      if (re_search.element[static_cast<std::size_t>(k.element)] != 0) {
        changed[p] = 1;
      } else {
        pairs.push_back({c.active[a], k});
      }
    }
  }
  return pairs;
}

/// Fills the lists with pairs, patch by patch, those of a patch in the order in which they come.
void fill_slots(Contacts& c, std::size_t patches, const std::vector<Pair>& pairs) {
  std::vector<std::int64_t> at(patches + 1, 0);
  for (const Pair& pair : pairs) ++at[static_cast<std::size_t>(pair.patch) + 1];
  c.active.clear();
  c.first_slot.clear();
  for (std::size_t p = 0; p < patches; ++p) {
    if (at[p + 1] != 0) c.active.push_back(static_cast<std::int32_t>(p)), c.first_slot.push_back(at[p]);
    at[p + 1] += at[p];
  }
  c.first_slot.push_back(static_cast<std::int64_t>(pairs.size()));
  c.candidate.resize(pairs.size());
  c.element.resize(pairs.size());
  for (const Pair& pair : pairs) {
    const auto slot = static_cast<std::size_t>(at[static_cast<std::size_t>(pair.patch)]++);
    c.candidate[slot] = pair.candidate;
    c.element[slot] = pair.candidate.element;
  }
  c.wrench.resize(pairs.size());
  c.on.assign(pairs.size(), 0);
}

/// Lets go of partners that are no candidates any more: they are farther away than the skin.
void release_lost(World& w, std::size_t p, std::span<const std::int32_t> candidates) {
  FreePatch& patch = w.patches.patch[p];
  if (patch.touching == 0) return;
  const kernels::ContactPoints q = w.patches.points(static_cast<std::int64_t>(p));
  const int n = w.points.count[static_cast<std::size_t>(patch.set)];
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
void settle_partners(World& w, const std::vector<std::uint8_t>& changed) {
  Contacts& c = w.contacts;
  std::size_t a = 0;
  for (std::size_t p = 0; p < changed.size(); ++p) {
    const bool active = a < c.active.size() && static_cast<std::size_t>(c.active[a]) == p;
    const auto first = static_cast<std::size_t>(active ? c.first_slot[a] : 0),
               last = static_cast<std::size_t>(active ? c.first_slot[++a] : 0);
    if (changed[p] == 0) continue;
    const std::int32_t touching = w.patches.patch[p].touching;
    release_lost(w, p, {c.element.data() + first, last - first});
    const bool released = w.patches.patch[p].touching < touching;
    for (std::size_t slot = first; slot < last; ++slot) {
      c.candidate[slot].face = touching == 0 ? kernels::kNoFace : kernels::kUnknownFace;
      if (released) c.candidate[slot].safe = kernels::kLookNow;  // a point that is free now is a new one for all
    }
  }
}

/// Of multi-rate stepping: the levels of patches, and who gathers from them.
void find_levels(World& w) {
  Contacts& c = w.contacts;
  c.level.clear(), c.gather_level.clear();
  if (!w.multirate.on()) return;
  const int levels = w.multirate.levels();
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    int lowest = levels - 1;
    for (auto slot = static_cast<std::size_t>(c.first_slot[a]); slot < static_cast<std::size_t>(c.first_slot[a + 1]); ++slot)
      lowest = std::min(lowest, w.multirate.contact_level(c.master[a], c.element[slot]));
    c.level.push_back(static_cast<std::uint8_t>(lowest));
  }
  c.patches.sort(c.level, levels);
  c.gather_level.assign(c.gather_on.size(), 0);
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    for (auto code = static_cast<std::size_t>(2 * c.first_slot[a]); code < static_cast<std::size_t>(2 * c.first_slot[a + 1]); ++code) {
      if (c.place[code] >= 0) c.gather_level[static_cast<std::size_t>(c.place[code])] = c.level[a];
    }
  }
  std::vector<std::uint8_t> lowest(static_cast<std::size_t>(w.elements.count), static_cast<std::uint8_t>(levels));
  for (std::size_t e = 0; e < lowest.size(); ++e) {
    for (std::int64_t g = c.first_gather[e]; g < c.first_gather[e + 1]; ++g)
      lowest[e] = std::min(lowest[e], c.gather_level[static_cast<std::size_t>(g)]);
  }
  c.gatherers.sort(lowest, levels);
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
  c.candidate.clear();
  for (const std::int32_t e : c.element) c.candidate.push_back(candidate_of(w, e));
  c.wrench.assign(c.element.size(), {});
  c.on.assign(c.element.size(), 0);
  c.stale_level = 0;  // the lists know who pushed
}

void build_gather(World& w) {
  Contacts& c = w.contacts;
  const auto n = static_cast<std::size_t>(w.elements.count);
  const auto each = [&](auto&& use) {
    for (std::size_t a = 0; a < c.active.size(); ++a) {
      for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
        use(static_cast<std::size_t>(c.master[a]), 2 * slot);
        const std::int32_t slave = c.element[static_cast<std::size_t>(slot)];
        if (slave != w.elements.base) use(static_cast<std::size_t>(slave), 2 * slot + 1);
      }
    }
  };
  c.master.resize(c.active.size());
  for (std::size_t a = 0; a < c.active.size(); ++a) c.master[a] = w.patches.patch[static_cast<std::size_t>(c.active[a])].element;
  c.first_gather.assign(n + 1, 0);
  each([&](std::size_t e, std::int64_t) {
    ++c.first_gather[e + 1];
    w.travel.activate(w.elements, static_cast<std::int32_t>(e));
  });
  for (std::size_t e = 0; e < n; ++e) c.first_gather[e + 1] += c.first_gather[e];
  c.gather.resize(static_cast<std::size_t>(c.first_gather[n]));
  std::vector<std::int64_t> at = c.first_gather;
  c.place.assign(2 * c.element.size(), -1);
  c.gather_on.assign(c.gather.size() + sizeof(std::uint64_t), 0);
  each([&](std::size_t e, std::int64_t code) {
    const auto place = static_cast<std::size_t>(at[e]++);
    c.gather[place] = code;
    c.place[static_cast<std::size_t>(code)] = static_cast<std::int32_t>(place);
    c.gather_on[place] = c.on[static_cast<std::size_t>(code / 2)];
  });
  find_levels(w);
  c.stale_level = Contacts::kUpToDate;
}

void replace_candidates(World& w, const ReSearch& re_search, std::span<const Found> found) {
  Contacts& c = w.contacts;
  std::vector<std::uint8_t> changed = re_search.patch;
  std::vector<Pair> pairs = kept_pairs(c, re_search, changed);
  for (const Found& f : found) {
    for (std::size_t i = 0; i < f.patch.size(); ++i) {
      changed[static_cast<std::size_t>(f.patch[i])] = 1;
      pairs.push_back({f.patch[i], candidate_found(w, f, i)});
    }
  }
  fill_slots(c, w.patches.patch.size(), pairs);
  settle_partners(w, changed);
  c.searched = static_cast<std::int64_t>(c.active.size());
  w.travel.answer_search();
  c.stale_level = 0;
}

}  // namespace voussoir::solver
