// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/ties/tie_forces.h"

#include <cmath>

#include "geometry/nth.h"

namespace voussoir::solver {

namespace {

constexpr std::int64_t kWorthThreads = 128;  // ties, or elements with ties, that a thread takes at a time

/// From a body's centroid to the point where a hold acts, as it stands, and the way that this point has gone [m].
struct Held {
  Vec3 arm, displacement;
};
Held held(const World& w, const Ties::Hold& h) {
  if (h.element == w.elements.base) return {h.arm, {}};
  const kernels::Pose pose = kernels::load_pose(w.elements.pose.data(), h.element);
  const Vec3 turned = pose.d * h.arm;
  return {h.arm + turned, pose.u + turned};
}

/// N, on the element that is held: the share of a first end is negative.
Vec3 force_on(const Ties& t, const Ties::Hold& h) { return -h.share * nth(t.pull, h.tie); }

/// Vector from the first end to the second, and by how much it is longer than at the start.
struct Bar {
  Vec3 axis;  // unit
  double elongation = 0.0;
};
Bar bar_of(const World& w, const Ties::Tie& t) {
  Vec3 apart;  // of the ends' displacements
  for (std::int32_t k = t.first_hold; k < t.last_hold; ++k) {
    const Ties::Hold& h = nth(w.ties.hold, k);
    apart += h.share * held(w, h).displacement;
  }
  const Vec3 now = t.axis * t.length + apart;
  const double length = norm(now);
  // (l² − l0²) / (l + l0): the difference of two lengths keeps no digits of a small elongation.
  return {now / length, (2.0 * t.length * dot(t.axis, apart) + dot(apart, apart)) / (length + t.length)};
}

void advance(World& w, std::int64_t i, double share) {
  const auto n = static_cast<std::size_t>(i);
  const Ties::Tie& t = w.ties.tie[n];
  const Bar bar = bar_of(w, t);
  const double jack = share * t.pretension / t.law.stiffness;
  kernels::TieState& s = w.ties.state[n];
  const double last = s.force;
  s = kernels::advance_tie(t.law, s, bar.elongation + jack);
  w.ties.jack_work[n] = 0.5 * (last + s.force) * (jack - w.ties.jack[n]);
  w.ties.jack[n] = jack;
  w.ties.pull[n] = s.force * bar.axis;
}

/// All that ties do to one element.
void add_to_element(World& w, std::size_t i) {
  Vec3 force, torque;
  for (std::int32_t k = w.ties.first_of_element[i]; k < w.ties.first_of_element[i + 1]; ++k) {
    const Ties::Hold& h = nth(w.ties.hold, nth(w.ties.hold_of_element, k));
    const Vec3 f = force_on(w.ties, h);
    force += f;
    torque += cross(held(w, h).arm, f);
  }
  kernels::add_wrench(w.elements.wrench.data(), w.ties.element[i], force, torque);
}

}  // namespace

double apply_ties(World& w, double share) {
  const auto ties = static_cast<std::int64_t>(w.ties.tie.size()), elements = static_cast<std::int64_t>(w.ties.element.size());
  if (ties == 0) return 0.0;
  w.team.share_out(ties, kWorthThreads, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) advance(w, i, share);
  });
  w.team.share_out(elements, kWorthThreads, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) add_to_element(w, static_cast<std::size_t>(i));
  });
  double work = 0.0;
  for (const double j : w.ties.jack_work) work += j;
  return work;
}

HeldForce force_of_hold(const World& w, const Ties::Hold& h) {
  const auto i = static_cast<std::size_t>(h.element);
  return {w.elements.body[i].ref + h.arm + held(w, h).displacement, force_on(w.ties, h)};
}

double stored_energy(const Ties& t) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < t.tie.size(); ++i) sum += kernels::stored_energy(t.tie[i].law, t.state[i]);
  return sum;
}

}  // namespace voussoir::solver
