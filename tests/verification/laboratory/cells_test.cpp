// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/fixture.h"

// V5: a unit in cells is as stiff and as heavy as one piece, splits at its tensile strength, and breaks in bending at its modulus of
// rupture.
namespace voussoir::testing {
namespace {

cases::JointLaw never_breaks() { return {.tension = 1e12, .cohesion = 1e12, .friction = 30.0, .compression = 1e12}; }

/// A case without gravity of one block of adobe in cells, whose own law never breaks.
cases::Case of_one_block(std::array<Vec3, 2> box, cases::CellCounts cells, double segment) {
  cases::Case c;
  c.gravity.acceleration = {0.0, 0.0, 0.0};
  c.materials["adobe"] = {Adobe::density, Adobe::young, Adobe::poisson, "own"};
  c.joint_laws["own"] = c.joint_laws["glue"] = never_breaks();
  c.joints.default_law = "glue";
  c.segment_size = segment;
  cases::BlockSpec unit;
  unit.name = "unit", unit.material = "adobe", unit.cells = cells, unit.box = box;
  c.blocks = {unit};
  return c;
}

/// Adds a force on all cells of the top layer, each with its share.
void load_top(cases::Case& c, Vec3 force, double ramp) {
  const cases::CellCounts n = *c.blocks[0].cells;
  const int layer = n[0] * n[1];
  for (int i = 1; i <= layer; ++i) {
    cases::Load load;
    load.block = "unit/" + std::to_string(layer * (n[2] - 1) + i);
    load.force = (1.0 / layer) * force, load.ramp = {0.0, ramp};
    c.loads.push_back(load);
  }
}

constexpr double kLength = 2.0, kSide = 0.2;  // m, of a column

cases::Case column(cases::CellCounts cells) {
  cases::Case c = of_one_block({Vec3{-0.5 * kSide, -0.5 * kSide, 0.0}, Vec3{0.5 * kSide, 0.5 * kSide, kLength}}, cells, 0.05);
  c.base = cases::Base{};
  return c;
}

/// Mean displacement of the top layer [m] at rest.
Vec3 top_at_rest(cases::Case c, double alpha, double end) {
  c.damping.alpha = alpha, c.time.duration = end;
  const cases::CellCounts n = *c.blocks[0].cells;
  const auto layer = static_cast<std::size_t>(n[0] * n[1]);
  Run run(std::move(c));
  run.until(run.description().time.duration);
  Vec3 sum;
  for (std::size_t i = run.count() - layer; i < run.count(); ++i) sum += run.displacement(i);
  return sum / static_cast<double>(layer);
}

std::string text_of(const cases::CellCounts& n) {
  return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

}  // namespace

TEST_CASE("V5: a column of one unit in cells has the axial stiffness of the chain of its layers") {
  for (const cases::CellCounts n : {cases::CellCounts{1, 1, 10}, {2, 2, 10}, {4, 1, 5}}) {
    cases::Case c = column(n);
    load_top(c, {0.0, 0.0, 1000.0}, 0.1);
    const double expected = 1000.0 * (kLength - 0.5 * kLength / n[2]) / (Adobe::plane * kSide * kSide);
    expect_near("V5 column in " + text_of(n) + " cells, u of the top layer [m]", top_at_rest(c, 320.0, 0.4).z, expected, 1e-4);
  }
}

// Cut across the axis the column is the chain of V2. Cut along it, too, its halves slip on each other: V Q/I_n in each of their points,
// with Q/I_n = 1.6/b for four rows, makes 1.28 V L/(G A) more, less what the base and the free top hold of it.
TEST_CASE("V5: a column of one unit in cells under a transverse load") {
  for (const cases::CellCounts n : {cases::CellCounts{1, 1, 10}, {1, 2, 10}, {2, 1, 10}, {2, 2, 10}}) {
    cases::Case c = column(n);
    load_top(c, {0.1, 0.0, 0.0}, 1.0);
    const double a = kLength / n[2], area = kSide * kSide, inertia = area * area / 12.0 * (1.0 - 1.0 / 16.0);
    double bending = 0.0, shear = 0.0;  // m, of the top layer's centroid, by the joints below it
    for (int i = 0; i < n[2]; ++i) {
      const double arm = kLength - 0.5 * a - i * a, length = i == 0 ? 0.5 * a : a;
      bending += 0.1 * length * arm * arm / (Adobe::plane * inertia), shear += 0.1 * length / (Adobe::shear * area);
    }
    const double got = top_at_rest(c, 23.4, 3.0).x;
    if (n[0] == 1)
      expect_near("V5 column in " + text_of(n) + " cells, deflection of the top layer [m]", got, bending + shear, 1e-4);
    else
      expect_near("V5 column in " + text_of(n) + " cells, slip of its halves over V L/(G A)", (got - bending) / shear - 1.0, 1.28, 0.05);
  }
}

// Each joint carries the shear stress and slips by τ a/G, those along either axis: the strain of the whole is twice τ/G.
TEST_CASE("V5: a unit in cells in pure shear") {
  constexpr int kCells = 4;
  const double edge = 0.2, thickness = 0.1, a = edge / kCells, stress = 1000.0, force = stress * a * thickness;
  cases::Case c = of_one_block({Vec3{0.0, 0.0, 0.0}, Vec3{edge, thickness, edge}}, {kCells, 1, kCells}, 0.025);
  c.blocks[0].free = true;
  for (int i = 0; i < kCells; ++i) {
    const double at = (i + 0.5) * a, middle = 0.5 * thickness;
    const auto push = [&](Vec3 point, Vec3 direction) {
      cases::Load load;
      load.block = "unit", load.at = point, load.force = force * direction, load.ramp = {0.0, 0.1};
      c.loads.push_back(load);
    };
    push({at, middle, edge}, {1.0, 0.0, 0.0}), push({at, middle, 0.0}, {-1.0, 0.0, 0.0});
    push({edge, middle, at}, {0.0, 0.0, 1.0}), push({0.0, middle, at}, {0.0, 0.0, -1.0});
  }
  c.damping.alpha = 1000.0, c.time.duration = 0.3;
  Run run(std::move(c));
  run.until(run.description().time.duration);
  const double along = run.displacement(kCells * (kCells - 1)).x - run.displacement(0).x;  // from the lowest row to the highest
  const double across = run.displacement(kCells - 1).z - run.displacement(0).z;
  const double strain = (along + across) / (edge - a);
  expect_near("V5 unit in cells in pure shear, strain", strain, 2.0 * stress / Adobe::shear, 1e-4);
}

namespace {

/// A unit of 0.2 m in cells that hangs along x from a fixed block by a bed that never fails: whether it has parted under gravity.
bool splits(const cases::CellCounts& n, double strength, double gravity) {
  cases::Case c = of_one_block({Vec3{0.0, 0.0, 0.0}, Vec3{0.2, 0.1, 0.1}}, n, 0.025);
  c.gravity.acceleration = {gravity, 0.0, 0.0};
  c.gravity.ramp = 0.2;
  c.joint_laws["own"] = {.tension = strength, .cohesion = 1e9, .friction = 30.0, .compression = 1e12};
  cases::BlockSpec wall;
  wall.name = "wall", wall.material = "adobe", wall.fixed = true;
  wall.box = {{Vec3{-0.1, 0.0, 0.0}, Vec3{0.0, 0.1, 0.1}}};
  c.blocks.push_back(wall);
  Run run(c);
  return !run.settle();
}

/// Pa: the least strength that holds, by bisection about the expected one.
template <class Fails>
double least_strength(double expected, const Fails& fails) {
  double low = 0.8 * expected, high = 1.25 * expected;
  for (int i = 0; i < 8; ++i) {
    const double middle = std::sqrt(low * high);
    (fails(middle) ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

TEST_CASE("V5: a unit in cells splits at its tensile strength, in the section that bears most") {
  const double gravity = 50.0;
  for (const cases::CellCounts n : {cases::CellCounts{2, 1, 1}, {2, 2, 2}, {4, 1, 2}}) {
    const double stress = Adobe::density * gravity * 0.2 * (1.0 - 1.0 / n[0]);  // behind the cells next to the bed
    expect_near("V5 unit in " + text_of(n) + " cells, hung by one end: stress at which it splits [Pa]",
                least_strength(stress, [&](double f) { return splits(n, f, gravity); }), stress, 1e-2);
  }
}

namespace {

constexpr double kSpan = 0.2, kWidth = 0.1, kHeight = 0.06;  // m, of a unit in three-point bending

/// A unit of 0.24 m on two narrow supports, loaded from above in its middle: whether its middle has cracked.
bool breaks(const cases::CellCounts& n, geometry::SegmentRule rule, double strength, double force) {
  constexpr double kNarrow = 0.002;
  cases::Case c = of_one_block({Vec3{-0.12, 0.0, 0.0}, Vec3{0.12, kWidth, kHeight}}, n, 0.015);
  c.segment_rule = rule;
  c.joint_laws["own"] = {.tension = strength, .cohesion = 1e9, .friction = 30.0, .compression = 1e12};
  c.joints.default_law = "dry";
  c.contact.friction = 0.0;  // a thrust of the supports would bend it back
  for (const double x : {-0.5 * kSpan, 0.5 * kSpan}) {
    cases::BlockSpec support;
    support.name = x < 0.0 ? "left" : "right", support.material = "adobe", support.fixed = true;
    support.box = {{Vec3{x - 0.5 * kNarrow, 0.0, -0.05}, Vec3{x + 0.5 * kNarrow, kWidth, 0.0}}};
    c.blocks.push_back(support);
  }
  for (int i = 0; i < n[1]; ++i) {  // on all cells across it
    cases::Load load;
    load.block = "unit", load.at = Vec3{0.0, (i + 0.5) / n[1] * kWidth, kHeight}, load.force = {0.0, 0.0, -force / n[1]};
    load.ramp = {0.0, 0.1};
    c.loads.push_back(load);
  }
  c.damping.alpha = 200.0, c.time.duration = 0.15;
  Run run(std::move(c));
  run.until(run.description().time.duration);
  return run.sim().damage().tension > 0;
}

}  // namespace

// M = F l/4 in the middle; four rows of springs at the centres of equal parts break at f_t W (1 + 1/4), those up to the rim at f_t W.
TEST_CASE("V5: a unit in cells on two supports breaks at its modulus of rupture") {
  const double force = 200.0, stress = force * kSpan / 4.0 / (kWidth * kHeight * kHeight / 6.0);
  const auto centres = geometry::SegmentRule::centres, rim = geometry::SegmentRule::rim;
  for (const cases::CellCounts n : {cases::CellCounts{2, 1, 1}, {2, 2, 1}, {4, 1, 1}}) {
    expect_near("V5 unit in " + text_of(n) + " cells, three-point bending, n = 4: strength at which it breaks [Pa]",
                least_strength(stress / 1.25, [&](double f) { return breaks(n, centres, f, force); }), stress / 1.25, 2e-2);
    expect_near("V5 unit in " + text_of(n) + " cells, three-point bending, points to the rim: strength at which it breaks [Pa]",
                least_strength(stress, [&](double f) { return breaks(n, rim, f, force); }), stress, 2e-2);
  }
}

}  // namespace voussoir::testing
