// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/census.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/cases/paper_house.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

/// Surface of a house that touches nothing, m2, from its plan alone. Every brick joined to all its neighbours leaves exactly this free.
double open_surface(const House& h) {
  const double x = h.inner_size[0], y = h.inner_size[1], tb = h.bearing_wall, tn = h.nonbearing_wall;
  const double outer_x = x + 2 * tn, outer_y = y + 2 * tb;
  const double seat = std::min(tb, h.brick[0]);
  double tops = 2 * outer_x * tb + 2 * y * tn;
  double under_roof = 2 * outer_x * seat + 2 * y * tn;
  double area = 2 * (outer_x + outer_y + x + y) * h.height;
  for (const Opening& o : h.openings) {
    const bool bearing = o.wall == "front" || o.wall == "rear";
    const double thickness = bearing ? tb : tn;
    const bool at_top = std::abs(o.sill + o.height - h.height) < 1e-9;
    area += 2 * o.height * thickness - 2 * o.width * o.height;  // jambs, less the two faces
    if (o.sill > 0.0) area += o.width * thickness;
    if (!at_top) area += o.width * thickness;
    if (at_top) tops -= o.width * thickness;
    if (at_top) under_roof -= o.width * (bearing ? seat : tn);
  }
  if (h.roof.kind == RoofKind::none) return area + tops;
  const double span = y + 2 * seat;
  return area + tops + 2 * outer_x * span + 2 * (outer_x + span) * h.roof.beam[1] - 2 * under_roof;
}

double free_area(const geometry::Assembly& a) {
  double area = 0.0;
  for (const geometry::FreePatch& p : a.patches) {
    for (const geometry::Segment& s : p.segments) area += s.area;
  }
  return area;
}

double face_area(const geometry::Assembly& a) {
  return std::accumulate(a.faces.begin(), a.faces.end(), 0.0, [](double sum, const geometry::Face& f) { return sum + f.area; });
}

/// Area in joints counted from both elements, the base from one.
double joined_area(const geometry::Assembly& a) {
  return std::accumulate(a.joints.begin(), a.joints.end(), 0.0,
                         [](double sum, const geometry::Joint& j) { return sum + j.area * (j.element_b == geometry::kBase ? 1 : 2); });
}

void check_all_neighbours_joined(const Case& c) {
  const Model model = build_model(c);
  const double open = c.house->copies[0] * c.house->copies[1] * open_surface(*c.house);
  CHECK(std::abs((joined_area(model.assembly) + open) / face_area(model.assembly) - 1.0) < 1e-9);
  CHECK(std::abs(free_area(model.assembly) / open - 1.0) < 1e-5);  // free slivers under 1 % of a cell are dropped
}

Case with_bond(Case c, Bond bond) {
  c.house->bond = bond;
  return c;
}

double pick(std::mt19937& random, double low, double high, double step) {
  const int n = static_cast<int>(std::lround((high - low) / step));
  return low + step * std::uniform_int_distribution<int>(0, n)(random);
}

bool one_in(std::mt19937& random, int n) { return std::uniform_int_distribution<int>(1, n)(random) == 1; }

Opening random_opening(std::mt19937& random, const House& h) {
  const char* walls[] = {"front", "rear", "left", "right"};
  const double step = one_in(random, 3) ? 0.01 : 0.05;
  Opening o = opening(walls[std::uniform_int_distribution<int>(0, 3)(random)], pick(random, 0.1, 1.5, step), pick(random, 0.1, 0.8, step),
                      pick(random, 0.0, 0.5, 0.1), pick(random, 0.1, 0.8, 0.1));
  if (one_in(random, 2))
    o.lintel = Lintel{o.width + pick(random, 0.0, 0.6, step), pick(random, 0.1, 0.2, 0.1), pick(random, 0.1, 0.3, 0.05)};
  if (one_in(random, 6)) o.height = h.height - o.sill;
  return o;
}

Case random_case(std::mt19937& random) {
  Case c = testing::paper_flat20();
  House& h = *c.house;
  h.openings.clear();
  h.bond = one_in(random, 2) ? Bond::english : Bond::running;
  const double step = one_in(random, 3) ? 0.013 : 0.1;
  h.inner_size = {pick(random, 0.4, 2.0, step), pick(random, 0.4, 1.6, step)};
  h.height = pick(random, 0.3, 1.0, 0.1);
  h.bearing_wall = pick(random, 0.1, 0.5, 0.1);
  h.nonbearing_wall = pick(random, 0.1, 0.4, 0.1);
  if (one_in(random, 4)) h.brick = {0.24, 0.12, 0.08}, h.bearing_wall = 0.24, h.nonbearing_wall = 0.12, h.height = 0.64;
  if (h.bond == Bond::running && one_in(random, 4)) h.brick[0] = 0.3;
  h.roof.kind = one_in(random, 2) ? RoofKind::flat : RoofKind::none;
  h.roof.beam = {pick(random, 0.1, 0.3, 0.05), pick(random, 0.1, 0.2, 0.05)};
  h.roof.element = pick(random, 0.15, 0.3, 0.05);
  h.turn = 90.0 * std::uniform_int_distribution<int>(0, 3)(random);
  h.origin = {pick(random, -3.0, 3.0, 0.1), pick(random, -3.0, 3.0, 0.01)};
  if (one_in(random, 4)) h.copies = {2, 1};
  for (int i = std::uniform_int_distribution<int>(0, 2)(random); i > 0; --i) h.openings.push_back(random_opening(random, h));
  c.base->z = one_in(random, 5) ? 1.3 : 0.0;
  return c;
}

}  // namespace

