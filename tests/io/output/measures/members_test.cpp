// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "geometry/nth.h"
#include "io/input/files/hdf5_file.h"
#include "io/output/measures/measures_file.h"
#include "io/output/measures/members/cracked_units.h"
#include "io/output/measures/members/member_words.h"
#include "solver/run/reporter.h"
#include "tests/io/output/measures/hut.h"

// Storey drift by wall, slip of beams on walls, forces of ties and of the bars of decks and meshes.

namespace voussoir::io {
namespace {

using namespace test;

const std::string kTied = std::string(kHut) + R"(
[[tie]]
name  = "rod"
from  = [0.7, 0.1, 0.15]
to    = [0.7, 1.1, 0.15]
area  = 1.0e-4
yield = 2.0e8
[[tie]]
name = "elastic"
from = [0.5, 0.1, 0.15]
to   = [0.5, 1.1, 0.15]
area = 1.0e-4
[[house.mesh]]
name      = "net"
stiffness = 1.0e6
strength  = 1.0e3
)";

/// Rows of the two ties and of the net at a time [s].
void row(Hut& hut, double time, const std::array<solver::TieSample, 2>& ties, const solver::TieGroupSample& net) {
  hut.results().ties(time, ties);
  hut.results().tie_groups(time, std::array{net});
  hut.results().history(time, std::array<solver::HistorySample, 2>{});
}

const TieMeasures& tie(const Measures& m, const std::string& name) {
  const auto at = std::ranges::find(m.ties, name, &TieMeasures::name);
  REQUIRE(at != m.ties.end());
  return *at;
}

}  // namespace

TEST_CASE("rods and meshes are told apart, each with its largest force, elongation and utilisation") {
  Hut hut(kTied);
  hut.frame(0.0, stays);
  row(hut, 0.0, {{{1e3, 1e-4, 0, false}, {5e3, 2e-4, 0, false}}}, {10.0, 1e-5, 0.1, 0, 0});
  row(hut, 0.1, {{{15e3, 9e-4, 2e-4, false}, {-1e3, -1e-4, 0, false}}}, {-150.0, -3e-4, 1.0, 4, 1});
  row(hut, 0.2, {{{-2e3, 1e-4, 2e-4, false}, {0, 5e-3, 0, true}}}, {20.0, 1e-5, 0.2, 7, 2});
  const Measures m = hut.measures();
  REQUIRE(m.ties.size() == 3);
  const TieMeasures &rod = tie(m, "rod"), &elastic = tie(m, "elastic"), &net = tie(m, "net");
  CHECK(rod.bars == 0);
  CHECK(rod.peak_force == 15e3);
  CHECK(rod.peak_time == 0.1);
  CHECK(rod.peak_elongation == 9e-4);
  CHECK(rod.plastic == 2e-4);
  CHECK(rod.utilisation == doctest::Approx(0.75));  // of 20 kN
  CHECK(rod.yielded == 1);
  CHECK(rod.broken == 0);
  CHECK(elastic.peak_force == 5e3);
  CHECK(elastic.peak_elongation == 5e-3);
  CHECK(std::isnan(elastic.utilisation));
  CHECK(elastic.broken == 1);
  CHECK(elastic.yielded == 0);
  CHECK(net.bars > 10);
  CHECK(net.peak_force == -150.0);
  CHECK(net.peak_elongation == -3e-4);
  CHECK(net.utilisation == 1.0);
  CHECK(net.yielded == 7);
  CHECK(net.broken == 2);
  CHECK(std::isnan(net.plastic));
  const std::string words = ties_text(m);
  CHECK(words.find("rods and other ties") < words.find("  rod "));
  CHECK(words.find("  rod ") < words.find("decks and meshes"));
  CHECK(words.find("decks and meshes") < words.find("  net "));
  CHECK(words.find("75 %") != std::string::npos);
}

TEST_CASE("a model without ties has no measures of them, and no table") {
  Hut hut;
  hut.frame(0.0, stays);
  const Measures m = hut.measures();
  CHECK(m.ties.empty());
  CHECK(ties_text(m).empty());
}

