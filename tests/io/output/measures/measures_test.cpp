// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/measures.h"

#include <cmath>
#include <functional>

#include "io/input/case_file/case_file.h"
#include "io/output/measures/chance.h"
#include "io/output/measures/damage_grade.h"
#include "io/output/measures/measures_file.h"
#include "solver/run/collapse.h"
#include "tests/io/output/measures/hut.h"

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
  std::array<float, 6> moved{};
  std::size_t i = 0;
  for (const Vec3 u : {brick - Vec3{0.05, 0.05, 0.05}, beam - Vec3{0.15, 0.05, kHeight}})
    for (const double x : {u.x, u.y, u.z}) moved[i++] = static_cast<float>(x);
  results.frame({time, moved, upright, whole});
}

TEST_CASE("measures: figures are left to chance only where something fell, and the note says since when and what holds") {
  Measures m;
  CHECK_FALSE(has_chance(m));
  CHECK(measures_json(m).find("\"chance\"") == std::string::npos);
  m.shaking_cracks = 1000, m.first_crack_time = 0.5;  // broken, but nothing has fallen
  CHECK_FALSE(has_chance(m));
  m.first_fallen_time = 3.92;
  CHECK(has_chance(m));
  CHECK(words_of_chance(m).starts_with("Parts fall from 3.92 s on"));
  const std::string json = measures_json(m);
  CHECK(json.find("\"chance\":{\"from\":3.92,\"figures\":[\"fallen_mass_fraction\"") != std::string::npos);
  for (const std::string_view name : figures_of_chance()) {
    CAPTURE(name);
    for (const char* robust : {"first_crack_time", "damage_grade", "collapse_time", "first_fallen_time", "tension", "shear"})
      CHECK(name != robust);
  }
}

TEST_CASE("an element has fallen by half its first height, or by 1 m") {
  CHECK_FALSE(FallenMass::has_fallen(0.5 * 0.4, 0.4));
  CHECK(FallenMass::has_fallen(0.5 * 0.4 + 1e-9, 0.4));
  CHECK_FALSE(FallenMass::has_fallen(1.0, 3.0));
  CHECK(FallenMass::has_fallen(1.0 + 1e-9, 3.0));
  CHECK_FALSE(FallenMass::has_fallen(0.0, -0.5));
  CHECK_FALSE(FallenMass::has_fallen(1.0, -0.5));
  CHECK(FallenMass::has_fallen(1.0 + 1e-9, -0.5));
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
  const Measures m = measures_of(folder);
  CHECK(m.collapse_time == 0.2);
  CHECK(m.debris.reach == 0.0);  // all of it inside
  CHECK(m.first_fallen_time == 0.1);
  CHECK(m.first_fallen_wall == "front wall");
  CHECK(m.roof_first_fallen_time == 0.2);
  CHECK(m.roof_fallen_mass_fraction == 1.0);
  CHECK(m.series.fallen_mass_fraction == std::vector<double>{0.0, 1.8 / (1.8 + 9.0), 1.0, 1.0});
}

TEST_CASE("a fixed block is no part of what may fall") {
  const TempFolder folder;
  cases::Model m = wall_and_beam();
  m.blocks[0].fixed = true;
  ResultsWriter results(folder.path(), m, kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, 0.05, 0.05}, {0.15, 0.05, kHeight});
  put_frame(results, 0.1, {0.05, -3.0, 0.01}, {0.15, 0.05, kHeight});  // a support that sinks
  put_frame(results, 0.2, {0.05, -3.0, 0.01}, {0.15, 0.05, 0.05});
  results.finish();
  const Measures measured = measures_of(folder);
  CHECK(measured.series.fallen_mass_fraction == std::vector<double>{0.0, 0.0, 1.0});
  CHECK(measured.first_fallen_time == 0.2);
  CHECK(measured.debris.reach == 0.0);
}

TEST_CASE("debris reaches as far as the farthest fallen element is from the footprint") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), wall_and_beam(), kCase, kNames, {}, by_hand());
  // The footprint is 0 to 0.2 m along x and 0 to 0.1 m along y. The beam, five sixths of the mass, lies 3 m and 4 m beyond its corner, the
  // brick 7 m beyond one side.
  put_frame(results, 0.0, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, 0.05});
  results.finish();
  const Measures m = measures_of(folder);
  CHECK(m.debris.reach == doctest::Approx(7.0));
  CHECK(m.debris.reach_95 == doctest::Approx(7.0));  // 5/6 is less than 95 %
}

