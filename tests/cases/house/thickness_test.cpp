// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "cases/house/house.h"
#include "cases/house/house_thickness.h"
#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;

TEST_CASE("a wall of 0.38 m from bricks 0.25 m wide is two bricks of 0.19 m, and is told") {
  House house = *testing::paper_flat20().house;
  house.openings.clear(), house.roof.kind = RoofKind::none;
  house.brick = {0.5, 0.25, 0.1}, house.bearing_wall = 0.38, house.nonbearing_wall = 0.5;
  const std::vector<AdaptedWall> adapted = adapted_walls(house);
  REQUIRE(adapted.size() == 2);
  CHECK(adapted[0].name == "front wall");
  CHECK(adapted[1].name == "rear wall");
  CHECK(adapted[0].bricks == 2);
  CHECK(adapted[0].width == doctest::Approx(0.19).epsilon(1e-12));
  const std::vector<NamedMaterial> materials{{"adobe", {}}, {"wood", {}}};
  int stretchers = 0, headers = 0;
  for (const Block& b : build_house(house, materials)) {
    if (b.tag != "front wall" || !b.whole) continue;
    const geometry::Box3 box = geometry::bounds(b.shape);
    const double depth = box.high.y - box.low.y;
    CHECK((std::abs(depth - 0.19) < 1e-9 || std::abs(depth - 0.38) < 1e-9));
    ++(depth < 0.3 ? stretchers : headers);
  }
  CHECK(stretchers > 0);
  CHECK(headers > 0);
}

TEST_CASE("bricks are made wider or narrower by a third at most") {
  HousePlan plan;
  plan.brick_width = ticks(0.12);
  for (Tick t = ticks(0.08); t < ticks(1.0); t += ticks(0.001)) {
    const double ratio = metres(t) / (static_cast<double>(widths_through(plan, t)) * 0.12);
    CHECK(ratio > 2.0 / 3.0 - 1e-9);
    CHECK(ratio < 4.0 / 3.0 + 1e-9);
  }
  CHECK(widths_through(plan, ticks(0.36)) == 3);
  CHECK(depth_of_widths(plan, ticks(0.36), 2) == ticks(0.24));
}
