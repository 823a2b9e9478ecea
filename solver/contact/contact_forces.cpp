// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/contact_forces.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "geometry/nth.h"
#include "kernels/prefetch.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kLeastRun = 64, kMostRun = 1024;           // patches that a thread takes at a time
constexpr std::size_t kPrefetchPoints = 3, kPrefetchPatches = 6;  // patches, how early their memory is prefetched
constexpr std::int32_t kPrefetchElements = 8;

DueNumbers patches_due(const World& w, int due) { return {w.multirate, w.contacts.patches, due, w.contacts.active.size()}; }

/// True if the patch pushes nothing and nothing can have come near its points since they were looked at. So it is with most, and this
/// reads lists alone: the patches themselves lie all over memory.
bool is_quiet(const World& w, std::size_t a) {
  const Contacts& c = w.contacts;
  if (w.options.reference_kernels) return false;
  const double travel = w.travel.bound(c.master[a]);
  const auto quiet = [&](const kernels::Candidate& k) { return kernels::quiet(k, travel, w.travel.bound(k.element)); };
  return std::all_of(c.candidate.begin() + c.first_slot[a], c.candidate.begin() + c.first_slot[a + 1], quiet);
}

const FreePatch& patch_at(const World& w, std::size_t a) { return nth(w.patches.patch, w.contacts.active[a]); }

int level_of(const Contacts& c, std::size_t a) { return c.level.empty() ? 0 : c.level[a]; }

void prefetch_body(const World& w, int level, std::int32_t element) {
  const Elements& e = w.elements;
  const auto i = static_cast<std::size_t>(element);
  kernels::prefetch(&e.pose[i * kernels::kPoseStride], kernels::kPoseStride * sizeof(double));
  kernels::prefetch(w.twist_rows(level) + i * kernels::kTwistStride, kernels::kTwistStride * sizeof(double));
  kernels::prefetch(&e.body[i], sizeof e.body[i]);
}

void prefetch_patch(const World& w, std::size_t a) {
  kernels::prefetch(&patch_at(w, a), sizeof(FreePatch));
  prefetch_body(w, level_of(w.contacts, a), w.contacts.master[a]);
}

/// Once the patch is there, asks for its points that touch and for whom they touch.
void prefetch_points(const World& w, std::size_t a) {
  const Contacts& c = w.contacts;
  const Patches& p = w.patches;
  const FreePatch& patch = patch_at(w, a);
  kernels::prefetch(&nth(w.faces, patch.face), sizeof(kernels::Face));
  for (auto slot = static_cast<std::size_t>(c.first_slot[a]); slot < static_cast<std::size_t>(c.first_slot[a + 1]); ++slot) {
    const kernels::Candidate& k = c.candidate[slot];
    if (k.first >= k.last) continue;
    kernels::prefetch(&c.wrench[slot], sizeof c.wrench[slot]);
    prefetch_body(w, level_of(c, a), k.element);
    if (k.face >= 0) kernels::prefetch(&nth(w.faces, k.face), sizeof(kernels::Face));
    const auto first = static_cast<std::size_t>(patch.first_point + k.first), points = static_cast<std::size_t>(k.last - k.first);
    kernels::prefetch(&p.partner[first], points * sizeof p.partner[0]);
    kernels::prefetch(&p.face[first], points * sizeof p.face[0]);
    kernels::prefetch(&p.springs[first / kernels::kWidth], points / kernels::kWidth * sizeof p.springs[0]);
  }
}

/// Whether a slot pushes has changed: tells those that gather it. Seldom, so threads do not take lines of flags from each other.
void note_push(Contacts& c, std::size_t slot) {
  for (const std::int32_t place : {c.place[2 * slot], c.place[2 * slot + 1]}) {
    if (place >= 0) nth(c.gather_on, place) = c.on[slot];
  }
}

void advance_one(World& w, std::size_t a, const PatchStep& step, const kernels::Face* faces, ContactRoom& scratch) {
  Contacts& c = w.contacts;
  Patches& p = w.patches;
  const auto i = static_cast<std::size_t>(c.active[a]);
  FreePatch& patch = p.patch[i];
  const auto first = static_cast<std::size_t>(c.first_slot[a]), count = static_cast<std::size_t>(c.first_slot[a + 1]) - first;
  const auto advance = w.options.reference_kernels ? kernels::advance_patch_reference : kernels::advance_patch;
  const std::span on(c.on.data() + first, count);
  scratch.on.assign(on.begin(), on.end());
  const kernels::PatchResult r =
      advance(patch, w.points.view(patch.set), p.points(static_cast<std::int64_t>(i)), patch.touching, {c.candidate.data() + first, count},
              step.bodies, faces, step.options, scratch.view(), c.wrench.data() + first, on.data());
  for (std::size_t k = 0; k < count; ++k) {
    if (on[k] != scratch.on[k]) note_push(c, first + k);
  }
  patch.touching = r.touching;
  patch.stored = r.stored;
  patch.friction += r.friction;
  patch.impact += r.impact;
  patch.fracture += r.fracture;
}

