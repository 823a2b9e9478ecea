// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/couplet.h"

// V19: dry joints that stiffen as they close, THEORY.md (17a)-(17d): a couplet by imposed displacement, a column under its weight.
namespace voussoir::testing {
namespace {

constexpr double kMost = 1e-4, kFirst = 2e9;  // m, Pa/m: of the joint alone

cases::JointLaw stiffening() {
  cases::JointLaw law{.friction = 30.0, .compression = 1e9};
  law.normal_stiffness = kFirst, law.shear_stiffness = 0.4 * kFirst, law.maximum_closure = kMost;
  return law;
}

/// Of n blocks of 0.2 m, one on the other, on the base.
cases::Case column(int n) {
  cases::Case c;
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  c.gravity.ramp = 0.3;
  c.segment_size = 0.05;
  c.base.emplace();
  c.materials["stone"] = {2500.0, 1e9, 0.2, {}};
  c.joint_laws["bed"] = stiffening();
  c.joints.default_law = "bed";
  for (int i = 0; i < n; ++i) {
    cases::BlockSpec b;
    b.name = "b" + std::to_string(i), b.material = "stone";
    b.box = {{Vec3{0.0, 0.0, 0.2 * i}, Vec3{0.2, 0.2, 0.2 * (i + 1)}}};
    c.blocks.push_back(b);
  }
  return c;
}

}  // namespace

TEST_CASE("V19: a dry joint is pressed along its hyperbola") {
  Press p({"joint_laws.normal.tension=0", "joint_laws.normal.cohesion=0", "joint_laws.normal.thickness=0",
           "joint_laws.normal.normal_stiffness=2e9", "joint_laws.normal.shear_stiffness=8e8", "joint_laws.normal.maximum_closure=1e-4"});
  const auto pressed = [&](double u) {
    p.move({0, 0, -u - p.u()}, 1e-4, [](Vec3) {});
    return p.hold().z / kArea;
  };
  for (const double pressure : {2e3, 2e4, 2e5, 1e6}) {  // k_n V = 2e5
    const double closing = kMost * pressure / (kFirst * kMost + pressure) + pressure / kStiffness;
    expect_near("V19 couplet, pressure where the hyperbola has " + std::to_string(static_cast<int>(pressure)) + " Pa [Pa]",
                pressed(closing), pressure, 1e-3);
  }
  const double back = kMost * 2e4 / (kFirst * kMost + 2e4) + 2e4 / kStiffness;
  expect_near("V19 couplet, unloaded to 20000 Pa [Pa]", pressed(back), 2e4, 1e-3);
  expect_within("V19 couplet, parted [Pa]", pressed(-1e-5), 0.0, 1e-9);
}

TEST_CASE("V19: a column of stones with dry joints under its weight") {
  constexpr int kBlocks = 8;
  Run run(column(kBlocks));
  CHECK(run.settle());
  run.cycle({false, true});                                                   // energies
  const double weight = 2500.0 * kGravity * 0.2, plane = 1e9 / (1.0 - 0.04);  // Pa of a block; Pa
  double sunk = 0.0, stored = 0.0;
  for (int i = 0; i < kBlocks; ++i) {  // joint i under kBlocks − i of them; against the base one half block
    const double p = weight * (kBlocks - i), z = p / (kFirst * kMost), blocks = plane / (i == 0 ? 0.1 : 0.2);
    sunk += kMost * z / (1.0 + z) + p / blocks;
    stored += 0.04 * (0.5 * p * p / blocks + kFirst * kMost * kMost * (std::log1p(z) - z / (1.0 + z)));
  }
  expect_near("V19 column, sinking of the top block [m]", -run.displacement(kBlocks - 1).z, sunk, 1e-3);
  expect_near("V19 column, energy of its joints [J]", run.sim().energy().contact, stored, 1e-3);
}

}  // namespace voussoir::testing
