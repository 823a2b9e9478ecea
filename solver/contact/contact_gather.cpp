// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <omp.h>

#include <algorithm>
#include <utility>

#include "solver/contact/contact_lists.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kRoom = 8;  // slots of sides that retire before the lists are made again, for each element that may have some

/// Active patches of a thread, about as many slots for each: [first, last).
struct PatchRange {
  std::size_t first = 0, last = 0;
};
PatchRange share_of(const Contacts& c, int thread, int threads) {
  const auto begin = [&](int t) {
    const std::int64_t slots = static_cast<std::int64_t>(c.element.size()) * t / threads;
    return static_cast<std::size_t>(std::lower_bound(c.first_slot.begin(), c.first_slot.end() - 1, slots) - c.first_slot.begin());
  };
  return {begin(thread), thread + 1 == threads ? c.active.size() : begin(thread + 1)};
}

/// Calls `use(element, code)` for those that gather the slots of these patches, in the order of codes.
template <class Use>
void each_code(const World& w, PatchRange patches, Use use) {
  const Contacts& c = w.contacts;
  for (std::size_t a = patches.first; a < patches.last; ++a) {
    for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) {
      use(static_cast<std::size_t>(c.master[a]), 2 * slot);
      const std::int32_t slave = c.element[static_cast<std::size_t>(slot)];
      if (slave != w.elements.base) use(static_cast<std::size_t>(slave), 2 * slot + 1);
    }
  }
}

/// Room for what all threads have counted, and where it begins. Elements that gather have velocity rows and travel bounds from now on.
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

bool is_slow(const World& w, std::size_t a) {
  const Contacts& c = w.contacts;
  return std::all_of(c.element.begin() + c.first_slot[a], c.element.begin() + c.first_slot[a + 1],
                     [&](std::int32_t slave) { return w.multirate.pace_now(c.master[a], slave) == Pace::every_cycle; });
}

/// Of multi-rate stepping: tells those that gather the slots of a patch whether it is slow.
void note_pace(Contacts& c, std::size_t a) {
  for (auto code = static_cast<std::size_t>(2 * c.first_slot[a]); code < static_cast<std::size_t>(2 * c.first_slot[a + 1]); ++code) {
    if (c.place[code] >= 0) c.gather_slow[static_cast<std::size_t>(c.place[code])] = c.slow[a];
  }
}

/// Of multi-rate stepping: which patches are slow.
void find_slow_patches(World& w) {
  Contacts& c = w.contacts;
  c.slow.clear(), c.gather_slow.clear();
  if (!w.multirate.on()) return;
  c.slow.resize(c.active.size());
  c.gather_slow.assign(c.gather_on.size(), 0);
#pragma omp parallel for schedule(static) num_threads(w.threads)
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    c.slow[a] = is_slow(w, a) ? 1 : 0;
    note_pace(c, a);
  }
}

/// \pre the flag of the place is 0
void put(Contacts& c, std::size_t place, std::int64_t code) {
  c.gather[place] = static_cast<std::int32_t>(code);
  c.place[static_cast<std::size_t>(code)] = static_cast<std::int32_t>(place);
  if (c.on[static_cast<std::size_t>(code / 2)] != 0) c.gather_on[place] = 1;  // few push
}

}  // namespace

// Counting sort. The codes of one thread lie before those of the next.
void build_gather(World& w) {
  Contacts& c = w.contacts;
  const auto n = static_cast<std::size_t>(w.elements.count);
  c.master.resize(c.active.size());
  c.first_gather.resize(n + 1), c.last_gather.resize(n);
  c.place.resize(2 * c.element.size());
  std::vector<std::vector<std::int32_t>>& counts = c.room.gather_counts;
  counts.resize(static_cast<std::size_t>(w.threads));
  std::vector<std::int64_t>& total = c.last_gather;
  int team = 0;
#pragma omp parallel num_threads(w.threads)
  {
#pragma omp single
    team = omp_get_num_threads();
    std::vector<std::int32_t>& mine = counts[static_cast<std::size_t>(omp_get_thread_num())];
    mine.assign(n, 0);
    const PatchRange patches = c.active.empty() ? PatchRange{} : share_of(c, omp_get_thread_num(), team);
    for (std::size_t a = patches.first; a < patches.last; ++a) c.master[a] = w.patches.element[static_cast<std::size_t>(c.active[a])];
    each_code(w, patches, [&](std::size_t e, std::int64_t) { ++mine[e]; });
#pragma omp barrier
#pragma omp for schedule(static)
    for (std::size_t e = 0; e < n; ++e) {
      // From counts to what lies before those of a thread.
      std::int32_t before = 0;
      for (int t = 0; t < team; ++t) before += std::exchange(counts[static_cast<std::size_t>(t)][e], before);
      total[e] = before;
    }
#pragma omp single
    part_room(w, total);
#pragma omp for schedule(static)
    for (std::size_t e = 0; e < n; ++e) c.last_gather[e] = c.first_gather[e] + total[e];
    each_code(w, patches, [&](std::size_t e, std::int64_t code) {
      put(c, static_cast<std::size_t>(c.first_gather[e] + mine[e]++), code);
      if (code % 2 == 0 && c.element[static_cast<std::size_t>(code / 2)] == w.elements.base)
        c.place[static_cast<std::size_t>(code + 1)] = -1;
    });
  }
  find_slow_patches(w);
  c.gather_stale = false;
}

void add_to_gather(World& w) {
  Contacts& c = w.contacts;
  const std::size_t a = c.active.size() - 1;
  const std::int64_t slot = c.first_slot[a];
  const std::int32_t master = w.patches.element[static_cast<std::size_t>(c.active[a])], slave = c.element[static_cast<std::size_t>(slot)];
  const auto has_room = [&](std::int32_t e) {
    return e == w.elements.base || c.last_gather[static_cast<std::size_t>(e)] < c.first_gather[static_cast<std::size_t>(e) + 1];
  };
  if (c.gather_stale || c.first_gather.empty() || c.master.size() != a || !has_room(master) || !has_room(slave)) {
    c.gather_stale = true;
    return;
  }
  c.master.push_back(master);
  c.place.resize(c.place.size() + 2, -1);
  for (const std::int32_t e : {master, slave}) {
    if (e == w.elements.base) continue;
    put(c, static_cast<std::size_t>(c.last_gather[static_cast<std::size_t>(e)]++), 2 * slot + (e == master ? 0 : 1));
    w.travel.activate(w.elements, e);
  }
  if (!w.multirate.on()) return;
  c.slow.push_back(is_slow(w, a) ? 1 : 0);
  note_pace(c, a);
}

}  // namespace voussoir::solver
