// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/slow_loading/assessment.h"

// V15 at rest: work put in is what is stored and lost, at every state of rest, also where joints come apart, bodies meet as a whole, or a
// structure falls into a heap. What relaxation takes is one of the losses.
namespace voussoir::testing {
namespace {

using cases::AnalysisKind;

constexpr double kEnergy = 1e-3;

/// Of the energy that is turned over: of work and losses the larger one.
void expect_closed(const std::string& what, const cases::Case& c) {
  AssessmentRows rows;
  (void)assess(c, &rows);
  const io::CapacityCurve& r = rows.curve;
  REQUIRE(r.input.size() > 10);
  double off = 0.0, most = 0.0;
  for (std::size_t i = 0; i < r.input.size(); ++i) {
    if (i < r.over.size() && r.over[i] == 2.0) continue;  // no state of rest
    const double work = r.input[i] - r.input[0], kept = r.stored[i] - r.stored[0], lost = r.losses[i] - r.losses[0];
    off = std::max(off, std::abs(work - kept - lost)), most = std::max({most, std::abs(work), lost});
  }
  expect_below("V15 at rest: energy of " + what + ": work less what is stored and lost, of what is turned over", off / most, kEnergy);
}

cases::Case led(const std::string& name, AnalysisKind kind, double x, double y) {
  cases::Case c = load(name).value;
  c.analysis.kind = kind, c.analysis.solver = cases::Solver::equilibrium;
  c.analysis.direction = {x, y};
  c.motion.reset();
  return c;
}

/// A wall in running bond, two bricks long, under a dead load; its top is pushed and kept level.
cases::Case pressed_wall() {
  cases::Case c;
  c.materials["unit"] = {2000.0, 6.9e9, 0.2};
  cases::JointLaw& bed = c.joint_laws["bed"];
  bed.tension = 2.7e4, bed.cohesion = 3.75e4, bed.friction = 30.0, bed.compression = 1.3e6;
  bed.normal_stiffness = 3e10, bed.shear_stiffness = 1.2e10;
  bed.fracture_energy_tension = 18.0, bed.fracture_energy_shear = 125.0;
  cases::JointLaw& glue = c.joint_laws["glue"];
  glue.tension = glue.cohesion = glue.compression = 1e12, glue.friction = 30.0;
  c.materials["beam"] = {500.0, 6.9e9, 0.2};
  c.joints.default_law = "bed";
  c.joints.between.push_back({{"unit", "beam"}, "glue"});
  c.contact.friction = 30.0;
  c.base = cases::Base{};
  c.segment_rule = geometry::SegmentRule::rim, c.segment_size = 0.14;
  const auto add = [&c](const std::string& name, const std::string& material, Vec3 low, Vec3 high) {
    cases::BlockSpec b;
    b.name = name, b.material = material, b.box = {{low, high}};
    c.blocks.push_back(b);
  };
  constexpr double kCourse = 0.225;
  for (int i = 0; i < 8; ++i) {
    const double ends[] = {0.0, i % 2 == 0 ? 0.3 : 0.15, i % 2 == 0 ? 0.6 : 0.45, 0.6};
    for (int k = 0; k < (i % 2 == 0 ? 2 : 3); ++k)
      add(std::to_string(10 * i + k), "unit", {ends[k], 0.0, kCourse * i}, {ends[k + 1], 0.1, kCourse * (i + 1)});
  }
  add("beam", "beam", {0.0, 0.0, 8 * kCourse}, {0.6, 0.1, 8 * kCourse + 0.2});
  cases::Load jack, actuator;
  jack.block = actuator.block = "beam";
  jack.force = {0.0, 0.0, -34941.0}, actuator.force = {1000.0, 0.0, 0.0};
  actuator.grows = true;
  c.loads = {jack, actuator};
  c.analysis.kind = AnalysisKind::pushover, c.analysis.solver = cases::Solver::equilibrium;
  c.analysis.pattern = cases::LoadPattern::given, c.analysis.direction = {1.0, 0.0}, c.analysis.level = true;
  c.analysis.largest_drift = 0.02, c.analysis.largest_factor = 1000.0, c.analysis.drop = 0.5;
  c.analysis.longest = 3000.0;
  return c;
}

}  // namespace

TEST_CASE("V15 at rest: energy of walls, arches, ties and panels that are pushed and tilted beyond their peak") {
  const auto push = AnalysisKind::pushover, tilt = AnalysisKind::tilt;
  expect_closed("an arch, pushed across", led("arch_stands", push, 0.0, 1.0));
  expect_closed("an arch, pushed along", led("arch_stands", push, 1.0, 0.0));
  expect_closed("a wall over an arch, pushed", led("arched_wall", push, 1.0, 0.0));
  expect_closed("a stack, pushed", led("dry_stack", push, 1.0, 0.0));
  expect_closed("a slender panel, pushed", led("panel_slender", push, 1.0, 0.0));
  expect_closed("a slender panel, tilted", led("panel_slender", tilt, 1.0, 0.0));
  expect_closed("a parapet, pushed along until it is a heap", led("parapet", push, 1.0, 0.0));
  expect_closed("a cube on a cube, tilted", led("cube_on_cube", tilt, 1.0, 0.0));
  expect_closed("a tied wall, pushed aside", led("tie_wall", push, 0.0, 1.0));
  expect_closed("a wall in mortar, pushed", led("wall", push, 1.0, 0.0));
  expect_closed("a wall in mortar, tilted across", led("wall", tilt, 0.0, 1.0));
  expect_closed("a tilting table", load("tilting_table").value);
  expect_closed("a wallette, pressed", load("wallette").value);
  expect_closed("a wall under cycles of shear", load("shear_test").value);
}

TEST_CASE("V15 at rest: energy of a wall under shear whose toe is crushed until bodies meet as a whole") {
  expect_closed("a wall whose toe is crushed", pressed_wall());
}

}  // namespace voussoir::testing
