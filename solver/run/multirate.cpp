// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/run/multirate.h"

#include <algorithm>
#include <array>
#include <span>

#include "geometry/nth.h"
#include "solver/contact/overlap_contact.h"
#include "solver/setup/setup.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kRowsAtATime = 256;

std::array<double, 6> velocities_of(const Elements& e, std::size_t i) { return {e.vx[i], e.vy[i], e.vz[i], e.wx[i], e.wy[i], e.wz[i]}; }

static_assert(kernels::kTwistStride == 8 && kernels::kWrenchStride == 8 && kernels::kDashpotStride == 8);

/// to += factor × from; from = 0: one row.
void move_row(double* to, double* from, double factor) {
  for (int k = 0; k < kernels::kWrenchStride; ++k) to[k] += factor * from[k], from[k] = 0.0;
}

/// Calls `use(master, slave)`; the slave may be the base.
template <class Use>
void each_live_side(const World& w, Use use) {
  const Sides& s = w.sides;
  for (std::size_t id = 0; id < s.retired.size(); ++id) {
    if (s.retired[id]) continue;
    const kernels::SideBlock& b = s.blocks[id / kernels::kLanes];
    use(b.master[id % kernels::kLanes], b.slave[id % kernels::kLanes]);
  }
}

/// Lowers levels until those of elements that contact can couple before the next search differ by one at most. The candidates of a patch
/// are evaluated together, so they count as coupled to each other. \return  whether any was lowered
bool grade_contacts(const World& w, std::vector<std::uint8_t>& level) {
  const Contacts& c = w.contacts;
  const std::int32_t base = w.elements.base;
  bool lowered = false;
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    std::uint8_t& master = nth(level, nth(w.patches.element, c.active[a]));
    const auto candidates = std::span(c.element).subspan(static_cast<std::size_t>(c.first_slot[a]),
                                                         static_cast<std::size_t>(c.first_slot[a + 1] - c.first_slot[a]));
    int lowest = master;
    for (const std::int32_t e : candidates) lowest = e == base ? lowest : std::min<int>(lowest, nth(level, e));
    const auto lower = [&](std::uint8_t& l) {
      if (l > lowest + 1) l = static_cast<std::uint8_t>(lowest + 1), lowered = true;
    };
    lower(master);
    for (const std::int32_t e : candidates) {
      if (e != base) lower(nth(level, e));
    }
  }
  return lowered;
}

}  // namespace

void start_cycles(World& w) {
  Multirate& m = w.multirate;
  m.cycle = m.wanted;
  if (!m.on()) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(w.elements.rows); ++i) {
    const std::array<double, 6> now = velocities_of(w.elements, i);
    for (Multirate::Rows& r : m.rows) std::ranges::copy(now, r.twist.data() + i * kernels::kTwistStride);
  }
  w.contacts.stale_level = 0;  // patches and pairs have levels from now on
  renew_contact_levels(w);
}

void renew_contact_levels(World& w) {
  Multirate& m = w.multirate;
  std::vector<std::uint8_t> level = m.own;
  Pairs pairs;
  each_live_side(w, [&](std::int32_t a, std::int32_t b) {
    const std::vector<std::uint8_t>& of = m.of_joints;
    for (const std::int32_t e : {a, b}) nth(level, e) = nth(of, e);
    if (b != w.elements.base) pairs.emplace_back(a, b);
  });
  for (const OverlapPair& p : w.overlaps.pairs) {
    if (p.b != w.elements.base) pairs.emplace_back(p.a, p.b);
  }
  do grade(level, pairs);
  while (grade_contacts(w, level));
  m.of_contacts = std::move(level);
  list_overlap_levels(w);
}

void renew_moves(World& w) {
  const Multirate& m = w.multirate;
  std::ranges::fill(w.moved_at, static_cast<std::uint8_t>(m.levels() - 1));
  const auto lower = [&](std::int32_t element, int level) {
    std::uint8_t& at = nth(w.moved_at, element / kernels::kBatch);
    at = std::min(at, static_cast<std::uint8_t>(level));
  };
  const auto lower_both = [&](std::int32_t a, std::int32_t b, int level) { lower(a, level), lower(b, level); };
  // A side that comes apart before the next search is a contact from then on.
  each_live_side(w, [&](std::int32_t a, std::int32_t b) { lower_both(a, b, std::min(m.joint_level(a, b), m.contact_level(a, b))); });
  const Contacts& c = w.contacts;
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    for (std::int64_t slot = c.first_slot[a]; slot < c.first_slot[a + 1]; ++slot) lower_both(c.master[a], nth(c.element, slot), c.level[a]);
  }
  for (const OverlapPair& p : w.overlaps.pairs) lower_both(p.a, p.b, m.contact_level(p.a, p.b));
  // What acts in every step.
  for (const std::int32_t e : w.ties.element) lower(e, 0);
  for (const Support& s : w.supports) lower(s.element, 0);
}

void add_impulses(World& w, std::int64_t step) {
  Multirate& m = w.multirate;
  const int due = m.due(step);
  if (due == 1) return;
  const auto add = [&](std::int64_t i) {
    const double at_once = m.steps_of(w.batch_level(static_cast<std::size_t>(i / kernels::kBatch)));
    for (int level = 1; level < due; ++level) {
      Multirate::Rows& of_level = m.rows[static_cast<std::size_t>(level) - 1];
      const double steps = m.impulse_steps(level, step) / at_once;
      double* wrench = of_level.wrench.data() + i * kernels::kWrenchStride;
      if (wrench[kernels::kDashedColumn] != 0.0) {
        move_row(w.elements.dashpot.data() + i * kernels::kDashpotStride, of_level.dashpot.data() + i * kernels::kDashpotStride, steps);
      }
      move_row(w.elements.wrench.data() + i * kernels::kWrenchStride, wrench, steps);
    }
  };
  w.team.share_out(w.elements.rows, kRowsAtATime, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) add(i);
  });
}

void sum_velocities(World& w, std::int64_t step, std::int64_t first, std::int64_t last) {
  Multirate& m = w.multirate;
  const std::int32_t at_once = m.steps_of(w.batch_level(static_cast<std::size_t>(first / kernels::kBatch)));
  for (std::size_t level = 1; level < m.every.size(); ++level) {
    const std::int32_t every = std::max(m.every[level], at_once);
    const double before = step % every == 0 ? 0.0 : 1.0, scale = (step + at_once) % every == 0 ? static_cast<double>(at_once) / every : 1.0;
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      const std::array<double, 6> now = velocities_of(w.elements, i);
      double* row = m.rows[level - 1].twist.data() + i * kernels::kTwistStride;
      for (std::size_t k = 0; k < now.size(); ++k) row[k] = scale * (before * row[k] + now[k]);
    }
  }
}

}  // namespace voussoir::solver
