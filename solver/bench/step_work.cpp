// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/bench/step_work.h"

#include <algorithm>
#include <bit>
#include <set>
#include <vector>

#include "geometry/nth.h"
#include "solver/joints/block_state.h"

namespace voussoir::solver {

namespace {

// Operations, as scripts/count_operations counts them.
constexpr double kWholeAlongAxis = 230.0, kWholeAnyhow = 354.0;  // of a side
constexpr double kDamagedBlock = 4250.0;                         // of a block in which something has happened, steady sides included
constexpr double kSegment = 198.0;                               // of a segment that is looked at, with its share of the side's
constexpr double kPair = 3760.0;                                 // of a patch and an element that push each other, with their points
constexpr double kUpdate = 360.0;                                // of an element

constexpr double kRow = kernels::kPoseStride * sizeof(double);       // bytes, of a pose
constexpr double kTwist = kernels::kTwistStride * sizeof(double);    // of a twist
constexpr double kWrench = kernels::kWrenchStride * sizeof(double);  // of a wrench
constexpr double kTwice = 2.0;                                       // read and written

/// Joints of one kind: what their blocks fetch, things that several share once.
class Fetched {
 public:
  explicit Fetched(const World& w) : elements_(static_cast<std::size_t>(w.elements.rows), false) {}
  void add(const kernels::SideBlock& block, const void* constants) {
    constants_.insert(constants);
    ++blocks_;
    for (int l = 0; l < kernels::kLanes; ++l) {
      for (const std::int32_t e : {block.master[l], block.slave[l]}) nth(elements_, e) = true;
    }
  }
  /// \param constants  bytes of those of a block  \param row  bytes of what is read of an element
  [[nodiscard]] double bytes(double constants, double row) const {
    const auto elements = static_cast<double>(std::ranges::count(elements_, true));
    // Beside the block its number, and what its sides are now.
    return blocks_ * (sizeof(kernels::SideBlock) + sizeof(std::int32_t) + kernels::kLanes * sizeof(kernels::SideState) + 1) +
           static_cast<double>(constants_.size()) * constants + elements * row;
  }

