// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/collapse.h"

#include <cmath>

#include "io/collapse_facts.h"
#include "io/frame_reader.h"
#include "results_fixture.h"

namespace voussoir::io {
namespace {

using namespace test;
using solver::FallenMass;

constexpr double kHeight = 4.05;  // of the second cube's centroid in the tests with frames, m

/// The first cube a brick of a wall, the second a beam of the roof, 4 m up and five times as heavy.
cases::Model wall_and_beam() {
  cases::Model m = two_cubes();
  m.materials.push_back({"wood", {9000.0, 1e10, 0.25}});
  m.blocks[0].kind = cases::PartKind::brick;
  m.blocks[1].kind = cases::PartKind::beam;
  m.blocks[1].material = 1;
  m.blocks[1].fixed = false;
  for (Vec3& v : m.blocks[1].shape.vertices) v.z += 4.0;
  m.assembly.elements[1].mass.centroid.z = kHeight;
  for (cases::Block& b : m.blocks) b.house = 0;
  return m;
}

/// A frame in which both cubes stand where they are told.
void put_frame(ResultsWriter& results, double time, Vec3 brick, Vec3 beam) {
  const std::array<float, 8> upright{1, 0, 0, 0, 1, 0, 0, 0};
  const std::array<float, 2> whole{};
  std::array<float, 6> at{};
  std::size_t i = 0;
  for (const double x : {brick.x, brick.y, brick.z, beam.x, beam.y, beam.z}) at[i++] = static_cast<float>(x);
  results.frame({time, at, upright, whole});
}

CollapseFacts facts_of(const TempFolder& folder) {
  const Hdf5File run = Hdf5File::open(folder.file("run.h5"));
  return collapse_facts(run, FrameReader(run), 0.0);
}

TEST_CASE("an element has fallen by half its first height, or by 1 m") {
  CHECK_FALSE(FallenMass::has_fallen(0.5 * 0.4, 0.4));
  CHECK(FallenMass::has_fallen(0.5 * 0.4 + 1e-9, 0.4));
  CHECK_FALSE(FallenMass::has_fallen(1.0, 3.0));
  CHECK(FallenMass::has_fallen(1.0 + 1e-9, 3.0));
}

TEST_CASE("a collapse is the fall of more than half the roof; without a roof, of half of all") {
  using enum cases::PartKind;
  FallenMass house;
  house.add(brick, 900.0, 2.0, 3.0);  // fallen
  house.add(beam, 50.0, 0.0, 3.0);
  house.add(voussoir, 50.0, 2.0, 3.0);  // fallen: half of the roof, no more
  CHECK_FALSE(house.is_collapse());
  CHECK(house.fraction() == doctest::Approx(950.0 / 1000.0));
  house.add(beam, 1.0, 2.0, 3.0);
  CHECK(house.is_collapse());

  FallenMass wall;
  CHECK(wall.fraction() == 0.0);
  wall.add(brick, 10.0, 2.0, 3.0);
  wall.add(column, 10.0, 0.0, 3.0);
  CHECK_FALSE(wall.is_collapse());
  wall.add(brick, 1.0, 2.0, 3.0);
  CHECK(wall.is_collapse());
}

TEST_CASE("the time of collapse is that of the first frame in which the roof has fallen") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), wall_and_beam(), kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, 0.05, 0.05}, {0.15, 0.05, kHeight});
  put_frame(results, 0.1, {0.05, 0.05, 0.01}, {0.15, 0.05, kHeight - 0.99});  // the brick has fallen: a sixth of the mass, no roof
  put_frame(results, 0.2, {0.05, 0.05, 0.01}, {0.15, 0.05, kHeight - 1.01});
  put_frame(results, 0.3, {0.05, 0.05, 0.01}, {0.15, 0.05, 0.05});
  results.finish();
  const CollapseFacts facts = facts_of(folder);
  REQUIRE(facts.time);
  CHECK(*facts.time == 0.2);
  CHECK(facts.reach == 0.0);  // all of it inside
}

TEST_CASE("debris reaches as far as the farthest fallen element is from the footprint") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), wall_and_beam(), kCase, kNames, {}, by_hand());
  // The footprint is 0 to 0.2 m along x and 0 to 0.1 m along y. The beam, five sixths of the mass, lies 3 m and 4 m beyond its corner, the
  // brick 7 m beyond one side.
  put_frame(results, 0.0, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, 0.05});
  results.finish();
  const CollapseFacts facts = facts_of(folder);
  CHECK(facts.reach == doctest::Approx(7.0));
  CHECK(facts.reach_95 == doctest::Approx(7.0));  // 5/6 is less than 95 %
}

TEST_CASE("what stands is no debris, and what flies off alone does not count among 95 % of it") {
  const TempFolder folder;
  cases::Model m = wall_and_beam();
  m.materials[1].value.density = 1800.0 * 20;  // the beam is 20/21 of the mass: more than 95 %
  ResultsWriter results(folder.path(), m, kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, kHeight});
  put_frame(results, 0.1, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, 0.05});
  results.finish();
  const CollapseFacts facts = facts_of(folder);
  CHECK(facts.reach == doctest::Approx(7.0));
  CHECK(facts.reach_95 == doctest::Approx(std::hypot(3.0, 4.0)));

  const TempFolder standing;
  ResultsWriter one(standing.path(), m, kCase, kNames, {}, by_hand());
  put_frame(one, 0.0, {0.05, 0.05, 0.05}, {9.0, 0.05, kHeight});
  one.finish();
  CHECK_FALSE(facts_of(standing).time);
  CHECK(facts_of(standing).reach == 0.0);
}

}  // namespace
}  // namespace voussoir::io
