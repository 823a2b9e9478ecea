// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "geometry/nth.h"
#include "solver/contact/contact_lists.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kPatchesGathered = 256, kElementsGathered = 512;
constexpr std::int64_t kRoom = 8;  // slots of sides that retire before the lists are made again, for each element that may have some

/// One of several parts of the active patches, about as many slots in each: [first, last).
struct PatchRange {
  std::size_t first = 0, last = 0;
};
PatchRange part_of(const Contacts& c, std::int64_t part, std::int64_t parts) {
  if (c.active.empty()) return {};
  const auto begin = [&](std::int64_t p) {
    const std::int64_t slots = static_cast<std::int64_t>(c.element.size()) * p / parts;
    return static_cast<std::size_t>(std::lower_bound(c.first_slot.begin(), c.first_slot.end() - 1, slots) - c.first_slot.begin());
  };
  return {begin(part), part + 1 == parts ? c.active.size() : begin(part + 1)};
}

/// Calls `use(element, code)` for those that gather the slots of these patches, in the order of codes.
template <class Use>
void each_code(const World& w, PatchRange patches, Use use) {
  const Contacts& c = w.contacts;
  for (std::size_t a = patches.first; a < patches.last; ++a) {
    for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
      use(static_cast<std::size_t>(c.master[a]), 2 * slot);
      const std::int32_t slave = nth(c.element, slot);
      if (slave != w.elements.base) use(static_cast<std::size_t>(slave), 2 * slot + 1);
    }
  }
}

/// Room for what has been counted, and where it begins. Elements that gather have velocity rows and travel bounds from now on.
void part_room(World& w, const std::vector<std::int64_t>& total) {
  Contacts& c = w.contacts;
  std::int64_t at = 0;
  for (std::size_t e = 0; e < total.size(); ++e) {
    c.first_gather[e] = at;
    at += total[e];
    if (total[e] != 0 || w.elements.bonds[e] < w.elements.bonds_at_start[e]) at += kRoom;
    if (total[e] != 0) w.travel.activate(w.elements, static_cast<std::int32_t>(e));
  }
  c.first_gather[total.size()] = at;
  c.gather.resize(static_cast<std::size_t>(at));
  c.gather_on.assign(static_cast<std::size_t>(at) + sizeof(std::uint64_t), 0);
}

/// Of multi-rate stepping: the levels of patches, and who gathers from them.
void find_levels(World& w) {
  Contacts& c = w.contacts;
  c.level.clear(), c.gather_level.clear();
  if (!w.multirate.on()) return;
  const int levels = w.multirate.levels();
  c.level.resize(c.active.size());
  c.gather_level.assign(c.gather_on.size(), 0);
  const auto find = [&](std::size_t a) {
    int lowest = levels - 1;
    for (auto slot = static_cast<std::size_t>(c.first_slot[a]); slot < static_cast<std::size_t>(c.first_slot[a + 1]); ++slot)
      lowest = std::min(lowest, w.multirate.contact_level(c.master[a], c.element[slot]));
    c.level[a] = static_cast<std::uint8_t>(lowest);
    for (auto code = static_cast<std::size_t>(2 * c.first_slot[a]); code < static_cast<std::size_t>(2 * c.first_slot[a + 1]); ++code) {
      if (c.place[code] >= 0) nth(c.gather_level, c.place[code]) = c.level[a];
    }
  };
  w.team.share_out(static_cast<std::int64_t>(c.active.size()), kPatchesGathered, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t a = first; a < last; ++a) find(static_cast<std::size_t>(a));
  });
  c.patches.sort(c.level, levels);
  std::vector<std::uint8_t> lowest(static_cast<std::size_t>(w.elements.count), static_cast<std::uint8_t>(levels));
  for (std::size_t e = 0; e < lowest.size(); ++e) {
    for (std::int64_t g = c.first_gather[e]; g < c.last_gather[e]; ++g) lowest[e] = std::min(lowest[e], nth(c.gather_level, g));
  }
  c.gatherers.sort(lowest, levels);
}

