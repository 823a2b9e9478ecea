// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joints/joint_forces.h"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernels/prefetch.h"
#include "solver/joints/block_state.h"
#include "solver/world/twists.h"

namespace voussoir::solver {

namespace {

// Beyond these the mean frame of a joint no longer describes two faces that face each other; its segments go on as free patches. A joint
// that bends but still holds (a lintel's wood yields by a tenth of a radian) stays one: its bonds are cut by nothing but their limits.
constexpr double kTilt = 0.15;               // rad, relative rotation
constexpr double kSlideShare = 0.5;          // of a segment
constexpr std::int32_t kPrefetchBlocks = 2;      // blocks, when their memory is asked for
constexpr std::size_t kPrefetchWhole = 2;       // whole blocks of a out-of-cache model, when their constants are asked for
constexpr std::size_t kAtATime = 4;          // whole blocks, between two requests for elements of the next task
constexpr std::int64_t kOpenInterval = 16;   // steps between two looks at sides that are open all over
constexpr std::int64_t kSteadyInterval = 8;  // steps between two attempts to find a side steady

bool comes_apart(const World& w, std::size_t id, const kernels::DamagedSide& r) {
  const double slide = kSlideShare * w.sides.size[id];
  if (r.slide2 > slide * slide) return true;
  return r.held == 0 && (r.tilt2 > kTilt * kTilt || r.gap > w.contacts.skin);
}

/// A side that has just been looked at, and in which nothing happens, may need no look for a while.
bool found_steady(World& w, std::size_t id, const kernels::DamagedSide& r) {
  if (w.options.reference_kernels || r.held == 0 || r.touching || r.events != 0) return false;
  const std::size_t block = id / kernels::kLanes;
  const double left = kSlideShare * w.sides.size[id] - std::sqrt(r.slide2);
  return kernels::make_steady(w.sides.blocks[block], static_cast<int>(id % kernels::kLanes), w.sides.parts[id], r.u, left, w.failure,
                              w.sides.steady[block]);
}

/// Most looks find nothing lost: then the sum, which lies elsewhere, is not even fetched.
void add_loss(double& sum, double loss) {
  if (loss != 0.0) sum += loss;
}

/// Books what became of one side whose segments were looked at.
void book(World& w, std::size_t id, const kernels::DamagedSide& r, bool look_closely, bool try_steady, JointFindings& found) {
  Sides& s = w.sides;
  // The plain twin looks at every side in every step; what it finds must not come sooner.
  if (s.side_state[id] == kernels::SideState::open && !look_closely && r.gap > 0.0) return;
  s.held[id] = r.held;
  add_loss(s.friction[id], r.friction);
  add_loss(s.impact[id], r.impact);
  add_loss(s.fracture[id], r.fracture);
  // A whole side that failed its certificate, but in which nothing happened, is still whole.
  if (s.side_state[id] == kernels::SideState::whole && r.events == 0) return;
  s.side_state[id] = r.held == 0 && !r.touching ? kernels::SideState::open : kernels::SideState::segments;
  if (comes_apart(w, id, r)) {
    found.coming_apart.push_back(static_cast<std::int32_t>(id));
  } else if (try_steady && found_steady(w, id, r)) {
    s.side_state[id] = kernels::SideState::steady;
  }
}

/// Asks for what the sides of a block take in which something has happened: the rows of their elements, constants, and of those whose
/// segments are looked at where these lie.
void prefetch_block(const Sides& s, const kernels::Rows& rows, std::int32_t number) {
  const auto block = static_cast<std::size_t>(number);
  const kernels::StateBits states = states_of(s, block);
  if (states.whole == s.live_lanes[block]) return;
  const kernels::SideBlock& b = s.blocks[block];
  for (const std::int32_t* elements : {b.master, b.slave}) {
    for (int l = 0; l < kernels::kLanes; ++l) {
      const auto e = static_cast<std::int64_t>(elements[l]);
      kernels::prefetch(rows.pose + e * kernels::kPoseStride, kernels::kPoseStride * sizeof(double));
      kernels::prefetch(rows.wrench + e * kernels::kWrenchStride, kernels::kWrenchStride * sizeof(double));
    }
  }
  kernels::prefetch(b.constants, sizeof *b.constants);
  for (unsigned rest = states.segments; rest != 0; rest &= rest - 1) {
    kernels::prefetch(&s.parts[block * kernels::kLanes + static_cast<std::size_t>(std::countr_zero(rest))], sizeof(kernels::SideParts));
  }
}

/// Then for what has happened in them.
void prefetch_histories(const Sides& s, std::int32_t number) {
  const auto block = static_cast<std::size_t>(number);
  const kernels::StateBits states = states_of(s, block);
  if (states.steady != 0) kernels::prefetch(&s.steady[block], sizeof s.steady[block]);
  for (unsigned rest = states.segments; rest != 0; rest &= rest - 1) {
    const kernels::SideParts& parts = s.parts[block * kernels::kLanes + static_cast<std::size_t>(std::countr_zero(rest))];
    const auto n = static_cast<std::size_t>(parts.points.n);
    kernels::prefetch(parts.segments.bond, n * sizeof(kernels::Bond));
    kernels::prefetch(parts.segments.springs, n * sizeof(kernels::SegmentSprings) / kernels::kWidth);
  }
}

/// Has the twists of all elements of a block.
void have_twists(Elements& e, const kernels::SideBlock& block, JointFindings& found) {
  for (const std::int32_t* ends : {block.master, block.slave}) {
    for (int l = 0; l < kernels::kLanes; ++l) {
      if (is_active(e, ends[l]) || ends[l] == e.base) continue;
      make_twist(e, ends[l]);
      found.looked_at.push_back(ends[l]);
    }
  }
}

/// \param done  lanes of it that have been advanced already, as whole ones
/// \param bound_tried  the others have not been found certain to stay whole
void advance_block(World& w, const kernels::Rows& rows, std::int32_t number, unsigned done, bool bound_tried, kernels::StepClock clock,
                   std::int64_t step, JointFindings& found) {
  const Sides& s = w.sides;
  const auto block = static_cast<std::size_t>(number);
  const std::size_t first = block * kernels::kLanes;
  have_twists(w.elements, s.blocks[block], found);
  kernels::EventSink sink{found.room.data(), 0};
  const bool look_closely = step % kOpenInterval == 0;
  const auto advance = w.options.reference_kernels ? kernels::advance_sides_reference : kernels::advance_sides;
  const unsigned looked_at = advance(s.blocks[block],
                                     {.side_state = s.side_state.data() + first,
                                      .steady = &s.steady[block],
                                      .parts = s.parts.data() + first,
                                      .first = static_cast<std::int64_t>(first),
                                      .live = s.live_lanes[block] & ~done,
                                      .look_closely = look_closely,
                                      .bound_tried = bound_tried},
                                     rows, clock, w.failure, found.sides.data(), sink);
  if (looked_at == 0) return;
  found.events.insert(found.events.end(), sink.data, sink.data + sink.count);
  const bool try_steady = (step + number) % kSteadyInterval == 0;  // not all in one step
  for (unsigned rest = looked_at; rest != 0; rest &= rest - 1) {
    const auto l = static_cast<std::size_t>(std::countr_zero(rest));
    book(w, first + l, found.sides[l], look_closely, try_steady, found);
  }
}

/// Asks for the rows of elements that the next task writes to, a few with each block of this one.
class RowPrefetch {
 public:
  /// \param blocks  of this task, at least 1
  RowPrefetch(const kernels::Rows& rows, std::span<const std::int32_t> elements, std::size_t blocks)
      : rows_(rows), left_(elements), each_((elements.size() + blocks - 1) / blocks) {}
  [[nodiscard]] bool any() const { return each_ > 0; }
  void fetch(std::size_t blocks) {
    const std::span<const std::int32_t> now = left_.first(std::min(each_ * blocks, left_.size()));
    for (const std::int32_t element : now) {
      const auto e = static_cast<std::int64_t>(element);
      kernels::prefetch_to_second_cache(rows_.pose + e * kernels::kPoseStride, kernels::kPoseStride * sizeof(double));
      kernels::prefetch_to_second_cache(rows_.wrench + e * kernels::kWrenchStride, kernels::kWrenchStride * sizeof(double));
    }
    left_ = left_.subspan(now.size());
  }