TEST_CASE("of debris wider than any unit the middle 50 m count") {
  const TempFolder folder;
  cases::Model model = wall_and_beam();
  for (Vec3& v : model.blocks[1].shape.vertices) v.x *= 1e6, v.y *= 1e6;
  for (std::size_t f = 6; f < 10; ++f) model.assembly.faces[f].distance *= 1e6;  // those along x and y
  ResultsWriter results(folder.path(), model, kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, 0.05, 0.05}, {0.2 + 3, 0.1 + 4, 0.05});
  results.finish();
  CHECK(measures_of(folder).debris.area == doctest::Approx(50.0 * 50.0).epsilon(0.01));
}

TEST_CASE("what stands is no debris, and what flies off alone does not count among 95 % of it") {
  const TempFolder folder;
  cases::Model model = wall_and_beam();
  model.materials[1].value.density = 1800.0 * 20;  // the beam is 20/21 of the mass: more than 95 %
  ResultsWriter results(folder.path(), model, kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, kHeight});
  put_frame(results, 0.1, {0.05, -7.0, 0.01}, {0.2 + 3, 0.1 + 4, 0.05});
  results.finish();
  const Debris debris = measures_of(folder).debris;
  CHECK(debris.reach == doctest::Approx(7.0));
  CHECK(debris.reach_95 == doctest::Approx(std::hypot(3.0, 4.0)));

  const TempFolder standing;
  ResultsWriter one(standing.path(), model, kCase, kNames, {}, by_hand());
  put_frame(one, 0.0, {0.05, 0.05, 0.05}, {9.0, 0.05, kHeight});
  one.finish();
  CHECK(measures_of(standing).collapse_time < 0.0);
  CHECK(measures_of(standing).debris.reach == 0.0);
}

TEST_CASE("the free volume is that under the roof less what lies in it") {
  Hut hut;
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.is_beam(e) ? x - Vec3{0, 0, 0.3} : x; });
  hut.frame(0.2, [&](std::size_t e, Vec3 x) { return hut.is_beam(e) ? x + Vec3{9, 0, 0} : x; });
  // A header of the left wall, 0.2 m along x, lies on the floor, its sides on the borders of cells.
  const auto& blocks = hut.model().blocks;
  const auto is_header = [](const cases::Block& b) {
    return b.tag == "left wall" && b.whole && b.shape.vertices[1].x - b.shape.vertices[0].x > 0.19;
  };
  const auto brick = static_cast<std::size_t>(std::ranges::find_if(blocks, is_header) - blocks.begin());
  REQUIRE(brick < blocks.size());
  hut.frame(0.3, [&](std::size_t e, Vec3 x) { return e == brick ? Vec3{0.2 + 0.3, 0.2 + 0.25, 0.05} : x; });
  const Measures m = hut.measures();
  const double room = 1.0 * 0.8 * 0.4;
  CHECK(m.initial_free_volume == doctest::Approx(room));
  REQUIRE(m.series.free_volume.size() == 4);
  CHECK(m.series.free_volume[0] == doctest::Approx(1.0));
  CHECK(m.series.free_volume[1] == doctest::Approx(0.1 / 0.4));
  CHECK(m.series.free_volume[2] == doctest::Approx(1.0));  // nothing lies on anybody; above the walls' top it does not count
  CHECK(m.series.free_volume[3] == doctest::Approx(1.0 - 0.2 * 0.1 * 0.1 / room));
  CHECK(m.least_free_volume == m.series.free_volume[1]);
  CHECK(m.free_volume == m.series.free_volume[3]);
}

TEST_CASE("drift is outward, relative to the foot, and ends with the wall") {
  Hut hut;
  const auto lean = [&](double top, double foot) {
    return [&hut, top, foot](std::size_t e, Vec3 x) {
      if (hut.tag(e) == "front wall") x.y -= x.z > 0.3 ? top : foot, x.x -= x.z > 0.3 ? 0.02 : 0.0;
      return x;
    };
  };
  hut.frame(0.0, stays);
  hut.frame(0.1, lean(0.15, 0.01));
  hut.frame(0.2, lean(-0.02, 0.0));
  hut.frame(0.3, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "rear wall" && x.z > 0.3 ? x - Vec3{0, 0, 0.3} : x; });
  const Measures m = hut.measures();
  CHECK(wall(m, "front wall").peak_drift == doctest::Approx((0.15 - 0.01) / 0.4));
  CHECK(wall(m, "front wall").residual_drift == doctest::Approx(0.0));
  CHECK(std::isnan(wall(m, "rear wall").residual_drift));
  CHECK(wall(m, "rear wall").peak_drift == doctest::Approx(0.0));
  CHECK(wall(m, "rear wall").first_fallen_time == 0.3);
  CHECK(wall(m, "left wall").first_fallen_time < 0);
  CHECK(m.first_fallen_wall == "rear wall");
  CHECK(m.peak_drift == doctest::Approx(0.14 / 0.4));
  CHECK(wall(m, "front wall").peak_in_plane_drift == doctest::Approx(-0.02 / 0.4));
  const std::size_t front = static_cast<std::size_t>(&wall(m, "front wall") - m.walls.data());
  // A lean of 0.14 m is 0.7 thicknesses, serious, but does not last; the top course of four is more than a fifth of a wall.
  CHECK(m.series.damage_grade == std::vector<std::int64_t>{0, 0, 0, 4});
  CHECK(m.series.drift.size() == 4 * m.walls.size());
  CHECK(m.series.drift[2 * m.walls.size() + front] == doctest::Approx(-0.02 / 0.4));
}

