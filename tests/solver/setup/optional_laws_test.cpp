// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/setup/laws/optional_laws.h"

#include <doctest/doctest.h>
#include <omp.h>

#include <algorithm>
#include <set>
#include <string>

#include "solver/run/run.h"
#include "solver/setup/setup.h"
#include "solver/state/saved_state.h"
#include "tests/solver/small_wall.h"

// What every optional law must do, one after the other.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// A wall whose mortar has one of them.
cases::Case with(const solver::OptionalLaw& law) {
  cases::Case c = small_wall(3, 6);
  c.time.step = 2e-4;
  law.example(c, c.joint_laws["mortar"]);
  return c;
}

/// So many shaken steps. \param stop  goes on in another simulation after half of them
std::uint64_t hash_after(const cases::Case& c, const cases::Model& m, int steps, int threads, bool stop) {
  const cases::GroundMotion g = strong_shaking();
  solver::Options o;
  o.threads = threads;
  solver::Simulation sim(c, m, g, o), other(c, m, g, o);
  for (int i = 0; i < steps / 2; ++i) sim.step({.ledger = i % 10 == 0});
  solver::RunState plan;
  if (stop) solver::restore(other, plan, solver::save(sim, plan));
  solver::Simulation& rest = stop ? other : sim;
  for (int i = steps / 2; i < steps; ++i) rest.step({.ledger = i % 10 == 0});
  return solver::state_hash(rest.world());
}

}  // namespace

TEST_CASE("optional laws: each has a name and a place of its own, without a gap") {
  std::set<std::string> names;
  int place = 0;
  for (const solver::OptionalLaw& law : solver::optional_laws()) {
    CAPTURE(law.name);
    CHECK(law.place == ++place);
    CHECK(names.insert(law.name).second);
  }
  CHECK(names.size() >= 3);
}

TEST_CASE("optional laws: a model without any keeps nothing for them") {
  const cases::Case c = small_wall(2, 2);
  const cases::Model m = cases::build_model(c);
  const auto w = solver::build_world(c, m, {});
  CHECK(w->sides.laws.empty());
  CHECK(w->sides.law_state.empty());
  for (const solver::OptionalLaw& law : solver::optional_laws()) {
    CAPTURE(law.name);
    CHECK(law.words(c, m).empty());
    CHECK(law.numbers(*w).empty());
  }
}

TEST_CASE("optional laws: a model that has one says so in `voussoir check`, in its hash and in its fields") {
  for (const solver::OptionalLaw& wanted : solver::optional_laws()) {
    const cases::Case c = with(wanted);
    const cases::Model m = cases::build_model(c);
    const auto w = solver::build_world(c, m, {});
    REQUIRE(w->sides.laws.size() == w->sides.joint.size());
    for (const solver::OptionalLaw& law : solver::optional_laws()) {
      CAPTURE(wanted.name);
      CAPTURE(law.name);
      const bool same = std::string(law.name) == wanted.name;
      CHECK(law.words(c, m).size() == (same ? 1 : 0));
      CHECK(law.numbers(*w).empty() == !same);
    }
    std::set<std::string> fields;
    for (const solver::Field& f : solver::fields(*w)) fields.insert(f.name);
    for (const solver::LawState& kept : w->sides.law_state) CHECK(fields.contains(kept.name));
  }
}

TEST_CASE("optional laws: with each, a run has the same bits with two threads and across a stop") {
  std::set<std::uint64_t> ends;
  for (const solver::OptionalLaw& law : solver::optional_laws()) {
    CAPTURE(law.name);
    const cases::Case c = with(law);
    const cases::Model m = cases::build_model(c);
    const std::uint64_t straight = hash_after(c, m, 800, 1, false);
    CHECK(hash_after(c, m, 800, 1, true) == straight);
    CHECK(hash_after(c, m, 800, 2, true) == straight);
    ends.insert(straight);
  }
  CHECK(ends.size() == solver::optional_laws().size());
}