 private:
  const kernels::Rows& rows_;
  std::span<const std::int32_t> left_;
  std::size_t each_;
};

/// Blocks in which nothing has happened. Those that a bound does not prove to stay so are looked at like any other.
/// \param prefetch  blocks whose constants are asked for meanwhile
void advance_whole_blocks(World& w, const kernels::Rows& rows, std::span<const std::int32_t> numbers, std::span<const std::int32_t> prefetch,
                          kernels::StepClock clock, std::int64_t step, JointFindings& found) {
  kernels::WholeRun run{.blocks = w.sides.blocks.data(), .live_lanes = w.sides.live_lanes.data(), .numbers = numbers, .prefetch = prefetch};
  while (!run.numbers.empty()) {
    unsigned lanes = 0;
    run.numbers = run.numbers.subspan(kernels::advance_whole(run, rows, lanes));
    if (run.numbers.empty()) return;
    advance_block(w, rows, run.numbers.front(), lanes, true, clock, step, found);
    run.numbers = run.numbers.subspan(1), run.prefetch = {};
  }
}

/// Places [first, last) of the list of live blocks. \param next  elements that are needed after them
void advance_blocks(const JointStep& at, std::int32_t first, std::int32_t last, std::span<const std::int32_t> next, JointFindings& found,
                    LapClock& watch) {
  if (first == last) return;
  World& w = at.w;
  const Sides& s = w.sides;
  const kernels::Rows rows = w.rows();
  const kernels::StepClock clock{w.dt, at.time};
  const std::span<const std::int32_t> numbers{s.live.data() + first, static_cast<std::size_t>(last - first)};
  RowPrefetch next_rows(rows, next, numbers.size());
  watch.begin();
  if (!w.options.reference_kernels && kernels::has_short_form(w.failure) &&
      std::all_of(numbers.begin(), numbers.end(), [&](std::int32_t n) { return is_whole(s, static_cast<std::size_t>(n)); })) {
    const std::size_t some = next_rows.any() ? kAtATime : numbers.size();
    for (std::size_t i = 0; i < numbers.size(); i += some) {
      const std::span<const std::int32_t> now = numbers.subspan(i, std::min(some, numbers.size() - i));
      next_rows.fetch(now.size());
      const std::size_t from = next_rows.any() ? std::min(i + kPrefetchWhole, numbers.size()) : numbers.size();
      advance_whole_blocks(w, rows, now, numbers.subspan(from), clock, at.step, found);
    }
    watch.lap(ForcePart::whole_joints);
    return;
  }
  for (std::int32_t i = first; i < last; ++i) {
    next_rows.fetch(1);
    if (i + kPrefetchBlocks < last) prefetch_block(s, rows, s.live[static_cast<std::size_t>(i + kPrefetchBlocks)]);
    if (i + 1 < last) prefetch_histories(s, s.live[static_cast<std::size_t>(i + 1)]);
    const std::int32_t number = s.live[static_cast<std::size_t>(i)];
    const bool whole = is_whole(s, static_cast<std::size_t>(number));
    advance_block(w, rows, number, 0, false, clock, at.step, found);
    watch.lap(whole ? ForcePart::whole_joints : ForcePart::damaged_joints);
  }
}

/// What is to be done with each task.
auto advance_task(const JointStep& at, JointFindings& found, LapClock& clock) {
  return [&](std::size_t task, std::span<const std::int32_t> prefetch) {
    const std::vector<std::int32_t>& first = at.w.sides.live_first;
    advance_blocks(at, first[task], first[task + 1], prefetch, found, clock);
  };
}

}  // namespace

void advance_own_joints(const JointStep& s, JointFindings& found, LapClock& clock) {
  found.room.resize(static_cast<std::size_t>(kernels::kLanes * s.w.points.largest));
  if (s.w.options.gather) {
    constexpr std::int32_t kBlocksAtATime = 8;  // blocks
    const auto n = static_cast<std::int32_t>(s.w.sides.live.size());
#pragma omp for schedule(dynamic) nowait
    for (std::int32_t i = 0; i < n; i += kBlocksAtATime) advance_blocks(s, i, std::min(i + kBlocksAtATime, n), {}, found, clock);
    return;
  }
  s.tasks.run_own(advance_task(s, found, clock));
}

void help_with_joints(const JointStep& s, JointFindings& found, LapClock& clock) {
  if (!s.w.options.gather) s.tasks.help(advance_task(s, found, clock));
}

double assemble_again(World& w, JointTasks& tasks) {
  const Sides& s = w.sides;
  const kernels::Rows rows = w.rows();
  tasks.begin(omp_get_max_threads());
  double time = 0.0;
  int team = 0;
#pragma omp parallel reduction(+ : time, team)
  {
    LapClock clock(true);
    const auto hand_out = [&](std::size_t task, std::span<const std::int32_t> /*next*/) {
      clock.begin();
      for (auto i = static_cast<std::size_t>(s.live_first[task]); i < static_cast<std::size_t>(s.live_first[task + 1]); ++i) {
        const auto block = static_cast<std::size_t>(s.live[i]);
        kernels::assemble_zeros(s.blocks[block], s.live_lanes[block] & ~states_of(s, block).open, rows);
      }
      clock.lap(ForcePart::assembly);
    };
    tasks.run_own(hand_out);
    tasks.help(hand_out);
    time = clock.time(ForcePart::assembly), team = 1;
  }
  return time / team;
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

namespace {

StoredEnergy energy_of(World& w, std::size_t id, double whole) {
  Sides& s = w.sides;
  if (s.retired[id]) return {};
  if (s.side_state[id] == kernels::SideState::whole) return {whole, 0.0};
  if (s.side_state[id] == kernels::SideState::open) return {};
  const kernels::Side side = s.side(static_cast<std::int64_t>(id));
  const double *pose = w.elements.pose.data(), *twist = w.elements.twist.data();
  const kernels::SideFrame f = kernels::side_frame(side, kernels::load_pose(pose, side.master), kernels::load_pose(pose, side.slave),
                                                   kernels::load_twist(twist, side.master), kernels::load_twist(twist, side.slave));
  const kernels::SideParts& parts = s.parts[id];
  const kernels::SideEnergy e = kernels::segment_energy(side, f, parts.points, parts.segments);
  return {e.bonds, e.contact};
}

}  // namespace

StoredEnergy joint_energy(World& w) {
  const auto blocks = static_cast<std::int64_t>(w.sides.blocks.size());
  std::vector<StoredEnergy> by_block(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(static, 16)
  for (std::int64_t b = 0; b < blocks; ++b) {
    double whole[kernels::kLanes];
    const auto block = static_cast<std::size_t>(b);
    kernels::whole_side_energies(w.sides.blocks[block], w.elements.pose.data(), whole);
    for (std::size_t l = 0; l < kernels::kLanes; ++l) {
      const StoredEnergy e = energy_of(w, block * kernels::kLanes + l, whole[l]);
      by_block[block].bonds += e.bonds, by_block[block].contact += e.contact;
    }
  }
  StoredEnergy sum;  // in one fixed order
  for (const StoredEnergy& e : by_block) sum.bonds += e.bonds, sum.contact += e.contact;
  return sum;
}

}  // namespace voussoir::solver
