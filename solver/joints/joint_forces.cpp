// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joints/joint_forces.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "geometry/nth.h"
#include "solver/joints/block_prefetch.h"
#include "solver/joints/block_state.h"
#include "solver/joints/side_outcome.h"
#include "solver/schedule/out_of_cache.h"

namespace voussoir::solver {

namespace {

constexpr std::int32_t kPrefetchBlocks = 2;  // blocks, how early their memory is prefetched
constexpr std::size_t kPrefetchWhole = 2;    // whole blocks of an out-of-cache model, how early their constants are prefetched
constexpr std::size_t kAtATime = 4;          // whole blocks, between two prefetches of elements of the next task
constexpr std::int64_t kOpenInterval = 16;   // steps between two looks at sides that are open all over
constexpr std::int64_t kSteadyInterval = 8;  // steps between two attempts to find a side steady

/// The velocity rows of all elements of a block.
void have_velocity_rows(World& w, const kernels::SideBlock& block, JointFindings& found) {
  for (const std::int32_t* ends : {block.master, block.slave}) {
    for (int l = 0; l < kernels::kLanes; ++l) {
      if (w.travel.is_active(ends[l]) || ends[l] == w.elements.base) continue;
      w.elements.store_velocity_row(ends[l]);
      found.looked_at.push_back(ends[l]);
    }
  }
}

/// What all blocks of one level have in common in a step.
struct BlockStep {
  const JointStep& at;
  kernels::Rows rows;
  kernels::StepClock clock;
  std::int64_t number;  // of those in which blocks of this level are advanced
  JointFindings& found;
};

BlockStep block_step(const JointStep& at, int level, JointFindings& found) {
  return {at, at.w.rows(level), {at.w.step_of(level), at.time}, at.step / at.w.multirate.steps_of(level), found};
}

/// \param whole  lanes that have been advanced already as whole sides; nothing if that has not been tried in this step
void advance_block(const BlockStep& step, std::int32_t number, std::optional<unsigned> whole) {
  World& w = step.at.w;
  const Sides& s = w.sides;
  JointFindings& found = step.found;
  const auto block = static_cast<std::size_t>(number);
  const std::size_t first = block * kernels::kLanes;
  have_velocity_rows(w, s.blocks[block], found);
  kernels::EventSink sink{found.room.data(), 0};
  const SideLook look{.closely = step.number % kOpenInterval == 0,
                      .for_steady = (step.number + number) % kSteadyInterval == 0};  // not all blocks in one step
  const auto advance = w.options.reference_kernels ? kernels::advance_sides_reference : kernels::advance_sides;
  const unsigned looked_at = advance(s.blocks[block],
                                     {.side_state = s.side_state.data() + first,
                                      .steady = &s.steady[block],
                                      .parts = s.parts.data() + first,
                                      .laws = s.laws.empty() ? nullptr : s.laws.data() + first,
                                      .first = static_cast<std::int64_t>(first),
                                      .live = s.live_lanes[block] & ~whole.value_or(0U),
                                      .look_closely = look.closely,
                                      .bound_tried = whole.has_value()},
                                     step.rows, step.clock, w.failure, found.sides.data(), sink);
  if (looked_at == 0) return;
  found.events.insert(found.events.end(), sink.data, sink.data + sink.count);
  for (unsigned rest = looked_at; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    if (record_side(w, first + lane, found.sides[lane], look)) found.coming_apart.push_back(static_cast<std::int32_t>(first + lane));
  }
}

/// Blocks in which nothing has happened. Those that a bound does not prove to stay so are looked at like any other.
/// \param prefetch  blocks whose constants are prefetched meanwhile
void advance_whole_blocks(const BlockStep& step, std::span<const std::int32_t> numbers, std::span<const std::int32_t> prefetch) {
  const Sides& s = step.at.w.sides;
  kernels::WholeRun run{.blocks = s.blocks.data(), .live_lanes = s.live_lanes.data(), .numbers = numbers, .prefetch = prefetch};
  while (!run.numbers.empty()) {
    unsigned lanes = 0;
    run.numbers = run.numbers.subspan(kernels::advance_whole(run, step.rows, lanes));
    if (run.numbers.empty()) return;
    advance_block(step, run.numbers.front(), lanes);
    run.numbers = run.numbers.subspan(1), run.prefetch = {};
  }
}

/// Places [first, last) of the list of live blocks. \param next  elements that are needed after them
void advance_blocks(const JointStep& at, int level, std::int32_t first, std::int32_t last, std::span<const std::int32_t> next,
                    JointFindings& found, LapClock& laps) {
  if (first == last) return;
  World& w = at.w;
  const Sides& s = w.sides;
  const BlockStep step = block_step(at, level, found);
  const std::span<const std::int32_t> numbers{s.live.data() + first, static_cast<std::size_t>(last - first)};
  RowPrefetch next_rows(step.rows, next, numbers.size());
  laps.begin();
  if (!w.options.reference_kernels && kernels::has_short_form(w.failure) &&
      std::all_of(numbers.begin(), numbers.end(), [&](std::int32_t n) { return is_whole(s, static_cast<std::size_t>(n)); })) {
    const std::size_t some = next_rows.any() ? kAtATime : numbers.size();
    for (std::size_t i = 0; i < numbers.size(); i += some) {
      const std::span<const std::int32_t> now = numbers.subspan(i, std::min(some, numbers.size() - i));
      next_rows.fetch(now.size());
      const std::size_t from = next_rows.any() ? std::min(i + kPrefetchWhole, numbers.size()) : numbers.size();
      advance_whole_blocks(step, now, numbers.subspan(from));
    }
    laps.lap(ForcePart::whole_joints);
    return;
  }
  for (std::int32_t i = first; i < last; ++i) {
    next_rows.fetch(1);
    if (i + kPrefetchBlocks < last) prefetch_block(s, step.rows, nth(s.live, i + kPrefetchBlocks));
    if (i + 1 < last) prefetch_histories(s, nth(s.live, i + 1));
    const std::int32_t number = nth(s.live, i);
    const bool whole = is_whole(s, static_cast<std::size_t>(number));
    advance_block(step, number, std::nullopt);
    laps.lap(whole ? ForcePart::whole_joints : ForcePart::damaged_joints);
  }
}

/// What is to be done with each task.
auto advance_task(const JointStep& at, JointFindings& found, LapClock& clock) {
  return [&](std::size_t task, std::span<const std::int32_t> prefetch) {
    const Sides& s = at.w.sides;
    const Multirate& m = at.w.multirate;
    if (!m.on()) return advance_blocks(at, 0, s.live_first[task], s.live_first[task + 1], prefetch, found, clock);
    const std::int32_t* first = &s.live_level[task * m.every.size()];
    for (int level = 0; level < at.levels; ++level) {
      const bool last = level + 1 == m.levels();
      advance_blocks(at, level, first[level], first[level + 1], last ? prefetch : std::span<const std::int32_t>{}, found, clock);
    }
  };
}

}  // namespace

void advance_own_joints(const JointStep& s, int thread, JointFindings& found, LapClock& clock) {
  found.room.resize(static_cast<std::size_t>(kernels::kLanes * s.w.points.largest));
  s.tasks.run_own(thread, advance_task(s, found, clock));
}

void help_with_joints(const JointStep& s, int thread, JointFindings& found, LapClock& clock) {
  s.tasks.help(thread, advance_task(s, found, clock));
}

void collect(std::span<JointFindings*> found, JointEvents& out) {
  out.events.clear();
  out.coming_apart.clear();
  for (JointFindings* p : found) {
    out.events.insert(out.events.end(), p->events.begin(), p->events.end());
    out.coming_apart.insert(out.coming_apart.end(), p->coming_apart.begin(), p->coming_apart.end());
    p->events.clear();
    p->coming_apart.clear();
  }
  std::sort(out.events.begin(), out.events.end(),
            [](const auto& a, const auto& b) { return a.side != b.side ? a.side < b.side : a.point < b.point; });
  std::sort(out.coming_apart.begin(), out.coming_apart.end());
}

}  // namespace voussoir::solver