 private:
  double blocks_ = 0.0;
  std::set<const void*> constants_;
  std::vector<bool> elements_;
};

/// Of one side of a block in which something has happened, beside what the block needs.
Work damaged_side(const Sides& s, std::size_t id) {
  Work work;
  if (s.side_state[id] == kernels::SideState::steady) work.bytes += sizeof(kernels::SteadySides) / static_cast<double>(kernels::kLanes);
  if (s.side_state[id] != kernels::SideState::segments) return work;
  const double points = s.parts[id].points.n;
  constexpr double kSprings = sizeof(kernels::SegmentSprings) / static_cast<double>(kernels::kWidth);
  work.operations += points * kSegment;
  work.bytes += sizeof(kernels::SideParts) + points * (sizeof(kernels::Bond) + kTwice * kSprings);
  return work;
}

void add_joints(const World& w, StepWork& work) {
  const Sides& s = w.sides;
  Fetched whole(w), damaged(w);
  for (const std::int32_t number : s.live) {
    const auto b = static_cast<std::size_t>(number);
    const kernels::SideBlock& block = s.blocks[b];
    const int pushing = std::popcount(s.live_lanes[b] & ~states_of(s, b).open);
    (is_whole(s, b) ? work.whole_sides : work.damaged_sides) += pushing;
    if (is_whole(s, b)) {
      work.whole_joints.operations += pushing * (block.axis < 0 ? kWholeAnyhow : kWholeAlongAxis);
      whole.add(block, block.whole);
      continue;
    }
    damaged.add(block, block.constants);
    work.damaged_joints.operations += kDamagedBlock;
    for (unsigned rest = s.live_lanes[b]; rest != 0; rest &= rest - 1) {
      const Work side = damaged_side(s, b * kernels::kLanes + static_cast<std::size_t>(std::countr_zero(rest)));
      work.damaged_joints.operations += side.operations, work.damaged_joints.bytes += side.bytes;
    }
  }
  work.whole_joints.bytes += whole.bytes(sizeof(kernels::WholeConstants), kRow);
  work.damaged_joints.bytes += damaged.bytes(sizeof(kernels::SideConstants), kRow + kTwist);
}

/// All candidates are gone through, as a list; of those that push each other the patch, points, faces, bodies, and the slot.
void add_contacts(const World& w, StepWork& work) {
  const Contacts& c = w.contacts;
  const double slots = static_cast<double>(c.candidate.size()), patches = static_cast<double>(c.active.size());
  if (patches == 0.0) return;
  work.contacts.bytes += patches * (sizeof(std::int64_t) + sizeof(std::int32_t)) + slots * sizeof(kernels::Candidate) +
                         static_cast<double>(w.elements.count) * sizeof(double);
  for (std::size_t a = 0; a < c.active.size(); ++a) {
    bool pushed = false;
    for (auto slot = static_cast<std::size_t>(c.first_slot[a]); slot < static_cast<std::size_t>(c.first_slot[a + 1]); ++slot) {
      if (!c.on[slot]) continue;
      pushed = true;
      const kernels::Candidate& k = c.candidate[slot];
      constexpr double kSprings = sizeof(kernels::PointSprings) / static_cast<double>(kernels::kWidth);
      const double points = k.last - k.first;
      work.contacts.operations += kPair;
      work.contacts.bytes += points * (2 * sizeof(std::int32_t) + kTwice * kSprings) + sizeof(kernels::Face) + sizeof(kernels::PairWrench) +
                             kRow + kTwist + sizeof(kernels::BodyConstants);
      work.assembly.bytes += sizeof(kernels::PairWrench) + 2 * sizeof(std::int64_t);  // by both of its elements, one after the other
    }
    if (pushed) work.contacts.bytes += kTwice * sizeof(FreePatch) + sizeof(kernels::Face) + kRow + kTwist + sizeof(kernels::BodyConstants);
  }
  work.assembly.bytes += slots * 2;  // flags, those of each slot for both
}

void add_assembly(const World& w, StepWork& work) {
  work.assembly.bytes += static_cast<double>(w.elements.count) * kTwice * kWrench;
  double sides = 0.0;
  for (const std::int32_t b : w.sides.live) sides += std::popcount(nth(w.sides.live_lanes, b));
  work.assembly.bytes += sides * 2 * sizeof(std::int32_t);
}

/// kick, drift, advance_travel.
void add_update(const World& w, StepWork& work) {
  constexpr double kState = 16, kConstants = 6;          // numbers read and written; read: masses, inertia along principal axes, damping
  constexpr double kOffDiagonal = 3;                     // read beside, where elements do not lie along these
  constexpr double kWay = kTwice + 2, kBatchTravel = 4;  // bound, safe and radius: of an active element; of a batch
  const auto of_batches = [](const auto& flags, int value) {
    return static_cast<double>(std::ranges::count(flags, value)) * kernels::kBatch;
  };
  const Elements& e = w.elements;
  const auto rows = static_cast<double>(e.rows);
  const double active = of_batches(w.travel.active(), 1);
  const double numbers = rows * (kTwice * kState + kConstants) + kOffDiagonal * of_batches(e.principal, 0) + kWay * active +
                         rows / kernels::kBatch * (kTwice * kernels::kTallies + kBatchTravel);
  work.update.operations = rows * kUpdate;
  work.update.bytes = numbers * sizeof(double) + rows * (kRow + kTwice * kWrench) + active * kTwist;
}

}  // namespace

StepWork step_work(const World& w) {
  StepWork work;
  add_joints(w, work);
  add_contacts(w, work);
  add_assembly(w, work);
  add_update(w, work);
  return work;
}

}  // namespace voussoir::solver
