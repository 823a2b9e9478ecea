// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/ties/ties.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

// What ties hold: points, plates, the base, and what is refused.
namespace voussoir {
namespace {

using namespace cases;
using testing::check_refused;

constexpr double kLength = 0.2, kWidth = 0.1, kHeight = 0.1;

/// A wall of two courses of three bricks along x, its front at y = 0, and a tie through its second course.
Case tied_wall() {
  Case c = testing::paper_materials();
  c.base = Base{};
  for (int course = 0; course < 2; ++course) {
    for (int k = 0; k < 3; ++k) {
      BlockSpec b;
      b.name = std::to_string(course) + "_" + std::to_string(k), b.material = "adobe";
      b.box = {{Vec3{k * kLength, 0.0, course * kHeight}, Vec3{(k + 1) * kLength, kWidth, (course + 1) * kHeight}}};
      c.blocks.push_back(b);
    }
  }
  c.ties.push_back({.name = "rod", .from = {0.0, 0.05, 0.15}, .to = {0.6, 0.05, 0.15}, .area = 1e-4, .young = 2e11});
  return c;
}

TieBar bar(const Case& c) { return build_model(c).ties.at(0); }

}  // namespace

TEST_CASE("ties: a point holds the element that it lies in or on, or the base") {
  Case c = tied_wall();
  TieBar t = bar(c);
  REQUIRE(t.ends[0].size() == 1);
  CHECK(t.ends[0][0].element == 3);
  CHECK(t.ends[1][0].element == 5);
  CHECK(t.ends[1][0].share == 1.0);
  CHECK(t.length == doctest::Approx(0.6).epsilon(1e-15));
  CHECK(t.stiffness == doctest::Approx(2e11 * 1e-4 / 0.6).epsilon(1e-15));
  c.ties[0].from = {0.3, 0.05, 0.0};  // on the base, under a brick
  CHECK(bar(c).ends[0][0].element == geometry::kBase);
  c.ties[0].from = {0.2, 0.05, 0.1};  // four bricks meet: the first of them
  CHECK(bar(c).ends[0][0].element == 0);
}

TEST_CASE("ties: a plate presses on the faces that it covers, by their area, at the middle of what it covers") {
  Case c = tied_wall();
  Tie& tie = c.ties[0];
  tie.from = {0.25, 0.0, 0.12}, tie.to = {0.25, 0.1, 0.12}, tie.plate = {{0.2, 0.1}};
  const TieBar t = bar(c);
  for (std::size_t end = 0; end < 2; ++end) {
    CAPTURE(end);
    const auto& holds = t.ends[end];
    REQUIRE(holds.size() == 4);  // x from 0.15 to 0.35 over bricks 0 | 1, z from 0.07 to 0.17 over both courses
    double sum = 0.0;
    for (const TieHold& h : holds) {
      const bool left = h.element % 3 == 0, below = h.element < 3;
      CHECK(h.share == doctest::Approx((left ? 0.25 : 0.75) * (below ? 0.3 : 0.7)).epsilon(1e-12));
      CHECK(h.point.x == doctest::Approx(left ? 0.175 : 0.275).epsilon(1e-12));
      CHECK(h.point.y == doctest::Approx(end == 0 ? 0.0 : 0.1).epsilon(1e-12));
      CHECK(h.point.z == doctest::Approx(below ? 0.085 : 0.135).epsilon(1e-12));
      sum += h.share;
    }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-15));
  }
  CHECK(t.length == doctest::Approx(0.1).epsilon(1e-12));
}

TEST_CASE("ties: a plate on the edge between two bricks presses on the wall's face, not into the joint") {
  Case c = tied_wall();
  Tie& tie = c.ties[0];
  tie.plate = {{0.2, 0.1}};
  tie.to = {0.55, 0.1, 0.15}, tie.from = {0.4, 0.0, 0.15};
  const TieBar t = bar(c);
  for (const TieHold& h : t.ends[0]) CHECK(h.point.y == doctest::Approx(0.0).scale(1.0).epsilon(1e-12));
}

TEST_CASE("ties: a plate that hangs over an edge presses on what is there; a rod from the base needs none there") {
  Case c = tied_wall();
  Tie& tie = c.ties[0];
  tie.from = {0.25, 0.05, 0.2}, tie.to = {0.25, 0.5, 0.0}, tie.plate = {{0.2, 0.15}};
  check_refused(
      tied_wall(),
      [](Case& with) {
        with.ties[0].from = {0.25, 0.05, 0.2}, with.ties[0].to = {0.25, 0.5, 0.0}, with.ties[0].plate = {{0.2, 0.15}};
      },
      "tie[0].from", "lies on no face that looks away");
  tie.to = {0.25, 0.15, 0.0};
  const TieBar t = bar(c);
  CHECK(t.ends[1].size() == 1);
  CHECK(t.ends[1][0].element == geometry::kBase);
  CHECK(t.ends[0].size() == 2);
}

TEST_CASE("ties: law of the whole bar") {
  Case c = tied_wall();
  Tie& tie = c.ties[0];
  tie.yield = 3e8, tie.hardening = 2e9, tie.elongation = 0.05, tie.pretension = 500.0;
  const TieBar t = bar(c);
  CHECK(t.yield == doctest::Approx(3e4).epsilon(1e-15));
  CHECK(t.hardening == doctest::Approx(2e11 * 2e9 / 1.98e11 * 1e-4 / 0.6).epsilon(1e-12));
  CHECK(t.breaking == doctest::Approx(0.03).epsilon(1e-15));
  CHECK(t.pretension == 500.0);
  CHECK(!t.compression);
}

TEST_CASE("ties: what is refused") {
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].from = {0.3, 0.05, 0.25};
      },
      "tie[0].from", "[0.3, 0.05, 0.25] m lies in no element, nor on the base (z = 0 m); the nearest, ");
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].from = {0.3, 0.05, 0.25};
      },
      "tie[0].from", "is 0.05 m away");
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].to = c.ties[0].from + Vec3{0.005, 0, 0};
      },
      "tie[0].to", "is 0.005 m from tie.from; a tie has a length of 0.01 m or more");
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].to = c.ties[0].from + Vec3{0.05, 0, 0};
      },
      "tie[0]", "holds one element alone");
  check_refused(
      tied_wall(), [](Case& c) { c.ties.push_back(c.ties[0]); }, "tie[1].name", "\"rod\" is the name of another tie, too");
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].from.x = 0.1, c.ties[0].plate = {{0.1, 0.1}};
      },
      "tie[0].from", "lies on no face that looks away");
  check_refused(
      tied_wall(),
      [](Case& c) {
        c.ties[0].plate = {{0.5, 0.4}};
      },
      "tie[0].from", "only 10 % of the plate at [0, 0.05, 0.15] m lies on faces");
}

}  // namespace voussoir
