// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/joint_forces.h"

#include <omp.h>

#include <algorithm>

namespace voussoir::solver {

namespace {

// Beyond these the mean frame of a joint no longer describes two faces that face each other; its segments go on as free patches.
constexpr double kTilt = 0.15;              // rad, relative rotation
constexpr double kSlideShare = 0.5;         // of a segment
constexpr std::int64_t kOpenInterval = 16;  // steps between two looks at sides that are open all over

/// One thread's findings.
struct Findings {
  std::vector<kernels::SegmentEvent> events, room;  // room: for the side in hand
  std::vector<std::int32_t> coming_apart;
};

bool comes_apart(const World& w, std::int64_t id, const kernels::SideFrame& f, const kernels::SideResult& r) {
  const double slide = kSlideShare * w.sides.size[static_cast<std::size_t>(id)];
  if (f.d.s1 * f.d.s1 + f.d.s2 * f.d.s2 > slide * slide) return true;
  if (dot(f.ds, f.ds) + dot(f.dt, f.dt) > kTilt * kTilt) return true;
  return r.held == 0 && r.gap > w.contacts.skin;
}

bool still_whole(const kernels::SegmentsView& q, int n, int held) {
  if (held != n) return false;
  for (int i = 0; i < n; ++i) {
    if (q.bond[i] != kernels::Bond::bonded) return false;
  }
  return true;
}

/// Advances one side segment by segment and adds its forces.
void advance_damaged(World& w, std::int64_t id, double time, Findings& found) {
  Sides& s = w.sides;
  const auto i = static_cast<std::size_t>(id);
  const kernels::Side side = s.side(id);
  double* pose = w.elements.pose.data();
  double* twist = w.elements.twist.data();
  const kernels::SideFrame f = kernels::side_frame(side, kernels::load_pose(pose, side.master), kernels::load_pose(pose, side.slave),
                                                   kernels::load_twist(twist, side.master), kernels::load_twist(twist, side.slave));
  const kernels::PointsView points = w.points.view(s.set[i]);
  const kernels::SegmentsView q = s.segments(id);
  if (found.room.size() < static_cast<std::size_t>(points.n)) found.room.resize(static_cast<std::size_t>(points.n));
  kernels::EventSink sink{found.room.data(), 0};
  const auto advance = w.options.reference_kernels ? kernels::advance_side_reference : kernels::advance_side;
  const kernels::SideResult r = advance(side, static_cast<std::int32_t>(id), f, points, q, w.dt, time, w.failure, sink);
  found.events.insert(found.events.end(), sink.data, sink.data + sink.count);
  s.held[i] = r.held;
  s.friction[i] += r.friction, s.impact[i] += r.impact, s.fracture[i] += r.fracture;
  s.stored_bonds[i] = r.stored_bonds, s.stored_contact[i] = r.stored_contact;
  const bool whole = s.quick[i] == kernels::Quick::whole && sink.count == 0 && still_whole(q, points.n, r.held);
  s.quick[i] = whole ? kernels::Quick::whole : r.held == 0 && !r.touching ? kernels::Quick::open : kernels::Quick::segments;
  if (!whole && comes_apart(w, id, f, r)) found.coming_apart.push_back(static_cast<std::int32_t>(id));
  double* rows = w.elements.wrench.data();
  const kernels::PairWrench& wrench = r.wrench;
  kernels::add_wrench(rows, side.master, wrench.force, wrench.torque_a);
  if (side.slave < w.elements.count) kernels::add_wrench(rows, side.slave, -wrench.force, wrench.torque_b);
  if (!r.touching) return;
  kernels::add_dashpot(rows, side.master, wrench.dash_force, wrench.dash_torque_a);
  if (side.slave < w.elements.count) kernels::add_dashpot(rows, side.slave, -wrench.dash_force, wrench.dash_torque_b);
}

/// `look_closely`: also at open sides, which may have come apart.
void advance_block(World& w, std::int32_t block, double time, bool look_closely, Findings& found) {
  Sides& s = w.sides;
  const std::int64_t first = static_cast<std::int64_t>(block) * kernels::kLanes;
  unsigned done = 0;
  if (!w.options.reference_kernels) {
    done = kernels::quick_sides(s.blocks[static_cast<std::size_t>(block)], s.quick.data() + first, w.elements.pose.data(),
                                w.elements.wrench.data(), w.elements.count, w.failure);
  }
  if (look_closely) {
    for (int l = 0; l < kernels::kLanes; ++l) {
      if (s.quick[static_cast<std::size_t>(first + l)] == kernels::Quick::open) done &= ~(1U << l);
    }
  }
  for (int l = 0; l < kernels::kLanes; ++l) {
    if ((done >> l & 1U) || s.retired[static_cast<std::size_t>(first + l)]) continue;
    advance_damaged(w, first + l, time, found);
  }
}

/// Merges the threads' findings; sorting makes their order a property of the model, not of the scheduling.
void collect(std::vector<Findings>& parts, JointEvents& out) {
  out.events.clear();
  out.coming_apart.clear();
  for (Findings& p : parts) {
    out.events.insert(out.events.end(), p.events.begin(), p.events.end());
    out.coming_apart.insert(out.coming_apart.end(), p.coming_apart.begin(), p.coming_apart.end());
    p.events.clear();
    p.coming_apart.clear();
  }
  std::sort(out.events.begin(), out.events.end(),
            [](const auto& a, const auto& b) { return a.side != b.side ? a.side < b.side : a.point < b.point; });
  std::sort(out.coming_apart.begin(), out.coming_apart.end());
}

}  // namespace

void joint_forces(World& w, double time, std::int64_t step, JointEvents& out) {
  const bool look_closely = step % kOpenInterval == 0;
  std::vector<Findings> parts(static_cast<std::size_t>(omp_get_max_threads()));
#pragma omp parallel
  {
    Findings& mine = parts[static_cast<std::size_t>(omp_get_thread_num())];
    for (std::size_t c = 0; c < w.sides.live.size(); ++c) {
      const std::vector<std::int32_t>& blocks = w.sides.live[c];
      const auto n = static_cast<std::int64_t>(blocks.size());
      if (static_cast<std::int32_t>(c) == w.sides.overflow_colour) {
#pragma omp single
        for (std::int64_t i = 0; i < n; ++i) advance_block(w, blocks[static_cast<std::size_t>(i)], time, look_closely, mine);
      } else {
#pragma omp for schedule(dynamic, 8)
        for (std::int64_t i = 0; i < n; ++i) advance_block(w, blocks[static_cast<std::size_t>(i)], time, look_closely, mine);
      }
    }
  }
  collect(parts, out);
}

StoredEnergy joint_energy(const World& w) {
  StoredEnergy e;
  for (std::int64_t id = 0; id < w.sides.count(); ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (w.sides.retired[i]) continue;
    if (w.sides.quick[i] == kernels::Quick::whole) {
      e.bonds +=
          kernels::whole_side_energy(w.sides.blocks[i / kernels::kLanes], static_cast<int>(id % kernels::kLanes), w.elements.pose.data());
    } else {
      e.bonds += w.sides.stored_bonds[i];
      e.contact += w.sides.stored_contact[i];
    }
  }
  return e;
}

}  // namespace voussoir::solver
