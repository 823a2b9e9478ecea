// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>
#include <string>

#include "io/input/files/errors.h"
#include "io/output/measures/building/building.h"
#include "tests/io/output/measures/hut.h"
#include "tests/io/results_fixture.h"

// Walls, rooms and drift of houses with storeys and inner walls, and of blocks that name their part.
namespace voussoir::io {
namespace {

using namespace test;

constexpr const char* kMaterials = R"(
[materials.adobe]
density = 1800.0
young = 9.8e7
poisson = 0.25
[materials.wood]
density = 700.0
young = 6.3e8
poisson = 0.3
[joint_laws.wood]
tension = 1e7
cohesion = 9e6
friction = 0.0
compression = 4e7
[base]
z = 0.0
)";

/// Outer size 2.4 x 1.6 m, two storeys of 0.6 and 0.4 m, an inner wall at x = 1.0 to 1.2 m in the first, a floor of beams 0.1 m high.
const std::string kStoreys = std::string(kMaterials) + R"(
[house]
inner_size = [2.0, 1.2]
height = 0.6
joint = "dry"
[house.wood]
within_member = "wood"
between_members = "dry"
[[house.storey]]
height = 0.4
[[house.inner_wall]]
name = "middle"
at = 1.0
storeys = [1]
[[house.floor]]
beam = [0.1, 0.1]
spacing = 0.3
)";

Building building(Hut& hut) {
  hut.results().finish();
  return building_of(Hdf5File::open(hut.file()));
}

const Wall& named(const Building& b, const std::string& name) {
  const auto at = std::ranges::find(b.walls, name, &Wall::name);
  REQUIRE(at != b.walls.end());
  return *at;
}

}  // namespace

TEST_CASE("walls of storeys and inner walls are walls of their own") {
  Hut hut(kStoreys);
  hut.frame(0.0, stays);
  const Building b = building(hut);
  CHECK(b.walls.size() == 4 + 1 + 4);
  const Wall &lower = named(b, "rear wall, storey 1"), &upper = named(b, "rear wall, storey 2"),
             &middle = named(b, "middle wall, storey 1");
  CHECK(lower.height() == doctest::Approx(0.6));
  CHECK(upper.box.low[2] == doctest::Approx(0.6));
  CHECK(upper.height() == doctest::Approx(0.4));
  CHECK(upper.across == 1);
  CHECK(upper.outward == 1.0);
  CHECK(named(b, "front wall, storey 2").outward == -1.0);
  CHECK(middle.inner);
  CHECK(middle.across == 0);
  CHECK(middle.length() == doctest::Approx(1.6));
  CHECK(!lower.inner);
}

TEST_CASE("heights are above the base, and without a base those of the case, whatever lies below") {
  const std::string ground = "[[block]]\nname = \"ground\"\nmaterial = \"adobe\"\nfixed = true\nbox = [[0, 0, -0.5], [2.4, 1.6, 0]]\n";
  std::string no_base = kStoreys + ground, high = kStoreys;
  no_base.replace(no_base.find("[base]\nz = 0.0\n"), 15, "");
  high.replace(high.find("z = 0.0"), 7, "z = 3.0");
  for (const std::string& text : {kStoreys, no_base, high}) {
    CAPTURE(text);
    Hut hut(text);
    hut.frame(0.0, stays);
    const Measures m = hut.measures();
    CHECK(wall(m, "rear wall, storey 1").foot == doctest::Approx(0.0));
    CHECK(wall(m, "rear wall, storey 1").top == doctest::Approx(0.6));
    CHECK(wall(m, "rear wall, storey 2").foot == doctest::Approx(0.6));
    CHECK(wall(m, "rear wall, storey 2").top == doctest::Approx(1.0));
  }
}

TEST_CASE("rooms are those between the walls of a storey, under its floor") {
  Hut hut(kStoreys);
  hut.frame(0.0, stays);
  const Building b = building(hut);
  REQUIRE(b.rooms.size() == 3);
  CHECK(b.rooms[0].low[0] == doctest::Approx(0.2));
  CHECK(b.rooms[0].high[0] == doctest::Approx(1.0));
  CHECK(b.rooms[1].low[0] == doctest::Approx(1.2));
  CHECK(b.rooms[1].high[0] == doctest::Approx(2.2));
  CHECK(b.rooms[1].ceiling == doctest::Approx(0.6));
  CHECK(b.rooms[2].floor == doctest::Approx(0.6));
  CHECK(!b.rooms[0].top);
  CHECK(b.rooms[2].top);
}

TEST_CASE("a floor between walls of any plan covers the storeys that end below it, whatever its name") {
  const auto covers = [](const std::string& height) {
    std::string text = kStoreys;
    for (const char* place : {"0.0", "1.2"}) {
      text +=
          std::string("[[wall]]\nname = \"at ") + place + "\"\npoints = [[4.0, " + place + "], [6.0, " + place + "]]\nthickness = 0.2\n";
      text += "height = " + height + "\nmaterial = \"adobe\"\n";
    }
    text += "[[floor]]\nname = \"floor 2\"\nwalls = [\"at 0.0\", \"at 1.2\"]\nmaterial = \"wood\"\nbeam = [0.1, 0.1]\nspacing = 0.5\n";
    Hut hut(text);
    hut.frame(0.0, stays);
    const Building b = building(hut);
    std::set<int> own, of_house;
    for (std::size_t e = 0; e < b.kind.size(); ++e) {
      if (b.kind[e] == cases::PartKind::floor_beam) (hut.tag(e).starts_with("floor 2") ? own : of_house).insert(b.covers[e]);
    }
    CHECK(of_house == std::set{1});
    REQUIRE(own.size() == 1);
    return *own.begin();
  };
  CHECK(covers("0.4") == 0);
  CHECK(covers("0.6") == 1);
  CHECK(covers("1.0") == 2);
}