TEST_CASE("the paper's flat houses have the sizes to expect") {
  const Census english20 = census(build_model(testing::paper_flat20()));
  CHECK(english20.elements == doctest::Approx(4200).epsilon(0.05));
  CHECK(english20.mass == doctest::Approx(1800.0 * (11.056 - 3.672 - 0.056) + 700.0 * (3.672 + 0.056)).epsilon(1e-9));
  CHECK(english20.volume == doctest::Approx((2 * 5.4 + 2 * 3.0) * 0.2 * 2.4 - (1.2 * 2.0 + 1.0) * 0.2 + 5.4 * 3.4 * 0.2).epsilon(1e-9));
  const Census english40 = census(build_model(testing::paper_flat40()));
  CHECK(english40.elements == doctest::Approx(6500).epsilon(0.05));
  CHECK(english40.mass == doctest::Approx(24000).epsilon(0.05));
  // An independent program counted 4 265 elements and 14 024 joints, those with the base among them, in running bond.
  const Census running20 = census(build_model(with_bond(testing::paper_flat20(), Bond::running)));
  CHECK(running20.elements == 4265);
  CHECK(running20.joints + running20.base_joints == 14024);
}

TEST_CASE("segment sides: those of an independent program, which cut all faces at 0.025 m and gave the base a side of its own") {
  const auto sides = [](Case c) {
    c.segment_size = 0.025;
    const Model model = build_model(c);
    std::int64_t base = 0;
    for (const geometry::Joint& j : model.assembly.joints)
      base += j.element_b == geometry::kBase ? static_cast<std::int64_t>(j.side_a.size()) : 0;
    return static_cast<double>(census(model).joint_sides + base);
  };
  CHECK(sides(with_bond(testing::paper_flat20(), Bond::running)) == doctest::Approx(595000).epsilon(0.001));
  CHECK(sides(testing::paper_flat20()) == doctest::Approx(595000).epsilon(0.05));
  CHECK(sides(testing::paper_flat40()) == doctest::Approx(970000).epsilon(0.05));
}

TEST_CASE("segments of a house are its areas over the area of a cell") {
  const Census c = census(build_model(testing::paper_flat20()));
  CHECK(c.faces == 6 * c.elements);
  // All cells lie on one grid of 0.025 m, those of the roof beams on one of 0.05 m, so no cell is cut.
  const double fine = 0.025 * 0.025, coarse = 0.05 * 0.05;
  const double base = (2 * 5.4 + 2 * 3.0 - 1.2) * 0.2;
  const double roof_on_walls = (2 * 5.4 + 2 * 3.0) * 0.2;
  const double in_roof = 26 * 3.4 * 0.2 + 27 * 16 * 0.2 * 0.2;
  const double in_walls = c.joint_area - base - roof_on_walls - in_roof;
  CHECK(c.joint_sides == std::lround(2 * in_walls / fine + 2 * in_roof / coarse + roof_on_walls * (1 / fine + 1 / coarse) + base / fine));
  const double free_roof = 2 * 5.4 * 3.4 + 2 * (5.4 + 3.4) * 0.2 - roof_on_walls;
  const double free_walls = open_surface(*testing::paper_flat20().house) - free_roof;
  CHECK(c.free_segments == std::lround(free_walls / fine + free_roof / coarse));
}

TEST_CASE("the time step bound of Eq. 19 is the paper's, from the half-height of a lintel") {
  CHECK(step_bound({700.0, 6.3e8, 0.3}, 0.05) == doctest::Approx(0.05 / std::sqrt(6.3e8 / (1 - 0.09) / 700.0)).scale(0.0));
  for (const Case& c : {testing::paper_flat20(), testing::paper_flat40(), with_bond(testing::paper_flat20(), Bond::running)}) {
    const Model model = build_model(c);
    const Census result = census(model);
    CHECK(result.step_bound == doctest::Approx(5.03e-5).epsilon(0.001).scale(0.0));
    const Block& limiting = model.blocks[static_cast<std::size_t>(result.step_element)];
    CHECK(limiting.kind == PartKind::lintel);
    const geometry::Element& element = model.assembly.elements[static_cast<std::size_t>(result.step_element)];
    CHECK(std::abs(model.assembly.faces[static_cast<std::size_t>(element.first_face + result.step_face)].normal.z) == doctest::Approx(1.0));
  }
}

