// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "cases/case.h"
#include "cases/census.h"
#include "cases/model.h"
#include "geometry/nth.h"
#include "solver/setup/setup.h"
#include "solver/world/first_touch.h"

namespace voussoir::solver {

namespace {

// Rows of springs round the elements that limit the step: with one, a beam in a hundred of perf/multirate_resonance.py grew at k = 2.
constexpr int kRings = 2;
constexpr double kFlies = 20.0;  // m/s, of what has fallen from a height of 20 m

/// By level. With another ratio than two from one level to the next energy would be lost (THEORY.md, section 7, "Why levels are graded").
std::vector<std::int32_t> steps_by_level(std::int32_t cycle) {
  std::vector<std::int32_t> every;
  for (std::int32_t steps = 1; steps <= cycle; steps *= 2) every.push_back(steps);
  return every;
}

/// By row: the highest level whose step Eq. 19 allows the element. \param every  steps by level \param dt  s \param share  of its bound
std::vector<std::uint8_t> own_levels(const World& w, const std::vector<std::int32_t>& every, double dt, double share) {
  std::vector<std::uint8_t> level(static_cast<std::size_t>(w.elements.rows), static_cast<std::uint8_t>(every.size() - 1));
  for (std::size_t e = 0; e < static_cast<std::size_t>(w.elements.count); ++e) {
    if (w.elements.fixed[e]) continue;
    const double bound = share * cases::step_bound(w.model, e).step;
    while (level[e] > 0 && bound < every[level[e]] * dt * (1.0 - 1e-9)) --level[e];
  }
  return level;
}

Pairs joined_pairs(const World& w) {
  Pairs pairs;
  for (const geometry::Joint& j : w.model.assembly.joints) {
    if (j.element_b != geometry::kBase) pairs.emplace_back(j.element_a, j.element_b);
  }
  return pairs;
}

/// The same by sides, once they are there: a run forgets the joints of its model.
Pairs pairs_of_sides(const World& w) {
  Pairs pairs;
  for (std::size_t id = 0; id < w.sides.joint.size(); ++id) {
    const kernels::SideBlock& block = w.sides.blocks[id / kernels::kLanes];
    const std::int32_t slave = block.slave[id % kernels::kLanes];
    if (w.sides.joint[id] >= 0 && slave != w.elements.base) pairs.emplace_back(block.master[id % kernels::kLanes], slave);
  }
  return pairs;
}

/// By row: the lowest own level among an element, its neighbours and theirs; then graded.
std::vector<std::uint8_t> levels_of_joints(const std::vector<std::uint8_t>& own, const Pairs& joined) {
  std::vector<std::uint8_t> level = own;
  for (int ring = 0; ring < kRings; ++ring) {
    const std::vector<std::uint8_t> inside = level;
    for (const auto& [a, b] : joined) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      level[i] = std::min(level[i], inside[j]);
      level[j] = std::min(level[j], inside[i]);
    }
  }
  grade(level, joined);
  return level;
}

const cases::SupportHistory* turning_support(const cases::Model& m) {
  const auto turns = [](const cases::SupportHistory& h) { return !h.rotation.empty(); };
  const auto found = std::ranges::find_if(m.support_motions, turns);
  return found == m.support_motions.end() ? nullptr : &*found;
}

}  // namespace

void grade(std::vector<std::uint8_t>& level, const Pairs& neighbours) {
  for (bool lowered = true; lowered;) {
    lowered = false;
    for (const auto& [a, b] : neighbours) {
      auto &i = nth(level, a), &j = nth(level, b);
      const auto most = static_cast<std::uint8_t>(std::min(i, j) + 1);
      if (std::max(i, j) <= most) continue;
      i = std::min(i, most), j = std::min(j, most);
      lowered = true;
    }
  }
}

std::optional<double> share_evaluated(const World& w, const cases::Case& c, int multirate) {
  cases::Case other = c;
  other.time.multirate = multirate;
  if (other.multirate() != multirate || turning_support(w.model) != nullptr) return std::nullopt;
  const std::vector<std::int32_t> every = steps_by_level(multirate);
  const double dt = choose_step(other, {}, w.bound);
  const std::vector<std::uint8_t> level = levels_of_joints(own_levels(w, every, dt, share_of_bound(c)), pairs_of_sides(w));
  double evaluated = 0.0, moving = 0.0;
  for (std::size_t e = 0; e < static_cast<std::size_t>(w.elements.count); ++e) {
    if (!w.elements.fixed[e]) evaluated += 1.0 / nth(every, level[e]), moving += 1.0;
  }
  return moving == 0.0 ? std::nullopt : std::optional(evaluated / moving * w.dt / dt);
}

double search_margin(const World& w, double skin) { return std::min(0.1 * skin, (w.multirate.wanted - 1) * w.dt * kFlies); }

void set_up_multirate(World& w, const cases::Case& c) {
  Multirate& m = w.multirate;
  m.wanted = c.multirate();
  if (m.wanted == 1) return;
  if (const cases::SupportHistory* h = turning_support(w.model))
    throw cases::InputError("time.multirate", "= " + std::to_string(m.wanted) + " does not go with a support that turns (" +
                                                  h->key.substr(0, h->key.rfind('.')) + "); allowed: 1");
  m.every = steps_by_level(m.wanted);
  if (m.every.back() != m.wanted || m.every.size() > Multirate::kMostLevels)
    throw cases::InputError("time.multirate", "= " + std::to_string(m.wanted) + "; allowed: 1, 2, 4, 8");
  m.own = own_levels(w, m.every, w.dt, share_of_bound(c));
  m.of_joints = levels_of_joints(m.own, joined_pairs(w));
  m.of_contacts = m.of_joints;
  const auto rows = static_cast<std::size_t>(w.elements.rows);
  m.rows.resize(m.every.size() - 1);
  w.moved_at.assign(rows / kernels::kBatch, 0);
  for (Multirate::Rows& r : m.rows) {
    assign_in_shares(r.twist, rows * kernels::kTwistStride, 0.0, w.team);
    assign_in_shares(r.wrench, rows * kernels::kWrenchStride, 0.0, w.team);
    assign_in_shares(r.dashpot, rows * kernels::kDashpotStride, 0.0, w.team);
  }
}

}  // namespace voussoir::solver
