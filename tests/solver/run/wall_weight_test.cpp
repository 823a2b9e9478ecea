// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/analysis/drive.h"
#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "tests/cases/walls/plan_spans.h"
#include "tests/solver/no_rows.h"

// The weight of walls of any plan ([[wall]]), of their floors and roofs, reaches the base, and by the walls that carry it.
namespace voussoir::testing {
namespace {

constexpr double kGravity = 9.8;   // m/s2
constexpr double kBearing = 0.15;  // m
constexpr double kSpan = 1.6;      // m, clear, of the first floor; of the second 1.2

/// Case of three parallel walls of one block through, in mortar, with a light floor from the first to the second and a heavy one from the
/// second to the third. Loose beams lie in pockets.
cases::Case three_walls() {
  cases::Case c = case_of({});
  c.analysis.kind = cases::AnalysisKind::rest;
  c.analysis.tolerance = 1e-6;
  double y = 0.0;
  const std::array<double, 3> thick{0.25, 0.45, 0.3};
  const std::array<double, 3> clear{0.0, kSpan, 1.2};
  for (std::size_t i = 0; i < 3; ++i) {
    y += clear[i] + 0.5 * thick[i] + (i > 0 ? 0.5 * thick[i - 1] : 0.0);
    c.walls.push_back(wall(std::string(1, static_cast<char>('a' + i)), {{-0.6, y}, {0.6, y}}, thick[i], 0.8, cases::WallBond::through));
  }
  c.floors = {floor_between("light", {"a", "b"}), floor_between("heavy", {"b", "c"})};
  for (cases::WallFloor& f : c.floors) f.beams.bearing = kBearing, f.beams.spacing = 0.5, f.within_member = "wood";
  c.floors[0].beams.load = 60.0, c.floors[1].beams.load = 300.0;
  return c;
}

/// Forces at rest [N]: on the base as a whole, and under each wall, in the order a, b, c, ...
struct Support {
  Vec3 base;
  std::vector<double> under;
};

/// \param walls  of which the forces are asked for one by one; no two of them have a common range of y
Support at_rest(cases::Case c, const cases::Model& m, std::vector<std::string> walls) {
  std::ranges::sort(walls);
  for (const std::string& name : walls) {
    const auto found = std::ranges::find(c.walls, name, &cases::WallSpec::name);
    const double half = 0.5 * found->thickness;
    double low = 1e9, high = -1e9;
    for (const auto& p : found->points) low = std::min(low, p[1] - half), high = std::max(high, p[1] + half);
    cases::Cut cut;
    cut.name = name, cut.point = {0.0, 0.0, 0.0}, cut.box = {{Vec3{-1e3, low, -1.0}, Vec3{1e3, high, 1.0}}};
    c.output.cuts.push_back(cut);
  }
  solver::Simulation sim(c, m, {}, {});
  solver::RunState plan;
  solver::choose_drive(sim, c);
  NoRows rows;
  solver::run(sim, plan, c, c.end(), rows, [](const solver::RunStatus&) { return true; });
  sim.step({true, true});
  Support s{sim.forces().base_shear, {}};
  for (const solver::CutSample& cut : sim.cuts()) s.under.push_back(std::abs(cut.force.z));
  return s;
}

/// Weights [N]: of all, of each wall without what it carries, by the order of the case, and of each span.
struct Weights {
  double all = 0.0;
  std::vector<double> wall, floor, roof;
};

Weights weights_of(const cases::Case& c, const cases::Model& m) {
  Weights w{0.0, std::vector<double>(c.walls.size()), std::vector<double>(c.floors.size()), std::vector<double>(c.roofs.size())};
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    const cases::Block& b = m.blocks[i];
    const double weight = kGravity * m.assembly.elements[i].mass.volume * m.materials[static_cast<std::size_t>(b.material)].value.density;
    w.all += weight;
    std::vector<double>& of = b.wall >= 0 ? w.wall : b.kind == cases::PartKind::floor_beam ? w.floor : w.roof;
    of.at(static_cast<std::size_t>(std::max(b.wall, b.span))) += weight;
  }
  return w;
}

void check_all_arrives(const Support& s, double weight) {
  CHECK(std::abs(s.base.z) == doctest::Approx(weight).epsilon(1e-4));
  CHECK(std::hypot(s.base.x, s.base.y) < 1e-4 * weight);
}

/// The share of a beam's weight that one of its two walls carries, for the reaction may be anywhere on its seats.
constexpr double most_of(double clear) { return (0.5 * clear + kBearing) / (clear + kBearing); }

}  // namespace