TEST_CASE("the bar of a group that counts is the one with the largest magnitude; elastic bars have no utilisation") {
  solver::Ties ties;
  ties.tie.resize(4), ties.state.resize(4);
  const double yields[] = {100.0, 100.0, std::numeric_limits<double>::infinity(), 50.0};
  for (std::size_t i = 0; i < 4; ++i) ties.tie[i].law.yield = yields[i];
  ties.state[0].force = 60.0, ties.state[0].elongation = 1e-3;
  ties.state[1].force = -80.0, ties.state[1].elongation = -2e-3, ties.state[1].plastic = -1e-3;
  ties.state[2].force = 500.0;
  ties.state[3].broken = 1, ties.state[3].plastic = 1.0;
  const solver::TieGroupSample both = solver::sample_of(ties, 0, 2), all = solver::sample_of(ties, 0, 4),
                               elastic = solver::sample_of(ties, 2, 3);
  CHECK(both.force == -80.0);
  CHECK(both.elongation == -2e-3);
  CHECK(both.utilisation == doctest::Approx(0.8));
  CHECK(both.yielded == 1);
  CHECK(all.force == 500.0);
  CHECK(all.utilisation == doctest::Approx(0.8));
  CHECK(all.yielded == 1);
  CHECK(all.broken == 1);
  CHECK(std::isnan(elastic.utilisation));
}

TEST_CASE("storey drift is the mean of the whole top along the wall, its peak with its time") {
  Hut hut;
  const auto pushed = [&hut](double way) {
    return [&hut, way](std::size_t e, Vec3 x) { return hut.tag(e) == "front wall" && x.z > 0.3 ? x + Vec3{way, 0.0, 0.0} : x; };
  };
  hut.frame(0.0, stays);
  hut.frame(0.1, pushed(-0.008));
  hut.frame(0.2, pushed(0.002));
  const Measures m = hut.measures();
  const WallMeasures& front = wall(m, "front wall");
  CHECK(front.peak_storey_drift == doctest::Approx(-0.02).epsilon(1e-4));
  CHECK(front.peak_storey_drift_time == 0.1);
  CHECK(front.residual_storey_drift == doctest::Approx(0.005).epsilon(1e-4));
  CHECK(front.storey == 1);
  CHECK(front.foot == doctest::Approx(0.0));
  CHECK(front.top == doctest::Approx(0.4));
  CHECK(m.peak_storey_drift == doctest::Approx(0.02).epsilon(1e-4));
  CHECK(m.peak_storey_drift_wall == "front wall");
  CHECK(wall(m, "rear wall").peak_storey_drift == doctest::Approx(0.0));
  // The same way is to the left of who looks at the rear wall.
  Hut other;
  other.frame(0.0, stays);
  other.frame(0.1, [&](std::size_t e, Vec3 x) { return other.tag(e) == "rear wall" && x.z > 0.3 ? x + Vec3{0.008, 0.0, 0.0} : x; });
  CHECK(wall(other.measures(), "rear wall").peak_storey_drift == doctest::Approx(-0.02).epsilon(1e-4));
  CHECK(storeys_text(m).find("storey 1, 0.00 to 0.40 m") != std::string::npos);
  // That of an inner wall is positive along its axis, whichever it is.
  for (const bool x : {true, false}) {
    CAPTURE(x);
    std::string text = kHut;
    const std::string size = "inner_size = [1.0, 0.8]", base = "[base]";
    text.replace(text.find(size), size.size(), "inner_size = [1.2, 1.2]");
    text.replace(text.find(base), base.size(),
                 std::string("[[house.inner_wall]]\nname = \"middle\"\nat = 0.6\nalong = ") + (x ? "\"x\"" : "\"y\"") + "\n[base]");
    Hut parted(text);
    const Vec3 way = x ? Vec3{0.008, 0.0, 0.0} : Vec3{0.0, 0.008, 0.0};
    parted.frame(0.0, stays);
    parted.frame(0.1, [&](std::size_t e, Vec3 at) { return parted.tag(e).starts_with("middle") && at.z > 0.3 ? at + way : at; });
    CHECK(wall(parted.measures(), "middle wall").peak_storey_drift == doctest::Approx(0.02).epsilon(1e-4));
  }
}

