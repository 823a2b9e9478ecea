// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact_forces.h"

#include <omp.h>

namespace voussoir::solver {

namespace {

void advance_one(World& w, std::size_t a, const kernels::Bodies& bodies, const kernels::FaceTable& faces, ContactRoom& scratch) {
  Contacts& c = w.contacts;
  Patches& p = w.patches;
  const auto i = static_cast<std::size_t>(c.active[a]);
  const auto first = static_cast<std::size_t>(c.first_slot[a]), count = static_cast<std::size_t>(c.first_slot[a + 1]) - first;
  const auto advance = w.options.reference_kernels ? kernels::advance_patch_reference : kernels::advance_patch;
  const kernels::PatchResult r = advance(p.patch[i], w.points.view(p.set[i]), p.points(static_cast<std::int64_t>(i)), p.touching[i] > 0,
                                         {c.candidate.data() + first, count}, c.gap.data() + first, bodies, faces, w.contact,
                                         {scratch.depth.data(), scratch.distance.data(), scratch.candidate.data(), scratch.face.data()},
                                         c.wrench.data() + first, c.on.data() + first);
  p.touching[i] = r.touching;
  p.stored[i] = r.stored;
  p.friction[i] += r.friction;
  p.impact[i] += r.impact;
}

}  // namespace

void ContactRoom::fit(std::int32_t points) {
  const auto n = static_cast<std::size_t>(points);
  depth.resize(n), distance.resize(n), candidate.resize(n), face.resize(n);
}

void advance_contacts(World& w, ContactRoom& room) {
  const kernels::Bodies bodies = w.bodies();
  const kernels::FaceTable faces = w.faces.table();
  const auto patches = static_cast<std::int64_t>(w.contacts.active.size());
  room.fit(w.points.largest);
#pragma omp for schedule(dynamic, 16) nowait
  for (std::int64_t a = 0; a < patches; ++a) advance_one(w, static_cast<std::size_t>(a), bodies, faces, room);
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