TEST_CASE("at rest the weight of walls and floors reaches the base, and a floor loads its two walls by half each") {
  const cases::Case c = three_walls();
  const cases::Model m = cases::build_model(c);
  const Weights w = weights_of(c, m);
  // By hand: 2 beams of 0.1 x 0.2 m every 0.5 m, 60 and 300 kg/m2
  CHECK(w.floor[0] == doctest::Approx(2 * (kSpan + 2 * kBearing) * kGravity * (700.0 * 0.02 + 60.0 * 0.5)).epsilon(1e-9));
  CHECK(w.floor[1] == doctest::Approx(2 * (1.2 + 2 * kBearing) * kGravity * (700.0 * 0.02 + 300.0 * 0.5)).epsilon(1e-9));
  const Support s = at_rest(c, m, {"a", "b", "c"});
  check_all_arrives(s, w.all);
  REQUIRE(s.under.size() == 3);
  CHECK(s.under[0] + s.under[1] + s.under[2] == doctest::Approx(w.all).epsilon(1e-4));
  const double light = (s.under[0] - w.wall[0]) / w.floor[0], heavy = (s.under[2] - w.wall[2]) / w.floor[1];
  CAPTURE(light);
  CAPTURE(heavy);
  for (const auto& [share, clear] : {std::pair{light, kSpan}, {heavy, 1.2}}) {
    CHECK(share < most_of(clear));
    CHECK(share > 1.0 - most_of(clear));
    CHECK(share == doctest::Approx(0.5).epsilon(0.02));
  }
}

TEST_CASE("the forces under walls are the same wherever they stand: moved, turned, mirrored, in another order") {
  const cases::Case here = three_walls();
  const Support wanted = at_rest(here, cases::build_model(here), {"a", "b", "c"});
  const auto check = [&](const cases::Case& there, const char* how) {
    CAPTURE(how);
    const Support s = at_rest(there, cases::build_model(there), {"a", "b", "c"});
    for (std::size_t i = 0; i < 3; ++i) CHECK(s.under[i] == doctest::Approx(wanted.under[i]).epsilon(1e-5));
  };
  check(moved(here, 0.0, false), "moved");
  check(moved(here, std::numbers::pi, false), "turned by half");
  check(moved(here, 0.6, false), "turned by an odd angle");
  check(moved(here, 0.0, true), "mirrored");
  cases::Case other = here;
  std::ranges::reverse(other.walls);
  check(other, "walls in another order");
  other = here;
  std::ranges::reverse(other.floors);
  check(other, "floors in another order");
}

TEST_CASE("at rest a tied roof with a gable, on a room with a floor, weighs what it weighs, and half of it on either wall without gables") {
  cases::Case c = case_of({wall("a", {{-0.6, 0.0}, {0.6, 0.0}}, 0.3, 0.6, cases::WallBond::through),
                           wall("b", {{-0.6, 2.0}, {0.6, 2.0}}, 0.3, 0.6, cases::WallBond::through)});
  c.analysis.kind = cases::AnalysisKind::rest;
  c.analysis.tolerance = 1e-6;
  c.roofs = {roof_between("roof", {"a", "b"}, {})};
  cases::Roof& rafters = c.roofs[0].rafters;
  rafters.element = 0.5, rafters.surcharge = 50.0, rafters.spacing = 0.6;
  rafters.tie = cases::Tie{};
  rafters.tie->area = 1e-3, rafters.tie->young = 1e10, rafters.tie->compression = true;
  {
    const cases::Model m = cases::build_model(c);
    const Weights w = weights_of(c, m);
    const Support s = at_rest(c, m, {"a", "b"});
    check_all_arrives(s, w.all);
    for (std::size_t i = 0; i < 2; ++i) CHECK((s.under[i] - w.wall[i]) / w.roof[0] == doctest::Approx(0.5).epsilon(1e-3));
  }
  c.walls.push_back(wall("gable", {{-0.45, 0.0}, {-0.45, 2.0}}, 0.3, 0.6));
  c.roofs[0].gables = {"gable"};
  c.floors = {floor_between("floor", {"a", "b"})};
  c.floors[0].beams.bearing = kBearing, c.floors[0].within_member = "wood", c.floors[0].beams.load = 100.0;
  const cases::Model m = cases::build_model(c);
  check_all_arrives(at_rest(c, m, {}), weights_of(c, m).all);
}

}  // namespace voussoir::testing