/// 1 in each byte that is below that number, else 0: both are at most 127.
std::uint64_t bytes_below(std::uint64_t bytes, int number) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  return (~(bytes + kOnes * static_cast<std::uint64_t>(0x80 - number)) >> 7) & kOnes;
}

/// Calls `use(place among `gather`, slot, is_slave)` for the slots of an element that push and whose level is due, in their order. (Flags
/// are 0 or 1; the first is the lowest byte.)
template <class Use>
void each_push(const Contacts& c, int due, std::size_t element, Use use) {
  constexpr std::int64_t kFlags = sizeof(std::uint64_t);
  const std::int64_t last = c.last_gather[element];
  for (std::int64_t g = c.first_gather[element]; g < last; g += kFlags) {
    std::uint64_t flags;
    std::memcpy(&flags, &nth(c.gather_on, g), sizeof flags);
    if (!c.gather_level.empty()) {
      std::uint64_t levels;
      std::memcpy(&levels, &nth(c.gather_level, g), sizeof levels);
      flags &= bytes_below(levels, due);
    }
    if (last - g < kFlags) flags &= (std::uint64_t{1} << 8 * (last - g)) - 1;
    for (; flags != 0; flags &= flags - 1) {
      const auto place = static_cast<std::size_t>(g + std::countr_zero(flags) / 8);
      const std::int32_t code = c.gather[place];
      use(place, static_cast<std::size_t>(code / 2), code % 2 != 0);
    }
  }
}

}  // namespace

void ContactRoom::fit(std::int32_t points, std::int32_t faces) {
  const auto n = static_cast<std::size_t>(points);
  depth.resize(n), candidate.resize(n), face.resize(n);
  planes.resize(static_cast<std::size_t>(faces));
}

void ContactRuns::begin(const World& w, int due) {
  const std::int64_t patches = patches_due(w, due).size();
  ends_.assign(1, 0);
  while (ends_.back() < patches) {
    const std::int64_t left = patches - ends_.back();
    ends_.push_back(ends_.back() + std::min(left, std::clamp(left / (2 * w.team.size()), kLeastRun, kMostRun)));
  }
  tickets_.begin(static_cast<std::int64_t>(ends_.size()) - 1, 1);
}

void advance_contacts(World& w, int due, ContactRuns& runs, ContactRoom& room) {
  const DueNumbers patches = patches_due(w, due);
  if (patches.size() == 0) return;
  room.steps.clear();
  for (int level = 0; level < due; ++level) room.steps.push_back({w.bodies(level), w.contact_of(level)});
  const kernels::Face* faces = w.faces.data();
  room.fit(w.points.largest, w.most_faces);
  runs.take([&](std::int64_t first, std::int64_t last) {
    std::size_t near[kMostRun];
    std::size_t count = 0;
    for (std::int64_t a = first; a < last; ++a) {
      const std::size_t i = patches[a];
      if (is_quiet(w, i)) continue;
      if (count < kPrefetchPatches) prefetch_patch(w, i);
      near[count++] = i;
    }
    for (std::size_t k = 0; k < std::min(count, kPrefetchPoints); ++k) prefetch_points(w, near[k]);
    for (std::size_t k = 0; k < count; ++k) {
      if (k + kPrefetchPatches < count) prefetch_patch(w, near[k + kPrefetchPatches]);
      if (k + kPrefetchPoints < count) prefetch_points(w, near[k + kPrefetchPoints]);
      advance_one(w, near[k], nth(room.steps, level_of(w.contacts, near[k])), faces, room);
    }
  });
}

DueNumbers gatherers(const World& w, int due) {
  return {w.multirate, w.contacts.gatherers, due, static_cast<std::size_t>(w.elements.count)};
}

void gather_contacts(World& w, int due, std::int64_t number) {
  const Contacts& c = w.contacts;
  const DueNumbers elements = gatherers(w, due);
  if (number + kPrefetchElements < elements.size()) {
    each_push(c, due, elements[number + kPrefetchElements],
              [&](std::size_t, std::size_t slot, bool) { kernels::prefetch(&c.wrench[slot], sizeof c.wrench[slot]); });
  }
  const auto element = static_cast<std::int32_t>(elements[number]);
  each_push(c, due, static_cast<std::size_t>(element), [&](std::size_t place, std::size_t slot, bool is_slave) {
    const kernels::PairWrench& x = c.wrench[slot];
    const kernels::Rows rows = w.rows(c.gather_level.empty() ? 0 : c.gather_level[place]);
    kernels::note_push(rows.wrench, element, x.force);
    if (!is_slave) {
      kernels::add_wrench(rows.wrench, element, x.force, x.torque_a);
      kernels::add_dashpot(rows.wrench, rows.dashpot, element, x.dash_force, x.dash_torque_a);
    } else {
      kernels::add_wrench(rows.wrench, element, -x.force, x.torque_b);
      kernels::add_dashpot(rows.wrench, rows.dashpot, element, -x.dash_force, x.dash_torque_b);
    }
  });
}

}  // namespace voussoir::solver
