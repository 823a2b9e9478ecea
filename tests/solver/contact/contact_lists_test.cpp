// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/contact/contact_lists.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "solver/contact/overlap_contact.h"
#include "solver/run/run.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

/// Who gathers what, whatever room lies between.
struct Gathered {
  std::vector<std::vector<std::int64_t>> codes;      // by element
  std::vector<std::vector<int>> on;                  // of these
  std::vector<std::int32_t> master;                  // by active patch
  std::vector<std::pair<std::int32_t, bool>> place;  // by code: −1, or how far from where its element begins; whether it is found there
  bool operator==(const Gathered&) const = default;
};

Gathered gathered(const solver::World& w) {
  const solver::Contacts& c = w.contacts;
  Gathered r;
  std::vector<std::int32_t> from(c.gather.size(), -1);
  for (std::size_t e = 0; e + 1 < c.first_gather.size(); ++e) {
    r.codes.emplace_back(), r.on.emplace_back();
    for (auto k = static_cast<std::size_t>(c.first_gather[e]); k < static_cast<std::size_t>(c.last_gather[e]); ++k) {
      r.codes[e].push_back(c.gather[k]), r.on[e].push_back(c.gather_on[k]);
      from[k] = static_cast<std::int32_t>(c.first_gather[e]);
    }
  }
  for (std::size_t code = 0; code < c.place.size(); ++code) {
    const std::int32_t p = c.place[code];
    if (p < 0) {
      r.place.emplace_back(p, true);
    } else {
      const auto k = static_cast<std::size_t>(p);
      r.place.emplace_back(p - from[k], c.gather[k] == static_cast<std::int64_t>(code));
    }
  }
  r.master = c.master;
  return r;
}

}  // namespace

TEST_CASE("gather lists to which slots were added are those that are made anew, with any number of threads") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options o;
  o.threads = 3;
  solver::Simulation sim(c, m, g, o);
  solver::World& w = sim.world();
  int added = 0, anew = 0;
  for (int i = 0; i < 4000; ++i) {
    sim.step({});
    sim.cracks().clear();
    const bool stale = w.contacts.stale_level < solver::Contacts::kUpToDate;
    if (stale) ++anew;
    if (stale || static_cast<std::int64_t>(w.contacts.active.size()) == w.contacts.searched) continue;
    const Gathered now = gathered(w);
    solver::build_gather(w);
    const Gathered made = gathered(w);
    REQUIRE(now == made);
    for (const auto& [at, found] : made.place) REQUIRE(found);
    for (const auto& codes : made.codes) REQUIRE(std::ranges::is_sorted(codes));
    ++added;
  }
  CHECK(added > 20);
  MESSAGE(added << " times slots were added, " << anew << " times there was no room; " << w.contacts.searches << " searches");
}

TEST_CASE("bodies that overlap by more than is allowed are listed, and none of them is thought to be safe") {
  const cases::Case c = small_wall(4, 8);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Simulation sim(c, m, g, {});
  solver::World& w = sim.world();
  std::size_t listed = 0, proven = 0, close = 0;
  for (int i = 0; i < 6000; ++i) {
    sim.step({});
    sim.cracks().clear();
    if (i % 20 != 0) continue;  // often: how a wall falls depends on the processor, and with it how many pairs come close
    const auto& pairs = w.overlaps.pairs;
    const auto order = [](const auto& a, const auto& b) { return std::pair(a.a, a.b) < std::pair(b.a, b.b); };
    REQUIRE(std::ranges::is_sorted(pairs, order));
    const auto check = [&](std::int32_t a, std::int32_t b) {
      const double spare = solver::allowed_overlap(w, a, b) - solver::overlap_of(w, a, b, -1e300).depth;
      const solver::OverlapPair wanted{a, b};
      const auto at = std::ranges::lower_bound(pairs, wanted, order);
      const bool has = at != pairs.end() && at->a == a && at->b == b;
      INFO("step " << i << ", " << a << " and " << b << ", to spare " << spare << " m");
      if (!has) REQUIRE(spare > 0.0);
      if (has && w.travel.bound(a) + w.travel.bound(b) < at->safe) {
        REQUIRE(spare >= 0.0);
        ++proven;
      }
      if (has) ++listed;
      if (spare < 1e-3) ++close;
    };
    for (std::int32_t a = 0; a < w.elements.count; ++a) {
      for (std::int32_t b = a + 1; b < w.elements.count; ++b) check(a, b);
      check(a, w.elements.base);
    }
  }
  MESSAGE(listed << " listed, " << proven << " of them safe, " << close << " with less than a millimetre to spare");
  CHECK(proven > 1000);
  CHECK(listed > proven);
  CHECK(close > 10);
}
