// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/case.h"
#include "tests/verification/couplet.h"

// V5 with a joint law that softens, THEORY.md (13a)-(13e): the couplet is led through failure by imposed displacement.
namespace voussoir::testing {
namespace {

constexpr double kModeI = 20.0, kModeII = 12.0;                                                                         // J/m2
const double kElasticOpening = kTension / kStiffness, kElasticSlide = kCohesion / kShearStiffness;                      // m, at the limits
const double kOpening = kModeI / kTension - 0.5 * kElasticOpening, kSlide = kModeII / kCohesion - 0.5 * kElasticSlide;  // m, u_c and s_c

std::vector<std::string> softening(const std::string& curve, const std::vector<std::string>& more = {}) {
  std::vector<std::string> keys{"joint_laws.normal.fracture_energy_tension=20", "joint_laws.normal.fracture_energy_shear=12",
                                "joint_laws.normal.softening=" + curve};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

double left(const std::string& curve, double wear) { return curve == "linear" ? 1.0 - 0.5 * wear : std::exp(-wear); }

}  // namespace

TEST_CASE("V5: a bond that softens, in tension") {
  for (const std::string curve : {"exponential", "linear"}) {
    Press p(softening(curve));
    double peak = 0.0;
    const auto pull = [&](double to) {
      p.move({0, 0, to - p.u()}, 1e-3, [&](Vec3 f) { peak = std::max(peak, -f.z / kArea); });
      return -p.hold().z / kArea;
    };
    for (const double wear : {0.5, 1.0}) {
      expect_near("V5 softening, " + curve + ", wear " + std::to_string(wear).substr(0, 3) + " in tension [Pa]",
                  pull(kElasticOpening + wear * kOpening), left(curve, wear) * kTension, 1e-3);
    }
    expect_near("V5 softening, " + curve + ", peak in tension [Pa]", peak, kTension, 2e-3);
    const double far = p.u();
    expect_near("V5 softening, " + curve + ", unloaded to half of the opening [Pa]", pull(0.5 * far), 0.5 * left(curve, 1.0) * kTension,
                1e-3);
    expect_near("V5 softening, " + curve + ", closed again and pressed by 1e-5 m [Pa]", pull(-1e-5), -1e-5 * kStiffness, 1e-3);
    expect_near("V5 softening, " + curve + ", opened again [Pa]", pull(far), left(curve, 1.0) * kTension, 1e-3);
    pull(kElasticOpening + 8.0 * kOpening);
    expect_near("V5 softening, " + curve + ", lost by opening [J/m2]", p.fracture() / kArea, kModeI, 2e-3);
    CHECK(p.damage().bonded == 0);
    CHECK(p.damage().slipped == 0);
  }
}

TEST_CASE("V5: a bond that softens, in shear under constant pressure") {
  const double sigma = -4.0e4, tan_residual = std::tan(radians(25.0)), peak = kCohesion - sigma * kTanPhi;
  for (const std::string curve : {"exponential", "linear"}) {
    Press p(softening(curve, {"joint_laws.normal.residual_friction=25"}));
    p.move({0, 0, sigma / kStiffness}, 1e-3, [](Vec3) {});
    double most = 0.0;
    const auto slide = [&](double by) {
      p.move({by, 0, 0}, 1e-3, [&](Vec3 f) { most = std::max(most, std::abs(f.x) / kArea); });
      return std::abs(p.hold().x) / kArea;
    };
    slide(1.2 * peak / kShearStiffness);
    expect_near("V5 softening, " + curve + ", peak in shear [Pa]", most, peak, 2e-3);
    const double before = slide(0.0);
    expect_near("V5 softening, " + curve + ", unloaded by 1e-5 m in shear [Pa]", slide(-1e-5), before - 1e-5 * kShearStiffness, 1e-3);
    expect_near("V5 softening, " + curve + ", friction that is left [Pa]", slide(10.0 * kSlide), -sigma * tan_residual, 1e-3);
    expect_near("V5 softening, " + curve + ", lost by slip beside friction [J/m2]", p.fracture() / kArea, kModeII, 5e-3);
    CHECK(p.damage().shear > 0);
    CHECK(p.damage().slipped == 0);
  }
}

TEST_CASE("V5: slip that has opened a joint holds its faces apart by as much, from whichever side they come") {
  const double sigma = -4.0e4;
  Press p(softening("exponential", {"joint_laws.normal.dilatancy=10"}));
  p.move({0, 0, sigma / kStiffness}, 1e-3, [](Vec3) {});
  p.move({12.0 * kSlide, 0, 0}, 1e-3, [](Vec3) {});
  CHECK(p.damage().bonded == 0);
  const double opened = p.hold().z / kArea / kStiffness + p.u();  // m
  expect_near("V5 softening, opened by slip [m]", opened, std::tan(radians(10.0)) * kModeII / kCohesion, 2e-2);
  // Parted, then closed slowly to half of it: the spring must be felt in every step, not some steps late.
  p.move({0, 0, 2.0 * opened - p.u()}, 1e-3, [](Vec3) {});
  CHECK(std::abs(p.hold().z) < 1e-9);
  double worst = 0.0;
  p.move({0, 0, -1.5 * opened}, 1e-4, [&](Vec3 f) {
    const double spring = std::max(0.0, opened - p.u()) * kStiffness;
    if (opened - p.u() > 1e-9) worst = std::max(worst, (spring - f.z / kArea) / (opened * kStiffness));
  });
  expect_below("V5 softening, closed again after slip: least share of the spring that is missing", worst, 1e-4);
  expect_near("V5 softening, closed again to half of the opening [Pa]", p.hold().z / kArea, 0.5 * opened * kStiffness, 1e-3);
}

TEST_CASE("V5: a bond that softens has one wear for both limits") {
  Press p(softening("exponential"));
  p.move({kElasticSlide + 0.7 * kSlide, 0, 0}, 1e-3, [](Vec3) {});
  CHECK(p.damage().slipped > 0);
  // Half of the shear off, so that opening alone goes on.
  p.move({-0.9 * std::abs(p.hold().x) / kArea / kShearStiffness, 0, 0}, 1e-3, [](Vec3) {});
  double most = 0.0;
  p.move({0, 0, kElasticOpening + 2.0 * kOpening}, 1e-3, [&](Vec3 f) { most = std::max(most, -f.z / kArea); });
  expect_near("V5 softening, tensile strength after slip that wore by 0.7 [Pa]", most, std::exp(-0.7) * kTension, 2e-3);
}

TEST_CASE("V5: a fracture energy that would snap back is refused with the least that is allowed") {
  const auto refusal = [](const std::string& key) -> std::string {
    try {
      Press p({key});
    } catch (const cases::InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  const std::string tension = refusal("joint_laws.normal.fracture_energy_tension=7.6");  // f_t²/2k = 7.7148
  CHECK(tension.starts_with("joint_laws.normal.fracture_energy_tension: = 7.6 J/m2 is no more than"));
  CHECK(tension.find("= 7.715 J/m2") != std::string::npos);
  CHECK(refusal("joint_laws.normal.fracture_energy_tension=7.8") == "accepted");
  CHECK(refusal("joint_laws.normal.fracture_energy_shear=1.1").find("= 1.179 J/m2") != std::string::npos);
  CHECK(refusal("joint_laws.normal.fracture_energy_shear=1.2") == "accepted");
}

}  // namespace voussoir::testing
