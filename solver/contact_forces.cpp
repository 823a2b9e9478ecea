// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact_forces.h"

#include <omp.h>

#include <algorithm>

namespace voussoir::solver {

namespace {

constexpr std::int64_t kRun = 16;  // patches that a thread takes at a time

/// True if the patch pushes nothing and nothing can have come near its points since they were looked at. So it is with most, and this
/// reads lists alone: the patches themselves lie all over memory.
bool is_quiet(const World& w, std::size_t a) {
  const Contacts& c = w.contacts;
  if (w.options.reference_kernels) return false;
  const double path = c.path[static_cast<std::size_t>(c.master[a])];
  const auto quiet = [&](const kernels::Candidate& k) { return kernels::quiet(k, path, c.path[static_cast<std::size_t>(k.element)]); };
  return std::all_of(c.candidate.begin() + c.first_slot[a], c.candidate.begin() + c.first_slot[a + 1], quiet);
}

/// Asks for a patch and its points before they are needed.
void fetch(const World& w, std::size_t a) {
  const auto i = static_cast<std::size_t>(w.contacts.active[a]);
  const char* patch = reinterpret_cast<const char*>(&w.patches.patch[i]);
  for (std::size_t line = 0; line < sizeof(kernels::Patch); line += 64) __builtin_prefetch(patch + line);
  const auto at = static_cast<std::size_t>(w.patches.first_point[i]);
  __builtin_prefetch(&w.patches.partner[at]);
  __builtin_prefetch(&w.patches.face[at]);
  for (const Array<double>* column : {&w.patches.slip_x, &w.patches.slip_y, &w.patches.slip_z, &w.patches.closure}) {
    __builtin_prefetch(column->data() + at, 1);
    __builtin_prefetch(column->data() + at + 8, 1);
  }
}

void advance_one(World& w, std::size_t a, const kernels::Bodies& bodies, const kernels::Face* faces, ContactRoom& scratch) {
  Contacts& c = w.contacts;
  Patches& p = w.patches;
  const auto i = static_cast<std::size_t>(c.active[a]);
  const auto first = static_cast<std::size_t>(c.first_slot[a]), count = static_cast<std::size_t>(c.first_slot[a + 1]) - first;
  const auto advance = w.options.reference_kernels ? kernels::advance_patch_reference : kernels::advance_patch;
  const kernels::PatchResult r =
      advance(p.patch[i], w.points.view(p.set[i]), p.points(static_cast<std::int64_t>(i)), p.touching[i],
              {c.candidate.data() + first, count}, bodies, faces, w.contact, scratch.view(), c.wrench.data() + first, c.on.data() + first);
  p.touching[i] = r.touching;
  p.stored[i] = r.stored;
  p.friction[i] += r.friction;
  p.impact[i] += r.impact;
}

}  // namespace

void ContactRoom::fit(std::int32_t points) {
  const auto n = static_cast<std::size_t>(points);
  depth.resize(n), candidate.resize(n), face.resize(n);
}

void advance_contacts(World& w, ContactRoom& room) {
  const kernels::Bodies bodies = w.bodies();
  const kernels::Face* faces = w.faces.data();
  const auto patches = static_cast<std::int64_t>(w.contacts.active.size());
  room.fit(w.points.largest);
#pragma omp for schedule(dynamic) nowait
  for (std::int64_t from = 0; from < patches; from += kRun) {
    std::size_t near[kRun];
    std::size_t count = 0;
    for (std::int64_t a = from; a < std::min(from + kRun, patches); ++a) {
      const auto i = static_cast<std::size_t>(a);
      if (!is_quiet(w, i)) fetch(w, near[count++] = i);
    }
    for (std::size_t k = 0; k < count; ++k) advance_one(w, near[k], bodies, faces, room);
  }
}

void gather_contacts(World& w, std::int64_t first, std::int64_t last) {
  const Contacts& c = w.contacts;
  double* rows = w.elements.wrench.data();
  for (std::int64_t e = first; e < last; ++e) {
    const auto i = static_cast<std::size_t>(e);
    for (std::int64_t g = c.first_gather[i]; g < c.first_gather[i + 1]; ++g) {
      const std::int64_t code = c.gather[static_cast<std::size_t>(g)];
      const auto slot = static_cast<std::size_t>(code / 2);
      if (!c.on[slot]) continue;
      const kernels::PairWrench& x = c.wrench[slot];
      if (code % 2 == 0) {
        kernels::add_wrench(rows, e, x.force, x.torque_a);
        kernels::add_dashpot(rows, e, x.dash_force, x.dash_torque_a);
      } else {
        kernels::add_wrench(rows, e, -x.force, x.torque_b);
        kernels::add_dashpot(rows, e, -x.dash_force, x.dash_torque_b);
      }
    }
  }
}

}  // namespace voussoir::solver
