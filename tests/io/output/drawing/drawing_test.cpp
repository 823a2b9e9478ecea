// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/drawing/drawing.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "cases/model.h"
#include "io/output/drawing/wall_dimensions.h"
#include "io/output/report/vtu_file.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/walls/plan_walls.h"

using namespace voussoir;

namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Two bricks, one on the other.
cases::Case two_bricks() {
  cases::Case c = testing::paper_materials();
  c.base = cases::Base{};
  for (const double z : {0.0, 0.1}) {
    cases::BlockSpec block;
    block.name = z == 0.0 ? "lower" : "upper", block.material = "adobe";
    block.box = {Vec3{0.0, 0.0, z}, Vec3{0.2, 0.1, z + 0.1}};
    c.blocks.push_back(block);
  }
  return c;
}

}  // namespace

TEST_CASE("a drawing has every face that can be seen, a section, a legend and the named elements") {
  cases::Case c = two_bricks();
  c.title = "a < b & c";
  c.output.history = {{"top brick", {0.1, 0.05, 0.15}}};
  const std::string svg = io::draw(c, cases::build_model(c));
  CHECK(svg.starts_with("<svg"));
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(count(svg, "<path") == 4 * 2 + 1 + 1);  // two faces an elevation, one brick in the section, one patch in the legend
  CHECK(count(svg, "a &lt; b &amp; c") == 1);
  CHECK(count(svg, ">top brick<") == 4 + 1);  // no wall hides it
  for (const char* view : {"front, 0.20 x 0.20 m", "rear,", "left, 0.10 x 0.20 m", "right,", "plan at z = 0.10 m"})
    CHECK(count(svg, view) == 1);
}

TEST_CASE("a house's plans lie in two courses that meet its openings, and its hidden faces are not drawn") {
  const cases::Case c = testing::paper_vault20();
  const cases::Model model = cases::build_model(c);
  const std::string svg = io::draw(c, model);
  CHECK(count(svg, "plan at z = 1.45 m") == 1);
  CHECK(count(svg, "plan at z = 1.55 m") == 1);
  CHECK(count(svg, "voussoir: 675") == 1);
  CHECK(count(svg, "<path") < static_cast<int>(model.assembly.patches.size()) + 1000);
  CHECK(count(svg, ">element1<") == 1 + 2);               // in the left elevation and both plans
  CHECK(count(svg, "#d62828") + count(svg, "red") == 0);  // which is for cracks
}

TEST_CASE("a pier does not count as the face behind which walls are dark and unnamed") {
  cases::Case c = testing::paper_flat20();
  c.house->piers = {cases::Pier{"front", 2.6, 0.3, 0.6, 1.6}};
  const std::string svg = io::draw(c, cases::build_model(c));
  CHECK(count(svg, ">element2<") == 1 + 2);  // in the front elevation and both plans
}

TEST_CASE("the legend calls the stones of a house of rubble so") {
  cases::Case c = testing::paper_flat20();
  CHECK(count(io::draw(c, cases::build_model(c)), "stone of rubble") == 0);
  c.house->bond = cases::Bond::rubble;
  const std::string svg = io::draw(c, cases::build_model(c));
  CHECK(count(svg, ">stone of rubble: ") == 1);
  CHECK(count(svg, ">brick: ") == 0);
}

TEST_CASE("a drawing says how large openings are, how thick walls, which way the axes go and how long a metre is") {
  const cases::Case c = testing::paper_vault20();
  const std::string svg = io::draw(c, cases::build_model(c));
  REQUIRE(c.house);
  for (const cases::Opening& o : c.house->openings) {
    std::array<char, 24> words{};
    std::snprintf(words.data(), words.size(), ">%.2f<", o.width);
    CHECK(count(svg, words.data()) >= 2);  // in the opening and among the pieces of its wall
    std::snprintf(words.data(), words.size(), ">%.2f<", o.height);
    CHECK(count(svg, words.data()) >= 1);
  }
  CHECK(count(svg, ">0.20<") >= 4);  // two walls in two plans
  CHECK(count(svg, ">x<") == 4);     // front, rear and two plans
  CHECK(count(svg, ">z<") == 4);
  CHECK(count(svg, ">1 m<") == 1);
}

