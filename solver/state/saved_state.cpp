// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/state/saved_state.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include "solver/contact/contact_forces.h"
#include "solver/contact/contact_lists.h"
#include "solver/contact/near_faces.h"
#include "solver/contact/overlap_contact.h"
#include "solver/run/run.h"
#include "solver/setup/laws/optional_laws.h"
#include "solver/setup/setup.h"
#include "solver/state/hash.h"
#include "solver/world/errors.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

const SavedField& find(const SavedState& from, std::string_view name) {
  const auto it = from.find(name);
  if (it == from.end()) throw StateError("field " + std::string(name) + " is missing");
  return it->second;
}

std::span<const std::int32_t> integers(const SavedState& from, std::string_view name) {
  const SavedField& f = find(from, name);
  if (f.type != FieldType::i32 || f.bytes.size() != f.count * f.columns * sizeof(std::int32_t))
    throw StateError("field " + std::string(name) + " is no list of integers");
  return {reinterpret_cast<const std::int32_t*>(f.bytes.data()), f.bytes.size() / sizeof(std::int32_t)};
}

/// Patches are made again in the order of the state. Those that were never joined keep theirs; a side that has retired leaves a patch to
/// its master and, if it stood for both faces, one to its slave.
void grow_patches(World& w, const SavedState& from) {
  const std::span<const std::int32_t> sides = integers(from, "patch_from_side");
  const SavedField& mastered = find(from, "patch_mastered");
  if (mastered.bytes.size() != sides.size()) throw StateError("field patch_mastered has another number of entries than patch_from_side");
  const Patches never_joined = std::exchange(w.patches, {});
  reserve_patches(w, sides.size(), integers(from, "point_partner").size());
  std::size_t next = 0;
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(w.sides.count()), 0);  // 1: the master's, 2: the slave's
  for (std::size_t p = 0; p < sides.size(); ++p) {
    if (sides[p] == -1 && next < never_joined.patch.size()) {
      append_patch(w, never_joined.patch[next], never_joined.patch[next].set, -1, true);
      ++next;
      continue;
    }
    const auto side = static_cast<std::size_t>(sides[p]);
    const bool mirrored = mastered.bytes[p] == std::byte{0};
    const bool known = sides[p] >= 0 && sides[p] < w.sides.count() && w.sides.joint[side] >= 0;
    if (!known || (mirrored && w.sides.faces[side] != 2) || (seen[side] & (mirrored ? 2U : 1U)) != 0)
      throw StateError("field patch_from_side names side " + std::to_string(sides[p]) + ", which cannot have left this patch");
    seen[side] |= mirrored ? 2U : 1U;
    append_retired_patch(w, sides[p], mirrored);
  }
  if (next < never_joined.patch.size()) throw StateError("field patch_from_side lacks free patches of the model");
  for (std::size_t side = 0; side < seen.size(); ++side) {
    if (seen[side] != 0 && seen[side] != (w.sides.faces[side] == 2 ? 3U : 1U))
      throw StateError("field patch_from_side names side " + std::to_string(side) + " for one of its two faces only");
  }
}

/// Room for the arrays whose size is itself state.
void size_search(World& w, const SavedState& from) {
  Contacts& c = w.contacts;
  const std::uint64_t poses = find(from, "searched_ux").count;
  if (poses != 0 && poses != w.elements.ux.size()) throw StateError("field searched_ux has the elements of another model");
  w.travel.restart(poses);
  c.active.assign(integers(from, "active_patch").size(), 0);
  c.first_slot.assign(find(from, "active_first_slot").count, 0);
  const std::size_t slots = integers(from, "slot_element").size();
  assign_in_shares(c.element, slots, 0, w.team);
  c.stale_level = 0;
  c.room = {};
  w.overlaps.springs.assign(find(from, "overlap_a").count, {});
  w.overlaps.pairs.assign(find(from, "listed_a").count, {});
}

template <class T>
T value_at(const SavedField& f, std::size_t i) {
  T v{};
  std::memcpy(&v, f.bytes.data() + i * sizeof(T), sizeof(T));
  return v;
}

[[noreturn]] void refuse(const Field& f, std::size_t i, const std::string& value, const std::string& allowed) {
  throw StateError("field " + std::string(f.name) + " has " + value + " in entry " + std::to_string(i / f.columns) +
                   "; allowed: " + allowed);
}

void check_values(const Field& f, const SavedField& saved) {
  for (std::size_t i = 0; i < f.count * f.columns; ++i) {
    if (f.type == FieldType::f64) {
      if (!std::isfinite(value_at<double>(saved, i))) refuse(f, i, "no finite number", "finite numbers");
      continue;
    }
    const std::int64_t v = f.type == FieldType::i64   ? value_at<std::int64_t>(saved, i)
                           : f.type == FieldType::i32 ? value_at<std::int32_t>(saved, i)
                                                      : value_at<std::uint8_t>(saved, i);
    if (v < f.low || v > f.high) refuse(f, i, std::to_string(v), std::to_string(f.low) + " to " + std::to_string(f.high));
  }
}

void copy_in(const Field& f, const SavedState& from) {
  const SavedField& saved = find(from, f.name);
  if (saved.type != f.type || saved.count != f.count || saved.columns != f.columns || saved.bytes.size() != f.bytes()) {
    throw StateError("field " + std::string(f.name) + " has " + std::to_string(saved.count) + " entries of " +
                     std::to_string(saved.columns) + "; this model has " + std::to_string(f.count) + " of " + std::to_string(f.columns));
  }
  check_values(f, saved);
  unpack(saved.bytes, f);
}

