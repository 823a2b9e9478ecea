// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "geometry/segments/torsion.h"
#include "tests/verification/fixture.h"

// V22: faces that twist as solids do (THEORY.md (11a)-(11c)): bars by Saint-Venant, plates by Kirchhoff.
namespace voussoir::testing {
namespace {

using geometry::Torsion;

constexpr double kThick = 0.1;  // m, of bars and plates

/// Blocks of glue that never fails, none yet, whose first mode has the frequency `omega` [rad/s].
cases::Case without_blocks(Torsion torsion, double omega) {
  cases::Case c = load("column_bend").value;
  c.segment_torsion = torsion;
  c.damping = {};
  c.damping.frequency = omega / (2.0 * kPi);
  c.gravity.settle_limit = 20.0;
  c.segment_rule = geometry::SegmentRule::rim;
  c.segment_size.reset();
  c.blocks.clear(), c.loads.clear(), c.output.history.clear();
  return c;
}

void add_block(cases::Case& c, Vec3 low, Vec3 high, bool fixed = false) {
  cases::BlockSpec b;
  b.name = "e" + std::to_string(c.blocks.size()), b.material = "adobe";
  b.box = {{low, high}};
  b.fixed = fixed;
  c.blocks.push_back(b);
}

/// Angle [rad] by which the uppermost of eight blocks turns under 1 N m, over that of a bar with the constant of torsion J.
double turn_of_bar(double width, double constant, Torsion torsion) {
  constexpr int kBlocks = 8;
  const double length = (kBlocks - 0.5) * kThick;
  const double polar = width * kThick * (width * width + kThick * kThick) / 12.0;
  cases::Case c = without_blocks(torsion, 0.5 * kPi / length * std::sqrt(Adobe::shear * constant / (Adobe::density * polar)));
  for (int i = 0; i < kBlocks; ++i) add_block(c, {-0.5 * width, -0.5 * kThick, i * kThick}, {0.5 * width, 0.5 * kThick, (i + 1) * kThick});
  c.gravity.acceleration = {0.0, 0.0, -1e-3};  // settling is what damps a turn
  cases::Load turning;
  turning.block = c.blocks.back().name, turning.moment = {0.0, 0.0, 1.0};
  c.loads.push_back(turning);
  Run run(c);
  CHECK(run.settle());
  return 2.0 * run.orientation(kBlocks - 1).z * Adobe::shear * constant / length;
}

/// Deflection of the middle of a square plate of square blocks in a frame of fixed ones, under a pressure, over that of Kirchhoff's clamped
/// plate (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, table 35). Clamped are the centroids of the fixed blocks.
double deflection_of_plate(int across, double edge, double poisson, Torsion torsion) {
  const double width = (across + 1) * edge, rigidity = Adobe::young * std::pow(kThick, 3) / (12.0 * (1.0 - poisson * poisson));
  const double mass = Adobe::density * kThick, load = 1e-3;  // kg/m2, m/s2
  cases::Case c = without_blocks(torsion, 36.0 / (width * width) * std::sqrt(rigidity / mass));
  c.base.reset();
  c.gravity.acceleration = {0.0, load, 0.0};
  c.materials.at("adobe").poisson = poisson;
  for (int j = -1; j <= across; ++j) {
    for (int i = -1; i <= across; ++i) {
      const bool frame = i < 0 || j < 0 || i == across || j == across;
      if (frame && (i < 0 || i == across) && (j < 0 || j == across)) continue;
      add_block(c, {i * edge, 0.0, j * edge}, {(i + 1) * edge, kThick, (j + 1) * edge}, frame);
    }
  }
  Run run(c);
  CHECK(run.settle());
  double most = 0.0;
  for (std::size_t i = 0; i < run.count(); ++i) most = std::max(most, run.displacement(i).y);
  return most / (0.00126532 * mass * load * std::pow(width, 4) / rigidity);
}

std::string block_of(double edge) { return "blocks as wide as " + std::to_string(std::lround(edge / kThick)) + " thicknesses"; }

}  // namespace

TEST_CASE("V22: a bar in torsion has Saint-Venant's constant, whatever its section") {
  for (const int ratio : {1, 2, 4, 10}) {
    const double width = ratio * kThick, square = kThick * kThick;
    const double plane = width * kThick * (width * width + square) / 12.0;
    const double constant = geometry::torsion_constant(width, kThick);
    const std::string section = "V22 section of 1 : " + std::to_string(ratio);
    expect_near(section + ", angle of the top over Saint-Venant's", turn_of_bar(width, constant, Torsion::solid), 1.0, 1e-3);
    expect_near(section + ", with the default, J over I_p", turn_of_bar(width, constant, Torsion::paper), constant / plane, 1e-3);
  }
}

TEST_CASE("V22: a plate clamped all round, whatever the size of its blocks") {
  for (const double edge : {1.0 * kThick, 2.0 * kThick, 4.0 * kThick}) {
    expect_near("V22 clamped plate without Poisson's effect, " + block_of(edge) + ", deflection over Kirchhoff's",
                deflection_of_plate(21, edge, 0.0, Torsion::solid), 1.0, 0.05);
    expect_near("V22 clamped plate, " + block_of(edge) + ", deflection over Kirchhoff's",
                deflection_of_plate(21, edge, Adobe::poisson, Torsion::solid), 1.0, 0.13);
  }
}
}  // namespace voussoir::testing
