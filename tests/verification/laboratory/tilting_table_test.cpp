// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/slow_loading/assessment.h"

// V21: a dry front wall with two returns on a tilting table, in three dimensions: it overturns with a wedge of its returns. Against the
// program's own limit analysis of the same stones with Coulomb's slip, which takes minutes: `voussoir limit
// cases/verification/tilting_table.toml --direction -y --facets 16` gives 0.31079 with facets in the cone, and the same round it.
namespace voussoir::testing {

TEST_CASE("V21: a dry front wall with returns on a tilting table" * doctest::skip()) {
  const io::Capacity got = assess(load("tilting_table").value);
  expect_near("V21 tilting table, tangent of the angle at which the wall falls, limit analysis with Coulomb's slip", got.multiplier_at_rest,
              0.31079, 2e-2);
  expect_below("V21 tilting table, over that of limit analysis with associated flow", got.multiplier_at_rest / 0.31408, 1.0);
  expect_below("V21 tilting table, share of the work that went into motion", std::abs(got.motion_share), 2e-2);
}

}  // namespace voussoir::testing
