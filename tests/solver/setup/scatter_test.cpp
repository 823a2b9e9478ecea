// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "solver/setup/setup.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

TEST_CASE("scatter: the factor of a joint scales its tension, cohesion and compression, on both of its sides, and nothing else") {
  cases::Case c = small_wall(3, 4);
  const cases::Model even = cases::build_model(c);
  c.scatter = {11, 0.3, cases::Distribution::lognormal, {}};
  const cases::Model uneven = cases::build_model(c);
  solver::Options pairs;
  pairs.merge_sides = false;  // each joint of two bricks has two sides
  const auto a = solver::build_world(c, even, pairs), b = solver::build_world(c, uneven, pairs);
  std::vector<int> sides(uneven.assembly.joints.size(), 0);
  for (std::size_t id = 0; id < b->sides.joint.size(); ++id) {
    if (b->sides.joint[id] < 0) continue;
    const auto joint = static_cast<std::size_t>(b->sides.joint[id]);
    const double f = uneven.joint_strength[joint];
    const kernels::Side p = a->sides.side(static_cast<std::int64_t>(id)), q = b->sides.side(static_cast<std::int64_t>(id));
    ++sides[joint];
    CHECK(q.strength.tension == f * p.strength.tension);
    CHECK(q.strength.cohesion == f * p.strength.cohesion);
    CHECK(q.strength.compression == f * p.strength.compression);
    CHECK(q.strength.tan_phi == p.strength.tan_phi);
    CHECK(q.strength.cap == p.strength.cap);
    CHECK(q.k.kn == doctest::Approx(p.k.kn).epsilon(1e-11));  // sides that are alike share the digits of one of them
    CHECK(q.k.ks == doctest::Approx(p.k.ks).epsilon(1e-11));
  }
  for (std::size_t j = 0; j < sides.size(); ++j) CHECK(sides[j] == (uneven.assembly.joints[j].element_b == geometry::kBase ? 1 : 2));
}