TEST_CASE("slip of beams on the walls: how far, where, and which have lost their seat") {
  Hut hut;
  const auto slid = [&hut](Vec3 way, bool one) {
    return [&hut, way, one](std::size_t e, Vec3 x) { return hut.is_beam(e) && (!one || hut.tag(e) == "roof beam 1") ? x + way : x; };
  };
  hut.frame(0.0, stays);
  hut.frame(0.1, slid({0.0, 0.007, 0.0}, true));
  hut.frame(0.2, slid({0.0, 0.003, 0.001}, false));  // lifting is no slip
  Measures m = hut.measures();
  CHECK(m.peak_seat_slip == doctest::Approx(0.007).epsilon(1e-4));
  CHECK(m.peak_seat_slip_time == 0.1);
  CHECK(m.peak_seat_slip_place.starts_with("roof beam 1 on the "));
  CHECK(m.seat_slip == doctest::Approx(0.003).epsilon(1e-4));
  CHECK(m.lost_seats == 0);
  CHECK(wall(m, "rear wall").peak_seat_slip == doctest::Approx(0.007).epsilon(1e-4));
  CHECK(wall(m, "left wall").peak_seat_slip == doctest::Approx(0.003).epsilon(1e-4));  // beam 0 alone lies on it

  Hut fallen;
  fallen.frame(0.0, stays);
  fallen.frame(0.1, [&](std::size_t e, Vec3 x) { return fallen.tag(e) == "roof beam 1" ? x + Vec3{0.0, 0.1, -0.35} : x; });
  m = fallen.measures();
  CHECK(m.lost_seats == 2);  // at either end
  CHECK(m.peak_seat_slip == doctest::Approx(0.0));
}

TEST_CASE("measures of ties and storeys stand in run.h5") {
  Hut hut(kTied);
  hut.frame(0.0, stays);
  row(hut, 0.0, {{{1e3, 1e-4, 0, false}, {5e3, 2e-4, 0, false}}}, {10.0, 1e-5, 0.1, 0, 0});
  const Measures m = hut.measures();
  TempFolder folder;
  {
    Hdf5File file = Hdf5File::create(folder.file("measures.h5"));
    file.make_group("/summary");
    write_measures(file, m);
  }
  const Hdf5File file = Hdf5File::open(folder.file("measures.h5"));
  CHECK(file.read_strings("/summary/tie/name") == std::vector<std::string>{"rod", "elastic", "net"});
  CHECK(file.read<double>("/summary/tie/peak_force") == std::vector{1e3, 5e3, 10.0});
  CHECK(file.read<double>("/summary/wall/storey").size() == m.walls.size());
  CHECK(file.shape("/measures/storey_drift") == Shape{1, m.walls.size()});
}

TEST_CASE("units in cells that have cracked are counted, and those with a cut that is all broken") {
  std::string text = kHut;
  text.replace(text.find("[house]\n"), 8, "[house]\ncells = [2, 1, 2]\n")
      .replace(text.find("poisson = 0.25"), 14, "poisson = 0.25\ninside = \"normal\"");
  Hut hut(text);
  hut.frame(0.0, stays);
  const cases::Model& m = hut.model();
  const auto unit = [&](std::int32_t e) { return e < 0 ? -1 : nth(m.blocks, e).unit; };
  std::vector<std::size_t> within, mortar;  // joints between cells of the units 3 and 5; of unit 7 with others
  for (std::size_t j = 0; j < m.assembly.joints.size(); ++j) {
    const std::int32_t a = unit(m.assembly.joints[j].element_a), b = unit(m.assembly.joints[j].element_b);
    if (a == b && (a == 3 || a == 5)) within.push_back(j);
    if (a != b && a == 7) mortar.push_back(j);
  }
  REQUIRE(within.size() > 2);
  REQUIRE(!mortar.empty());
  hut.crack_whole_joint(0.1, mortar[0]);
  for (const std::size_t j : within) {
    const geometry::Joint& joint = m.assembly.joints[j];
    const double share = unit(joint.element_a) == 3 ? 1.0 : 0.4;
    const solver::CrackRow row{.time = 0.2,
                               .joint = static_cast<std::int32_t>(j),
                               .element_a = joint.element_b,
                               .element_b = joint.element_a,
                               .area = share * joint.area};
    hut.results().cracks(std::array{row});
  }
  hut.results().finish();
  const CrackedUnits u = cracked_units(Hdf5File::open(hut.file()));
  CHECK(u.units == m.units);
  CHECK(u.cells == std::ranges::count_if(m.blocks, [](const cases::Block& b) { return b.unit >= 0; }));
  CHECK(u.cracked == 2);
  CHECK(u.through == 1);
}

}  // namespace voussoir::io