TEST_CASE("a wall has fallen by a quarter later than its first brick, or never") {
  Hut hut;
  const auto falls = [&hut](const std::string& name, double above) {
    return [&hut, name, above](std::size_t e, Vec3 x) { return hut.tag(e) == name && x.z > above ? x - Vec3{0, 0, x.z - 0.05} : x; };
  };
  std::size_t brick = 0;
  while (hut.tag(brick) != "left wall" || hut.centroid(brick).z < 0.3) ++brick;
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return e == brick ? x - Vec3{0, 0, 0.25} : falls("rear wall", 0.3)(e, x); });
  for (const double time : {0.2, 0.3})  // the first time counts
    hut.frame(time, [&](std::size_t e, Vec3 x) { return falls("left wall", 0.2)(e, falls("rear wall", 0.3)(e, x)); });
  const Measures m = hut.measures();
  CHECK(wall(m, "left wall").first_fallen_time == 0.1);
  CHECK(wall(m, "left wall").quarter_fallen_time == 0.2);
  CHECK(wall(m, "front wall").quarter_fallen_time == kNeverReached);
}

TEST_CASE("out of the house is told by a wall's name and the turn of the house, for one wall alone and for one thicker than long") {
  for (const int turn : {0, 90, 180, 270}) {
    for (const std::string side : {"front", "right", "rear", "left"}) {
      CAPTURE(turn);
      CAPTURE(side);
      std::string text = kHut;
      const std::string keys = "[house]\nwalls = [\"" + side + "\"]\nturn = " + std::to_string(turn) + "\nbearing_wall = 0.8\n";
      text.replace(text.find("[house]\n"), 8, keys);
      text.replace(text.find("inner_size = [1.0, 0.8]"), 23, "inner_size = [0.2, 0.8]");
      text.replace(text.find("roof = { kind = \"flat\" }"), 24, "roof = { kind = \"none\" }");
      Hut hut(text);
      const double angle = (turn + (side == "right"  ? 0.0
                                    : side == "rear" ? 90.0
                                    : side == "left" ? 180.0
                                                     : 270.0)) *
                           std::acos(-1.0) / 180.0;
      hut.frame(0.0, stays);
      hut.frame(0.1, [&](std::size_t, Vec3 x) { return x.z > 0.3 ? x + 0.1 * Vec3{std::cos(angle), std::sin(angle), 0.0} : x; });
      const Measures m = hut.measures();
      CHECK(m.series.drift.at(1) == doctest::Approx(0.1 / 0.4).epsilon(1e-5));
    }
  }
}

TEST_CASE("a crack along the whole foot of a wall has the extent one, and its width tells which") {
  Hut hut;
  const auto& joints = hut.model().assembly.joints;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].element_b < 0 && hut.tag(static_cast<std::size_t>(joints[j].element_a)) == "front wall") hut.crack_whole_joint(0.05, j);
  const auto slide = [&](double by) {
    return [&hut, by](std::size_t e, Vec3 x) { return hut.tag(e) == "front wall" ? x - Vec3{0, by, 0} : x; };
  };
  hut.frame(0.0, slide(0.01));  // the joints have not come open yet
  hut.frame(0.1, slide(0.01));
  hut.frame(0.2, slide(0.002));
  const Measures m = hut.measures();
  CHECK(wall(m, "front wall").crack_extent == doctest::Approx(1.0));
  CHECK(wall(m, "front wall").large_crack_extent == 0.0);
  CHECK(wall(m, "front wall").opened_extent == doctest::Approx(1.0));
  CHECK(wall(m, "front wall").first_open_joint_time == 0.05);
  CHECK(wall(m, "rear wall").crack_extent == 0.0);
  CHECK(wall(m, "rear wall").opened_extent == 0.0);
  CHECK(wall(m, "rear wall").first_open_joint_time == kNeverReached);
  CHECK(m.first_crack_time == 0.05);
  // One wall in four is many, not most.
  CHECK(m.series.damage_grade == std::vector<std::int64_t>{0, 2, 2});
  CHECK(m.grade_time == std::array{0.1, 0.1, kNeverReached, kNeverReached, kNeverReached});
}