bool is_face_of(const World& w, std::int32_t face, std::int32_t element) {
  const auto e = static_cast<std::size_t>(element);
  return face >= w.elements.first_face[e] && face < w.elements.first_face[e] + w.elements.face_count[e];
}

/// Each pair once, ascending.
template <class Pair>
void check_pairs(const std::vector<Pair>& pairs, const std::string& field) {
  const auto order = [](const Pair& p) { return std::pair(p.a, p.b); };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].a >= pairs[i].b || (i > 0 && order(pairs[i - 1]) >= order(pairs[i])))
      throw StateError("field " + field + " has entry " + std::to_string(i) + " out of order");
  }
}

/// What one field promises to another.
void check_contacts(World& w) {
  const Contacts& c = w.contacts;
  const bool filled = !c.first_slot.empty();
  if (c.first_slot.size() != (filled ? c.active.size() + 1 : 0) || (!filled && !c.active.empty()))
    throw StateError("field active_first_slot has another number of entries than active_patch asks for");
  const auto slots = static_cast<std::int64_t>(c.element.size());
  if (!std::ranges::is_sorted(c.first_slot) || (filled ? c.first_slot.front() != 0 || c.first_slot.back() != slots : slots != 0))
    throw StateError("field active_first_slot does not part the entries of slot_element");
  const Patches& p = w.patches;
  for (std::size_t i = 0; i < p.partner.size(); ++i) {
    const bool free = p.partner[i] == kernels::kNobody;
    if (p.face[i] != kernels::kNoFace && (free || !is_face_of(w, p.face[i], p.partner[i])))
      throw StateError("field point_face has a face in entry " + std::to_string(i) + " that is none of the partner's");
  }
  check_pairs(w.overlaps.springs, "overlap_a");
  check_pairs(w.overlaps.pairs, "listed_a");
  if (w.travel.is_searched() && w.travel.state().poses[0]->empty())
    throw StateError("field searched_ux is empty though a search is not due");
}

}  // namespace

SavedState save(Simulation& sim, RunState& plan) {
  SavedState state;
  for (const Field& f : fields(sim, plan)) {
    state[f.name] = {f.type, f.count, f.columns, packed(f)};
  }
  return state;
}

void restore(Simulation& sim, RunState& plan, const SavedState& from) {
  World& w = sim.world();
  grow_patches(w, from);
  size_search(w, from);
  for (const Field& f : fields(sim, plan)) copy_in(f, from);
  check_contacts(w);
  w.multirate.cycle = sim.phase() == Phase::shaking ? w.multirate.wanted : 1;
  w.elements.store_velocity_rows();
  list_candidates(w);
  bound_dashpots_by_near_faces(w, nullptr);
  use_restored_overlap_pairs(w);
  list_live_blocks(w);
  sim.restore_masses();
}

std::uint64_t model_hash(const World& w) {
  Hash hash;
  const auto add = [&hash](const auto& column) { hash.add(column.data(), column.size() * sizeof(column[0])); };
  const Elements& e = w.elements;
  for (const auto* column : {&e.mass, &e.inv_mass, &e.ixx, &e.iyy, &e.izz, &e.ixy, &e.ixz, &e.iyz, &e.radius, &e.half_x, &e.half_y,
                             &e.half_z, &w.points.s, &w.points.t, &w.points.area}) {
    add(*column);
  }
  for (const kernels::SideBlock& b : w.sides.blocks) {
    hash.add(b.constants, sizeof *b.constants);
    hash.add(b.master, sizeof b.master), hash.add(b.slave, sizeof b.slave);
  }
  for (const OptionalLaw& law : optional_laws()) add(law.numbers(w));
  for (const kernels::SideParts& p : w.sides.parts) {
    for (const double v : {p.factor, p.cn, p.cs}) hash.add(&v, sizeof v);
  }
  for (std::size_t i = 0; i < e.body.size(); ++i)
    hash.add(&e.body[i].ref, sizeof e.body[i].ref), hash.add(&w.dashpot_bounds.all[i], sizeof(double));
  add(w.sides.joint), add(w.sides.set);
  for (const kernels::Face& f : w.faces) {
    for (const double v : {f.normal.x, f.normal.y, f.normal.z, f.distance, f.compliance_n, f.compliance_s, f.mass}) hash.add(&v, sizeof v);
  }
  for (const Ties::Tie& t : w.ties.tie) {
    for (const double v :
         {t.law.stiffness, t.law.yield, t.law.hardening, t.law.breaking, t.law.compression ? 1.0 : 0.0, t.length, t.pretension})
      hash.add(&v, sizeof v);
  }
  for (const Ties::Hold& h : w.ties.hold) {
    hash.add(&h.element, sizeof h.element);
    for (const double v : {h.share, h.arm.x, h.arm.y, h.arm.z}) hash.add(&v, sizeof v);
  }
  hash.add(&w.dt, sizeof w.dt);
  if (w.multirate.wanted > 1) hash.add(w.multirate.every.data(), w.multirate.every.size() * sizeof w.multirate.every[0]);
  return hash.value();
}

}  // namespace voussoir::solver
