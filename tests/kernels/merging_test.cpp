// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

kernels::PairWrench wrench_of(SideUnderTest u, const TwoBodies& b) {
  std::vector<kernels::SegmentEvent> events(u.s.size());
  kernels::EventSink sink{events.data(), 0};
  const kernels::SideFrame f = u.frame(b);
  const kernels::SegmentTotals r = kernels::advance_segments(u.side, 0, f, u.points(), u.segments(), 5e-5, 0.0, {}, sink);
  kernels::PairWrench w;
  kernels::to_wrench(f, r.total, w.force, w.torque_a, w.torque_b);
  return w;
}

/// The same joint mastered by the other face: tangents swapped, so that their product points out of it.
SideUnderTest seen_from_behind(SideUnderTest u) {
  std::swap(u.side.ca, u.side.cb);
  std::swap(u.side.es, u.side.et);
  std::swap(u.s, u.t);
  std::swap(u.side.master, u.side.slave);
  return u;
}

struct Difference {
  double force, torque_a, torque_b;
};

/// Merged spring against the literal pair of Eq. 11, for a relative turn and opening of size `turn`.
Difference difference(double turn, const Noise& like) {
  SideUnderTest merged(4, 4, 0.5), one(4, 4, 0.0);
  for (SideUnderTest* u : {&merged, &one}) u->side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
  const SideUnderTest other = seen_from_behind(one);
  Noise noise = like;
  TwoBodies b;
  const Vec3 common = noise.vector(0.1);
  b.place(0, {}, common);
  b.place(1, kernels::load_pose(b.pose.data(), 0).d * (merged.side.ca - merged.side.cb) + noise.vector(0.05 * turn),
          common + noise.vector(turn));
  const kernels::PairWrench m = wrench_of(merged, b), p = wrench_of(one, b), q = wrench_of(other, b);
  return {distance(m.force, p.force - q.force), distance(m.torque_a, p.torque_a + q.torque_b),
          distance(m.torque_b, p.torque_b + q.torque_a)};
}

}  // namespace

TEST_CASE("one merged spring differs from the literal pair of Eq. 11 by the square of the relative rotation") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Noise like(seed);
    const Difference d = difference(2e-3, like), half = difference(1e-3, like);
    CHECK(d.force > 0.0);
    // Four times smaller (or better) when the rotation is halved.
    CHECK(half.force < 0.26 * d.force);
    CHECK(half.torque_a < 0.26 * d.torque_a);
    CHECK(half.torque_b < 0.26 * d.torque_b);
  }
}
