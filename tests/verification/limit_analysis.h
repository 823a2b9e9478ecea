// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/limit/limit.h"
#include "solver/limit/programme/linear_programme.h"

/// Collapse factors of a case by the program's own limit analysis (solver/limit/limit.h), for the problems that compare with it.
namespace voussoir::testing {

/// Factors of a horizontal body force, over the weight: LimitResult::associated and ::coulomb.
struct CollapseFactors {
  double associated = 0.0, coulomb = 0.0;
};

/// \param friction  angle φ of all contacts [degrees] \param along  horizontal unit vector: where the body force points
inline CollapseFactors collapse_factors(cases::Case c, double friction, Vec3 along) {
  REQUIRE_MESSAGE(solver::has_linear_programmes(), "this build has no Clp (Debian: coinor-libclp-dev)");
  c.contact.friction = friction;
  c.contact.between.clear();
  solver::LimitOptions options;
  options.live.direction = along;
  const solver::LimitResult found = solver::limit_analysis(c, cases::build_model(c), options);
  REQUIRE(found.coulomb_proven());
  return {found.associated.multiplier, found.coulomb.multiplier};
}

}  // namespace voussoir::testing
