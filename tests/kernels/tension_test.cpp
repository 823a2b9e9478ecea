// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/laws/tension.h"

#include <doctest/doctest.h>

#include <functional>

#include "kernels/chunk_law.h"
#include "kernels/laws/segment_law.h"
#include "kernels/laws/softening.h"
#include "tests/kernels/side_fixture.h"

// Every place that kernels/laws/tension.h lists is asked how far a bond can be pulled.

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr kernels::Stiffness kSpring{1.1e9, 4.1e8, 4.0e5, 2.4e5};
constexpr kernels::Strength kBond{1.27e5, 1e9, 0.6, 1e12, 9.0, 0.55};  // no other limit is near
constexpr kernels::Softening kSoft{.opening = 10.0, .slip = 1e-3};

/// A side that looks along x, its faces apart by `opening` [m]: its points, its bodies.
struct Pulled {
  SideUnderTest u{3, 2, 0.5};
  TwoBodies b;
  explicit Pulled(double opening) {
    u.side.k = kSpring, u.side.strength = kBond;
    u.side.ca = {0.05, 0.0, 0.0}, u.side.cb = {-0.05, 0.0, 0.0};  // so that no round-off comes to the opening
    b.place(0, {}, {});
    b.place(1, {opening, 0.0, 0.0}, {});
  }
};

bool literally(double opening) {
  kernels::SegmentState q;
  return kernels::advance_segment(q, {opening, 0.0, 0.0}, {}, 5e-5, kSpring, kBond, {}).broke == kernels::Mode::none;
}

bool soft(double opening) {
  kernels::SegmentState q;
  double wear = 0.0;
  const kernels::SegmentStep s = kernels::advance_soft_segment(q, wear, {opening, 0.0, 0.0}, {}, 5e-5, kSpring, kBond, kSoft, {});
  return s.reached == kernels::Mode::none && wear == 0.0;
}

bool by_chunks(double opening) {
  SideUnderTest u(3, 2, 0.5);
  const kernels::Lanes none{};
  const kernels::Law law{.d = {kernels::lanes(opening), none, none},
                         .ds = {},
                         .dt = {},
                         .v = {},
                         .vs = {},
                         .vt = {},
                         .k = kSpring,
                         .strength = kBond,
                         .factor = 1.0,
                         .step = 5e-5,
                         .o = {}};
  kernels::Totals sum;
  return kernels::advance_chunk(law, u.points(), u.segments(), 0, sum);
}

bool by_the_bound(double opening) {
  Pulled p(opening);
  alignas(64) double wrench[3 * kernels::kWrenchStride] = {}, dashpot[3 * kernels::kDashpotStride] = {};
  const kernels::SideBlock block = p.u.block(kLane);
  const std::uint8_t live = 1U << kLane;
  constexpr std::int32_t kThis[] = {0};
  unsigned lanes = 0;
  return kernels::advance_whole({&block, &live, kThis, 0, {}}, {p.b.pose.data(), p.b.twist.data(), wrench, dashpot, {}}, lanes) == 1;
}

/// \param o  not those under which the bound comes first
bool by_the_certificate(double opening) {
  Pulled p(opening);
  std::vector<kernels::SegmentEvent> events;
  const kernels::FailureOptions o{.in_tension = kernels::ShearInTension::coulomb};
  return !advance(kernels::advance_sides, p.u, p.b, 5e-5, 0.0, o, events, kernels::SideState::whole).looked_at;
}

/// Made steady at rest, then pulled. \param made_at  m, the opening at which it was made so
bool as_steady(double opening, double made_at) {
  Pulled p(opening);
  SideStep look;
  look.result.u.d.n = made_at;
  if (!make_steady(p.u, look, 1.0, {})) return false;
  std::vector<kernels::SegmentEvent> events;
  return !advance(kernels::advance_sides, p.u, p.b, 5e-5, 0.0, {}, events, kernels::SideState::steady).looked_at;
}

/// m, the largest opening that a place lets pass.
double furthest(const std::function<bool(double)>& passes) {
  double low = 0.0, high = 2.0 * kBond.tension / kSpring.kn;
  REQUIRE(passes(low));
  REQUIRE_FALSE(passes(high));
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    (passes(middle) ? low : high) = middle;
  return low;
}

}  // namespace

TEST_CASE("tension: what decides that a bond fails decides it at the same opening, to the bit") {
  const double limit = furthest(literally);
  CHECK(limit == doctest::Approx(kBond.tension / kSpring.kn).epsilon(1e-15));
  CHECK(furthest(soft) == limit);
  CHECK(furthest(by_chunks) == limit);
}

TEST_CASE("tension: what proves that no bond fails lets none pass that does, and keeps near the limit") {
  const double limit = furthest(literally);
  const struct {
    const char* name;
    std::function<bool(double)> passes;
    double distance;  // of the limit
  } proofs[] = {{"bound over a whole side", by_the_bound, 2e-4},
                {"certificate of a whole side", by_the_certificate, 1e-8},
                {"a side is made steady", [](double x) { return as_steady(x, x); }, 1e-8},
                {"a side stays steady", [](double x) { return as_steady(x, 0.0); }, 1e-8}};
  for (const auto& proof : proofs) {
    CAPTURE(proof.name);
    const double furthest_proved = furthest(proof.passes);
    CHECK(furthest_proved < limit);
    CHECK(furthest_proved > limit * (1.0 - proof.distance));
  }
}
