// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/laws/tie_law.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace voussoir::kernels;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Through these elongations, each in `steps` equal steps.
TieState pulled(const TieLaw& law, const std::vector<double>& through, int steps = 1) {
  TieState s;
  for (const double to : through) {
    const double from = s.elongation;
    for (int i = 1; i <= steps; ++i) s = advance_tie(law, s, from + (to - from) * i / steps);
  }
  return s;
}

doctest::Approx about(double value) { return doctest::Approx(value).epsilon(1e-12); }

}  // namespace

TEST_SUITE("tie law") {
  const TieLaw steel{.stiffness = 1e6, .yield = 2e3, .hardening = 1e5, .breaking = kNever, .compression = false};

  TEST_CASE("elastic, slack on the way back, taut again where it was") {
    CHECK(pulled(steel, {1e-3}).force == about(1e3));
    CHECK(pulled(steel, {1e-3, -1e-3}).force == 0.0);
    const TieState s = pulled(steel, {1e-3, -1e-3, 5e-4});
    CHECK(s.force == about(500.0));
    CHECK(s.plastic == 0.0);
  }

  TEST_CASE("yields, hardens, unloads along the first slope, is slack at the plastic elongation") {
    // From 2 mm on the force grows by k H / (k + H) a metre.
    const double tangent = 1e6 * 1e5 / 1.1e6, force = 2e3 + 3e-3 * tangent, plastic = 5e-3 - force / 1e6;
    TieState s = pulled(steel, {5e-3});
    CHECK(s.force == about(force));
    CHECK(s.plastic == about(plastic));
    s = advance_tie(steel, s, 4e-3);
    CHECK(s.force == about(force - 1e3));
    s = advance_tie(steel, s, plastic - 1e-3);
    CHECK(s.force == 0.0);
    s = advance_tie(steel, s, 5e-3);
    CHECK(s.force == about(force));
    s = advance_tie(steel, s, 6e-3);
    CHECK(s.force == about(force + 1e-3 * tangent));
  }

  TEST_CASE("a bar bears compression, and hardens whatever the sign") {
    TieLaw bar = steel;
    bar.compression = true;
    CHECK(pulled(bar, {-1e-3}).force == about(-1e3));
    const TieState s = pulled(bar, {5e-3, -5e-3});
    const double after = 2e3 + 1e5 * (5e-3 - (2e3 + 3e-3 * 1e5 / 1.1) / 1e6);  // yield force, hardened
    CHECK(s.force < -after);
    CHECK(s.force == about(-(2e3 + 1e5 * s.worked)));
    CHECK(s.worked > 2.0 * s.plastic);
    const TieState again = advance_tie(bar, s, 5e-3);  // what it yielded to and fro adds up
    CHECK(again.force == about(2e3 + 1e5 * again.worked));
    CHECK(again.worked > s.worked);
  }

  TEST_CASE("breaks for good, and what it stored is released") {
    TieLaw wire = steel;
    wire.yield = kNever, wire.hardening = 0.0, wire.breaking = 4e-3;
    TieState s = pulled(wire, {3.999e-3, 4e-3}, 50);
    CHECK(s.broken == 1);
    CHECK(s.force == 0.0);
    CHECK(s.released == doctest::Approx(0.5 * 1e6 * 16e-6).epsilon(1e-3));
    CHECK(advance_tie(wire, s, 1e-3).force == 0.0);
  }

  TEST_CASE("what is lost is the plastic work, however it is stepped") {
    // Under a bilinear curve: the mean of both yield forces times the plastic elongation.
    const double force = 2e3 + 3e-3 * 1e6 * 1e5 / 1.1e6, plastic = 5e-3 - force / 1e6;
    for (const int steps : {10, 1000}) {
      const TieState s = pulled(steel, {2e-3, 5e-3, plastic}, steps);
      CHECK(s.lost == doctest::Approx(0.5 * (2e3 + force) * plastic).epsilon(1e-9));
      CHECK(stored_energy(steel, s) < 1e-12);
    }
    CHECK(pulled(steel, {2e-3, 0.0}, 100).lost == doctest::Approx(0.0).scale(2.0).epsilon(1e-12));
  }
}