TEST_CASE("the area of debris counts what lies upon another once") {
  const TempFolder folder;
  ResultsWriter results(folder.path(), wall_and_beam(), kCase, kNames, {}, by_hand());
  put_frame(results, 0.0, {0.05, 0.05, 0.01}, {0.1, 0.05, 0.12});  // two cubes of 0.1 m, half of one over the other
  results.finish();
  CHECK(measures_of(folder).debris.area == doctest::Approx(0.15 * 0.1));
}

TEST_CASE("damage grades of EMS-98 at their thresholds") {
  BuildingDamage d;
  d.walls.resize(4);
  CHECK(damage_grade(d) == 0);
  d.walls[0].cracks.any = kCracked;
  CHECK(damage_grade(d) == 1);
  d.walls[0].cracks.fine = kCracked;  // one of four walls: many
  CHECK(damage_grade(d) == 2);
  d.walls[0].cracks.large = d.walls[1].cracks.large = kExtensive;  // two of four: not most
  CHECK(damage_grade(d) == 2);
  d.walls[2].cracks.large = kExtensive;
  CHECK(damage_grade(d) == 3);

  BuildingDamage lost;
  lost.walls.resize(4);
  lost.fallen = 1e-4;  // a brick
  CHECK(damage_grade(lost) == 1);
  lost.walls[3].fallen = kPartOfMass;
  CHECK(damage_grade(lost) == 3);
  lost.walls[3].fallen = kSeriousLoss;
  CHECK(damage_grade(lost) == 4);
  lost.walls[3].fallen = 0;
  lost.walls[3].lean = kSeriousLean;
  CHECK(damage_grade(lost) == 4);
  lost.walls[3].lean = 0;
  lost.fallen_roof = kPartOfMass;
  CHECK(damage_grade(lost) == 4);
  lost.fallen = kNearTotalLoss;
  CHECK(damage_grade(lost) == 5);
  lost.fallen = 0;
  lost.collapsed = true;
  CHECK(damage_grade(lost) == 5);
}

TEST_CASE("measures stand in run.h5 beside the summary, each with its unit, and are those of its frames") {
  Hut hut;
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.is_beam(e) ? x - Vec3{0, 0, 2.0} : x; });
  hut.results().measure();
  const Measures m = hut.measures();
  const Hdf5File file = Hdf5File::open(hut.file());
  CHECK(file.attribute_int("/summary", "damage_grade") == 5);
  CHECK(file.attribute_double("/summary", "collapse_time") == 0.1);
  CHECK(file.attribute_text("/summary", "first_fallen_wall").empty());
  CHECK(file.attribute_double("/summary", "roof_fallen_mass_fraction") == 1.0);
  for (const Figure& f : figures_of(m)) CHECK_MESSAGE(file.has_attribute("/summary", f.name), f.name);
  CHECK(file.read_strings("/summary/wall/name").size() == 4);
  CHECK(file.read<double>("/measures/time") == std::vector{0.0, 0.1});
  CHECK(file.shape("/measures/drift") == Shape{2, 4});
  for (const char* group : {"/measures", "/summary/wall"})
    for (const std::string& name : file.children(group)) {
      CHECK_MESSAGE(file.has_attribute(group + ("/" + name), "unit"), name);
      CHECK_MESSAGE(file.has_attribute(group + ("/" + name), "description"), name);
    }
}

TEST_CASE("a run without frames or without walls has what can be measured, and no more") {
  const TempFolder folder;
  ResultsWriter(folder.path(), two_cubes(), kCase, kNames, {}, by_hand()).finish();
  const Measures m = measures_of(folder);
  CHECK(m.damage_grade == -1);
  CHECK(std::isnan(m.free_volume));
  CHECK(std::isnan(m.peak_drift));
  CHECK(m.walls.empty());  // a "front wall" of no house
  CHECK(measures_json(m).find("\"free_volume\":null") != std::string::npos);
}

}  // namespace
}  // namespace voussoir::io