TEST_CASE("mode shapes: vertices move with their element") {
  const cases::Model model = cases::build_model(two_bricks());
  solver::Mode mode;
  mode.frequency = 2.5;
  mode.displacement = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  mode.rotation = {{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}};
  const std::string vtu = io::mode_shapes_vtu(model, std::vector{mode});
  CHECK(count(vtu, "NumberOfPoints=\"16\" NumberOfCells=\"2\"") == 1);
  CHECK(count(vtu, "Name=\"mode 1 (2.500 Hz)\"") == 1);
  CHECK(count(vtu, "8 16 </DataArray>") == 1);
  // u + theta x r at the first corner of the upper brick, r = (-0.1, -0.05, -0.05): (1 + 2 * 0.05, -2 * 0.1, 0)
  CHECK(count(vtu, "1.1 -0.2 0 \n") >= 1);
}

TEST_CASE("walls of any plan have plans through all their openings, with the names, lengths and openings of their sides") {
  cases::Case c = testing::case_of({testing::closed(testing::wall("outer", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.4, 5.0)),
                                    testing::wall("inner", {{2.5, 0.0}, {2.5, 4.0}}, 0.2, 5.0)});
  c.walls[0].line = cases::WallLine::right;
  // A door and a window that one height meets, and a window above them; a door of the inner wall, which the outer ones hide.
  c.walls[0].openings = {{1.0, 1.1, 0.0, 2.1, {}, {}}, {6.3, 0.9, 0.8, 1.2, {}, {}}, {3.2, 0.7, 3.3, 1.3, {}, {}}};
  c.walls[1].openings = {{1.6, 0.85, 0.0, 1.95, {}, {}}};
  const std::vector<cases::WallOutline> walls = cases::wall_outlines(c.walls, {});
  const std::vector<double> heights = io::plan_heights(walls, 6);
  REQUIRE(heights.size() == 2);
  CHECK(heights[0] > 0.8);
  CHECK(heights[0] < 1.95);
  CHECK(heights[1] > 3.3);
  CHECK(heights[1] < 4.6);
  CHECK(io::plan_heights(walls, 1).size() == 1);
  CHECK(io::plan_heights(cases::wall_outlines({c.walls[0]}, {}), 6).size() == 2);
  const std::string svg = io::draw(c, cases::build_model(c));
  CHECK(count(svg, ">outer 2, 0.40<") == 2);
  CHECK(count(svg, ">inner, 0.20<") == 2);
  CHECK(count(svg, ">2.90<") == 1);  // of the first side: 1.00, 1.10 and 2.90 m below, 3.20, 0.70 and 1.10 m above
  CHECK(count(svg, ">3.20<") == 1);
  CHECK(count(svg, ">0.85<") == 1);  // the inner door in plan alone
  CHECK(count(svg, ">1.95<") == 0);
  CHECK(count(svg, ">0.90<") == 2);  // the window in plan and in the elevation of its side
}

TEST_CASE("walls without openings have one plan, and a round one its name alone") {
  cases::WallSpec ring = testing::closed(testing::wall("ring", {}, 0.4, 1.0, cases::WallBond::through));
  for (int i = 0; i < 24; ++i) ring.points.push_back({2.0 * std::cos(i * 3.14159265 / 12.0), 2.0 * std::sin(i * 3.14159265 / 12.0)});
  ring.brick = {0.8, 0.4, 0.25};
  const cases::Case c = testing::case_of({ring});
  const std::vector<double> heights = io::plan_heights(cases::wall_outlines(c.walls, {}), 6);
  REQUIRE(heights.size() == 1);
  CHECK(heights[0] == doctest::Approx(0.5));
  const std::string svg = io::draw(c, cases::build_model(c));
  CHECK(count(svg, ">ring, 0.40<") == 1);
  CHECK(count(svg, ">0.52<") == 0);  // no lengths of its straight parts
}

TEST_CASE("vaults between walls are drawn from above and in two sections each") {
  cases::WallSpec walls = testing::closed(testing::wall("room", {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}}, 0.5, 2.0));
  walls.line = cases::WallLine::right;
  cases::Case c = testing::case_of({walls});
  const std::string without = io::draw(c, cases::build_model(c));
  CHECK(count(without, "from above") + count(without, "section at") == 0);
  cases::WallVault vault;
  vault.name = "vault", vault.kind = cases::VaultKind::pavilion, vault.material = "adobe";
  vault.walls = {"room 1", "room 2", "room 3", "room 4"}, vault.thickness = 0.25, vault.ring = 0.5, vault.voussoirs = 5;
  c.vaults = {vault};
  const cases::Model m = cases::build_model(c);
  const std::string svg = io::draw(c, m);
  CHECK(count(svg, ">vault from above<") == 1);
  CHECK(count(svg, ">section at y = 2.00 m, seen from the front<") == 1);
  CHECK(count(svg, ">section at x = 2.50 m, seen from the left<") == 1);
}