TEST_CASE("free volume: a floor that falls takes that of the room below and leaves that above") {
  Hut hut(kStoreys);
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.tag(e).starts_with("floor") ? x - Vec3{0, 0, 0.5} : x; });
  const double beams = 0.1 * 1.2 * 0.1;  // each, between the walls
  const Measures m = hut.measures();
  const double below = 1.8 * 1.2 * 0.6, above = 2.0 * 1.2 * 0.4;
  CHECK(m.initial_free_volume < below + above);
  CHECK(m.initial_free_volume > below + above - 8 * beams);
  CHECK(m.free_volume < 1.0);
  CHECK(m.free_volume > above / (below + above));
}

TEST_CASE("drift of an upper wall is against its own foot") {
  Hut hut(kStoreys);
  const auto lean = [&](std::size_t e, Vec3 x) {
    const bool upper = hut.tag(e) == "rear wall, storey 2";
    return upper && x.z > 0.85 ? x + Vec3{0, 0.02, 0} : upper ? x + Vec3{0, 0.01, 0} : x;
  };
  hut.frame(0.0, stays);
  hut.frame(0.1, lean);
  const Measures m = hut.measures();
  CHECK(wall(m, "rear wall, storey 2").peak_drift == doctest::Approx(0.01 / 0.4));
  CHECK(wall(m, "rear wall, storey 1").peak_drift == doctest::Approx(0.0));
}

TEST_CASE("blocks that name their part are that wall; others are none") {
  std::string text = kMaterials;
  for (int i = 0; i < 6; ++i) {
    const std::string x = std::to_string(0.5 * (i % 3)), z = std::to_string(0.2 * (i / 3));
    text += "[[block]]\nname = \"b" + std::to_string(i) + "\"\nmaterial = \"adobe\"\npart = \"rear wall\"\nbox = [[" + x + ", 2.0, " + z +
            "], [" + std::to_string(0.5 * (i % 3) + 0.5) + ", 2.2, " + std::to_string(0.2 * (i / 3) + 0.2) + "]]\n";
  }
  text += "[[block]]\nname = \"garden wall\"\nmaterial = \"adobe\"\nbox = [[0, 0, 0], [1, 0.2, 0.2]]\n";
  Hut hut(text);
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "rear wall" && x.z > 0.2 ? x + Vec3{0, 0.02, 0} : x; });
  const Measures m = hut.measures();
  REQUIRE(m.walls.size() == 1);
  CHECK(wall(m, "rear wall").peak_drift == doctest::Approx(0.02 / 0.4));
  CHECK(m.damage_grade >= 0);
}

TEST_CASE("storey drift of an inner wall counts along x or y, that of the walls around to the right as seen from outside") {
  for (const bool along_x : {false, true}) {
    std::string text = kStoreys;
    if (along_x) text.replace(text.find("at = 1.0"), 8, "at = 0.6\nalong = \"x\"");
    Hut hut(text);
    const Vec3 way = along_x ? Vec3{0.003, 0.0, 0.0} : Vec3{0.0, 0.003, 0.0};
    hut.frame(0.0, stays);
    hut.frame(0.1, [&](std::size_t, Vec3 x) { return x.z > 0.1 ? x + way : x; });
    const Measures m = hut.measures();
    const auto drift = [&](const char* name) { return wall(m, name).peak_storey_drift; };
    CAPTURE(along_x);
    CHECK(drift("middle wall, storey 1") == doctest::Approx(0.003 / 0.6));
    CHECK(wall(m, "middle wall, storey 1").peak_in_plane_drift > 0.0);
    CHECK(drift(along_x ? "front wall, storey 1" : "right wall, storey 1") == doctest::Approx(0.003 / 0.6));
    CHECK(drift(along_x ? "rear wall, storey 1" : "left wall, storey 1") == doctest::Approx(-0.003 / 0.6));
  }
}

TEST_CASE("a house that is turned by no quarter, and a base at no height, are refused by their keys") {
  const auto refused = [](const std::string& toml) {
    const TempFolder folder;
    ResultsWriter writer(folder.path(), two_cubes(), kCase + toml, kNames, {}, by_hand());
    record(writer, 0);
    writer.finish();
    try {
      building_of(Hdf5File::open(folder.file("run.h5")));
    } catch (const FileError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(refused("[house]\nturn = 270\n").empty());
  for (const char* turn : {"-540", "1e300", "45"})  // the first once indexed walls by -1
    CHECK(refused(std::string("[house]\nturn = ") + turn + "\n").find("house.turn = ") != std::string::npos);
  CHECK(refused("[house]\nturn = nan\n").find("house.turn is no finite number") != std::string::npos);
  CHECK(refused("[base]\nz = -inf\n").find("base.z is no finite number") != std::string::npos);
}

}  // namespace voussoir::io
