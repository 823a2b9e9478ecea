// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "io/output/measures/members/member_words.h"
#include "tests/io/output/measures/hut.h"

// Storeys and gables of walls of any plan in the measures: as those of houses.
namespace voussoir::io {
namespace {

using namespace test;

constexpr const char* kHead = R"(title = "walls"
[materials.adobe]
density = 1800.0
young = 9.8e7
poisson = 0.25
[joint_laws.normal]
tension = 1.27e5
cohesion = 3.04e4
friction = 32.0
compression = 4.9e5
[joints]
default = "normal"
[base]
z = 0.0
)";

std::string wall_of(const std::string& name, const std::string& points, double base, const std::string& more = "") {
  return "[[wall]]\nname = \"" + name + "\"\npoints = " + points + "\nthickness = 0.2\nbase = " + std::to_string(base) +
         "\nheight = 0.8\nmaterial = \"adobe\"\n" + more;
}

}  // namespace

TEST_CASE("a wall upon another has a storey and drifts of its own") {
  Hut hut(kHead + wall_of("low", "[[0, 0], [2, 0]]", 0.0) + wall_of("high", "[[0, 0], [2, 0]]", 0.8));
  hut.frame(0.0, stays);
  const auto along = [](Vec3 x) { return Vec3{x.z < 0.8 ? 0.0 : x.z < 1.5 ? 0.004 : 0.012, 0.0, 0.0}; };
  hut.frame(0.1, [&](std::size_t, Vec3 x) { return x + along(x); });
  const Measures m = hut.measures();
  REQUIRE(m.walls.size() == 2);
  const WallMeasures &low = wall(m, "low wall, storey 1"), &high = wall(m, "high wall, storey 2");
  CHECK(low.storey == 1);
  CHECK(high.storey == 2);
  CHECK(high.foot == doctest::Approx(0.8));
  CHECK(std::abs(low.peak_storey_drift) == doctest::Approx(0.0));
  CHECK(std::abs(high.peak_storey_drift) == doctest::Approx(0.008 / 0.8).epsilon(1e-3).scale(0.0));
  CHECK(m.peak_storey_drift_wall == "high wall, storey 2");
  const std::string words = storeys_text(m);
  CHECK(words.find("storey 1, 0.00 to 0.80 m") != std::string::npos);
  CHECK(words.find("storey 2, 0.80 to 1.60 m") != std::string::npos);
}

TEST_CASE("the drift of a wall under a gable is that of its eaves, the gable has its own, along axes or not") {
  for (const bool askew : {false, true}) {
    CAPTURE(askew);
    const Vec3 out = askew ? Vec3{-0.6, 0.8, 0.0} : Vec3{0.0, 1.0, 0.0};
    Hut hut(kHead +
            wall_of("end", askew ? "[[0, 0], [1.6, 1.2]]" : "[[0, 0], [2, 0]]", 0.0,
                    "gable = 1.8\n[[wall.opening]]\nfrom = 0.9\nwidth = 0.2\nsill = 0.9\nheight = 0.3\nlintel = { bearing = 0.1 }\n"));
    const auto is_gable = [&](std::size_t e) { return hut.tag(e) == "end gable" || hut.centroid(e).z > 0.8; };
    hut.frame(0.0, stays);
    hut.frame(0.1, [&](std::size_t e, Vec3 x) { return is_gable(e) && x.z > 0.92 ? x + 0.03 * out : x; });
    hut.frame(0.2, [&](std::size_t e, Vec3 x) { return !is_gable(e) && x.z > 0.65 ? x + 0.01 * out : x; });
    const Measures m = hut.measures();
    REQUIRE(m.walls.size() == 1);
    const WallMeasures& w = m.walls[0];
    CHECK(w.top == doctest::Approx(0.8));
    CHECK(std::abs(w.peak_drift) == doctest::Approx(0.01 / 0.8).epsilon(1e-3).scale(0.0));
    CHECK(w.peak_drift_time == 0.2);
    CHECK(std::abs(w.peak_gable_drift) == doctest::Approx(0.03).epsilon(1e-3).scale(0.0));
    CHECK(m.peak_gable == "end gable");
    const Building b = building_of(Hdf5File::open(hut.file()));
    REQUIRE(b.gables.size() == 1);
    CHECK(b.gables[0].part.height() == doctest::Approx(1.0));
    for (std::size_t e = 0; e < b.kind.size(); ++e) {  // its lintel, too
      if (b.kind[e] == cases::PartKind::lintel) CHECK((b.wall[e] == 0 && b.gable[e] == 1));
    }
  }
}

}  // namespace voussoir::io