TEST_CASE("groups and the bill of blocks add up") {
  const Model model = build_model(testing::paper_flat40());
  const Census c = census(model);
  REQUIRE(c.groups.size() == 6);
  CHECK(c.groups[0].name == "front wall");
  CHECK(c.groups.back().name == "roof beam");
  CHECK(c.groups.back().whole == 27 * 17);
  std::int64_t blocks = 0;
  double mass = 0.0;
  for (const CensusGroup& g : c.groups) {
    blocks += g.whole + g.cut;
    mass += g.mass;
  }
  CHECK(blocks == c.elements);
  CHECK(mass == doctest::Approx(c.mass).epsilon(1e-12));

  double volume = 0.0;
  blocks = 0;
  for (const BillLine& line : c.bill) blocks += line.count, volume += line.volume;
  CHECK(blocks == c.elements);
  CHECK(volume == doctest::Approx(c.volume).epsilon(1e-12));
  const BillLine& beams = c.bill.back();
  CHECK(beams.kind == PartKind::beam);
  CHECK(beams.whole);
  CHECK(beams.count == 27 * 17);
  CHECK(beams.volume == doctest::Approx(27 * 17 * 0.2 * 0.2 * 0.2).epsilon(1e-12));
}

TEST_CASE("fixed blocks count apart and do not limit the step") {
  Case c = testing::paper_materials();
  BlockSpec block;
  block.name = "slab", block.material = "wood", block.fixed = true;
  block.box = {Vec3{0, 0, 0}, Vec3{1, 1, 0.02}};
  c.blocks = {block};
  CHECK(census(build_model(c)).step_bound == std::numeric_limits<double>::infinity());
  block.name = "brick", block.material = "adobe", block.fixed = false;
  block.box = {Vec3{0, 0, 0.02}, Vec3{0.2, 0.1, 0.12}};
  c.blocks.push_back(block);
  const Census result = census(build_model(c));
  CHECK(result.fixed_mass == doctest::Approx(14.0));
  CHECK(result.mass == doctest::Approx(3.6));
  CHECK(result.step_element == 1);
  CHECK(result.groups[1].name == "blocks of adobe");
}

TEST_CASE("every brick is joined to all that it touches") {
  for (const Bond bond : {Bond::english, Bond::running}) {
    Case c = with_bond(testing::paper_flat20(), bond);
    check_all_neighbours_joined(c);
    check_all_neighbours_joined(with_bond(testing::paper_flat40(), bond));
    c.house->openings.clear();
    c.house->roof.kind = RoofKind::none;
    check_all_neighbours_joined(c);
  }
}

TEST_CASE("a turned house has the same census") {
  Case c = testing::paper_flat40();
  const Census straight = census(build_model(c));
  c.house->turn = 90.0;
  const Census turned = census(build_model(c));
  CHECK(turned.joints == straight.joints);
  CHECK(turned.merged_joints == straight.merged_joints);
  CHECK(turned.joint_sides == straight.joint_sides);
  CHECK(turned.free_segments == straight.free_segments);
  CHECK(turned.mass == doctest::Approx(straight.mass).epsilon(1e-12));
}

TEST_CASE("any house is built whole or refused") {
  std::mt19937 random(20260117);
  int built = 0, refused = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const Case c = random_case(random);
    try {
      build_model(c);
    } catch (const InputError& e) {
      CHECK(e.key().substr(0, 5) == "house");
      CHECK(e.key() != "house");  // never a fault of geometry: every refusal names a key of the house
      ++refused;
      continue;
    }
    check_all_neighbours_joined(c);
    ++built;
  }
  CHECK(built > 80);
  CHECK(refused > 80);
}

TEST_CASE("frames of large models lie farther apart, unless the case says how far") {
  Case c;
  c.time.duration = 10.0;
  CHECK(frame_interval(c, 4'263) == 0.02);
  CHECK(frame_interval(c, 79'840) == 0.02);  // times 501 frames: just below 40 million
  CHECK(frame_interval(c, 79'841) == 0.05);
  CHECK(frame_interval(c, 300'000) == 0.1);
  CHECK(frame_interval(c, 1'065'750) == 0.5);
  CHECK(frame_interval(c, 1'000'000'000) == 1.0);  // a tenth of the duration
  c.time.duration = 0.0;
  CHECK(frame_interval(c, 1'000'000'000) == 0.02);
  c.time.duration = 10.0;
  c.output.frame_interval = 0.02;
  CHECK(frame_interval(c, 1'065'750) == 0.02);
  c.output.frame_interval.reset();
  c.analysis.kind = AnalysisKind::pushover;
  CHECK(frame_interval(c, 1'065'750) == 0.02);
}
