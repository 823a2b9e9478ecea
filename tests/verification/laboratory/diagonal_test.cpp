// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "tests/verification/slow_loading/assessment.h"

// V20: diagonal compression of a square wallette. The elastic one against the theory of plates, one that shears against its beds' strength.
namespace voussoir::testing {
namespace {

constexpr double kEdge = 0.1, kModulus = 1e8, kLoad = 2e4;  // m of a block; Pa of the plate; N

/// n by n stacked cubes that make an isotropic plate of ν = 0: springs as stiff along a joint as across it, and G = E/2, since a joint
/// shears with half of each of its two blocks' turn. Pressed along the diagonal between two corner blocks, one of which is held: it
/// cannot turn anyway, as the plate is its own mirror image.
cases::Case plate(int n) {
  cases::Case c;
  c.gravity.acceleration = {};
  c.gravity.settle = false;
  c.time.duration = 0.4;
  c.damping.ratio = 0.3;
  c.damping.frequency = 0.2 * std::sqrt(kModulus / 2000.0) / (n * kEdge);
  c.segment_size = 0.5 * kEdge;
  c.segment_rule = geometry::SegmentRule::rim;
  c.materials["stone"] = {2000.0, 10.0 * kModulus, 0.0, {}};
  const double spring = kModulus / kEdge;  // of a joint with its blocks, E/a: blocks take a tenth of it across, a fifth along
  cases::JointLaw bed{.tension = 1e12, .cohesion = 1e12, .friction = 30.0, .compression = 1e12};
  bed.normal_stiffness = spring / 0.9, bed.shear_stiffness = spring / 0.8;
  c.joint_laws["bed"] = bed;
  c.joints.default_law = "bed";
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      cases::BlockSpec b;
      b.name = std::to_string(i * n + j), b.material = "stone", b.fixed = i + j == 0;
      b.box = {{Vec3{kEdge * i, 0.0, kEdge * j}, Vec3{kEdge * (i + 1), kEdge, kEdge * (j + 1)}}};
      c.blocks.push_back(b);
    }
  }
  cases::Load load;
  load.block = c.blocks.back().name;
  load.force = {-kLoad / std::sqrt(2.0), 0.0, -kLoad / std::sqrt(2.0)};
  load.ramp = {0.0, 0.1};
  c.loads.push_back(load);
  return c;
}

struct Stress {
  double mean, shear;  // in the middle, over P/A: along both edges of the plate, and between them
};
Stress middle(int n) {
  Run run(plate(n));
  run.until(0.4);
  const double spring = kModulus / kEdge, unit = kLoad / (n * kEdge * kEdge);
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i * n + j); };
  const auto turn = [&](std::size_t e) { return 2.0 * run.orientation(e).y; };
  const int c = n / 2;
  Stress s{};
  for (const int side : {-1, 0}) {  // of the middle block
    const std::size_t left = at(c + side, c), right = at(c + side + 1, c), below = at(c, c + side), above = at(c, c + side + 1);
    s.mean +=
        0.25 * spring * (run.displacement(right).x - run.displacement(left).x + run.displacement(above).z - run.displacement(below).z);
    s.shear += 0.25 * spring *
               (run.displacement(right).z - run.displacement(left).z + run.displacement(above).x - run.displacement(below).x +
                0.5 * kEdge * (turn(right) + turn(left) - turn(above) - turn(below)));
  }
  return {s.mean / unit, s.shear / unit};
}

}  // namespace

TEST_CASE("V20: stresses in the middle of an elastic plate that is pressed along its diagonal") {
  const Stress coarse = middle(11), fine = middle(21);
  // Finite elements: scripts/validation/diagonal_plate.
  expect_near("V20 elastic wallette of 21 by 21 blocks, stress along its edges over P/A", fine.mean, -0.5522, 1e-2);
  expect_near("V20 elastic wallette of 21 by 21 blocks, shear stress over P/A", fine.shear, -1.0346, 1e-2);
  expect_near("V20 elastic wallette of 21 by 21 blocks, largest tension over P/A", fine.mean - fine.shear, 0.4823, 1e-2);
  expect_below("V20 elastic wallette, error of the stress along its edges over that of 11 by 11 blocks",
               std::abs(fine.mean + 0.5522) / std::abs(coarse.mean + 0.5522), 0.5);
}

TEST_CASE("V20: a wallette pressed along its diagonal shears off along a bed") {
  const cases::Case c = load("wallette").value;
  const cases::JointLaw& mortar = c.joint_laws.at("mortar");
  const double expected = mortar.cohesion * 1.0 * 0.1 / (1.0 - std::tan(radians(mortar.friction))) / 1e3;  // kN along x, and along z
  const io::Capacity got = assess(c);
  expect_near("V20 wallette, largest load along its edges [kN]", got.multiplier_at_rest, expected, 1e-2);
  // ASTM E519 takes 0.707 P/A for the strength in shear: c/(1 - tan phi), not c.
  expect_near("V20 wallette, strength by ASTM E519 over the cohesion", got.multiplier_at_rest * 1e3 / 0.1 / mortar.cohesion, 1.25, 1e-2);
  expect_below("V20 wallette, share of the work that went into motion", std::abs(got.motion_share), 1e-2);
}

}  // namespace voussoir::testing