/// \pre the flag of the place is 0
void put(Contacts& c, std::size_t place, std::int64_t code) {
  c.gather[place] = static_cast<std::int32_t>(code);
  nth(c.place, code) = static_cast<std::int32_t>(place);
  if (nth(c.on, code / 2) != 0) c.gather_on[place] = 1;  // few push
}

}  // namespace

// Counting sort. The codes of one part lie before those of the next.
void build_gather(World& w) {
  Contacts& c = w.contacts;
  const auto n = static_cast<std::int64_t>(w.elements.count);
  const std::int64_t parts = w.team.size();
  c.master.resize(c.active.size());
  c.first_gather.resize(static_cast<std::size_t>(n) + 1), c.last_gather.resize(static_cast<std::size_t>(n));
  c.place.resize(2 * c.element.size());
  std::vector<std::vector<std::int32_t>>& counts = c.room.gather_counts;
  counts.resize(static_cast<std::size_t>(parts));
  std::vector<std::int64_t>& total = c.last_gather;
  const auto each_part = [&](auto work) {
    w.team.share_out(parts, 1, [&](std::int64_t first, std::int64_t last) {
      for (std::int64_t p = first; p < last; ++p) work(part_of(c, p, parts), nth(counts, p));
    });
  };
  const auto each_element = [&](auto work) {
    w.team.share_out(n, kElementsGathered, [&](std::int64_t first, std::int64_t last) {
      for (auto e = static_cast<std::size_t>(first); e < static_cast<std::size_t>(last); ++e) work(e);
    });
  };
  each_part([&](PatchRange patches, std::vector<std::int32_t>& count) {
    count.assign(static_cast<std::size_t>(n), 0);
    for (std::size_t a = patches.first; a < patches.last; ++a) c.master[a] = nth(w.patches.element, c.active[a]);
    each_code(w, patches, [&](std::size_t e, std::int64_t) { ++count[e]; });
  });
  each_element([&](std::size_t e) {
    // From counts to what lies before those of a part.
    std::int32_t before = 0;
    for (std::vector<std::int32_t>& count : counts) before += std::exchange(count[e], before);
    total[e] = before;
  });
  part_room(w, total);
  each_element([&](std::size_t e) { c.last_gather[e] = c.first_gather[e] + total[e]; });
  each_part([&](PatchRange patches, std::vector<std::int32_t>& at) {
    each_code(w, patches, [&](std::size_t e, std::int64_t code) {
      put(c, static_cast<std::size_t>(c.first_gather[e] + at[e]++), code);
      if (code % 2 == 0 && nth(c.element, code / 2) == w.elements.base) nth(c.place, code + 1) = -1;
    });
  });
  find_levels(w);
  c.stale_level = Contacts::kUpToDate;
}

void add_to_gather(World& w) {
  Contacts& c = w.contacts;
  const std::size_t a = c.active.size() - 1;
  const std::int64_t slot = c.first_slot[a];
  const std::int32_t master = nth(w.patches.element, c.active[a]), slave = nth(c.element, slot);
  const auto has_room = [&](std::int32_t e) {
    return e == w.elements.base || nth(c.last_gather, e) < c.first_gather[static_cast<std::size_t>(e) + 1];
  };
  const int level = w.multirate.contact_level(master, slave);
  if (w.multirate.on() || c.stale_level < Contacts::kUpToDate || c.first_gather.empty() || c.master.size() != a || !has_room(master) ||
      !has_room(slave)) {
    c.stale_level = std::min(c.stale_level, level);
    return;
  }
  c.master.push_back(master);
  c.place.resize(c.place.size() + 2, -1);
  for (const std::int32_t e : {master, slave}) {
    if (e == w.elements.base) continue;
    put(c, static_cast<std::size_t>(nth(c.last_gather, e)++), 2 * slot + (e == master ? 0 : 1));
    w.travel.activate(w.elements, e);
  }
}

}  // namespace voussoir::solver
