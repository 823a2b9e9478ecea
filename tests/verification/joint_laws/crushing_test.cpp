// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/couplet.h"
#include "tests/verification/slow_loading/assessment.h"

// V18: contacts that crush, THEORY.md (19a)-(19c): led through crushing by imposed displacement, and under a block that turns on its toe.
namespace voussoir::testing {
namespace {

constexpr double kStrength = 2e5, kResidual = 4e4, kEnergy = 60.0;                            // Pa, Pa, J/m2 above the residual
constexpr double kSlope = 0.5 * (kStrength - kResidual) * (kStrength - kResidual) / kEnergy;  // Pa/m
constexpr double kEnd = (kStrength - kResidual) / kSlope;                                     // m, crushed to the residual

std::vector<std::string> crushing(const std::vector<std::string>& more = {}) {
  std::vector<std::string> keys{"contact.compression=2e5", "contact.crushing_energy=60", "contact.residual_compression=4e4",
                                "contact.crushing_depth=2e-3"};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

/// Presses a couplet, whose faces meet at u = 0, through its curve. \param lost  J/m2, by breaking before
void press_through(const std::string& what, Press& p, double lost) {
  const auto pressed = [&](double u) {
    p.move({0, 0, -u - p.u()}, 1e-3, [](Vec3) {});
    return p.hold().z / kArea;
  };
  expect_near(what + ", below its strength [Pa]", pressed(0.9 * kStrength / kStiffness), 0.9 * kStrength, 1e-3);
  const double half = 0.5 * (kStrength + kResidual);
  expect_near(what + ", half crushed [Pa]", pressed(0.5 * kEnd + half / kStiffness), half, 1e-3);
  expect_near(what + ", unloaded by 1e-5 m [Pa]", pressed(0.5 * kEnd + half / kStiffness - 1e-5), half - 1e-5 * kStiffness, 1e-3);
  expect_within(what + ", parted [Pa]", pressed(0.4 * kEnd), 0.0, 1e-9);
  const double far = kEnd + 5e-4;
  expect_near(what + ", residual [Pa]", pressed(far + kResidual / kStiffness), kResidual, 1e-3);
  expect_near(what + ", lost by crushing [J/m2]", p.fracture() / kArea - lost, kEnergy + kResidual * far, 2e-3);
  expect_near(what + ", crushed to its depth: any pressure [Pa]", pressed(2e-3 + 1e6 / kStiffness), 1e6, 1e-3);
}

}  // namespace

TEST_CASE("V18: a dry contact is crushed") {
  Press p(crushing({"joints.default=dry"}));
  press_through("V18 dry", p, 0.0);
}

TEST_CASE("V18: a joint that broke in tension is crushed like one never bonded, one that holds is not") {
  Press p(crushing());
  p.move({0, 0, -1.5 * kStrength / kStiffness}, 1e-3, [](Vec3) {});
  expect_near("V18 bonded, over the strength of contacts [Pa]", p.hold().z / kArea, 1.5 * kStrength, 1e-3);
  p.move({0, 0, 1.1 * kTension / kStiffness - p.u()}, 1e-3, [](Vec3) {});
  CHECK(p.damage().bonded == 0);
  press_through("V18 broken", p, p.fracture() / kArea);
}

TEST_CASE("V18: a joint with the strength of its contacts crushes on their curve, whether it holds or has opened") {
  const double half = 0.5 * (kStrength + kResidual), crushed = 0.5 * kEnd;
  const auto pressed = [&](Press& p, double u) {
    p.move({0, 0, -u - p.u()}, 1e-3, [](Vec3) {});
    return p.hold().z / kArea;
  };
  for (const bool opened : {false, true}) {
    const std::string what = opened ? "V18 joint that had opened" : "V18 joint";
    Press p(crushing({"joint_laws.normal.compression=2e5"}));
    if (opened) p.move({0, 0, 1.1 * kTension / kStiffness}, 1e-3, [](Vec3) {});
    CHECK((p.damage().bonded == 0) == opened);
    expect_near(what + ", below its strength [Pa]", pressed(p, 0.95 * kStrength / kStiffness), 0.95 * kStrength, 1e-3);
    expect_near(what + ", half crushed [Pa]", pressed(p, crushed + half / kStiffness), half, 2e-3);
    expect_near(what + ", unloaded by 1e-5 m [Pa]", pressed(p, crushed + half / kStiffness - 1e-5), half - 1e-5 * kStiffness, 2e-3);
    expect_within(what + ", parted [Pa]", pressed(p, 0.5 * crushed), 0.0, 1e-9);
    expect_near(what + ", residual [Pa]", pressed(p, 1.5e-3 + kResidual / kStiffness), kResidual, 2e-3);
    expect_near(what + ", crushed to its depth: any pressure [Pa]", pressed(p, 2e-3 + 1e6 / kStiffness), 1e6, 2e-3);
  }
}

TEST_CASE("V18: under shear, too, a crushed joint loses its strength") {
  // Friction of the bond 32 degrees, C_s = 9: it slides and is crushed on the cap, far below f_m.
  Press p(crushing({"joint_laws.normal.compression=2e5", "contact.crushing_depth=5e-3"}));
  double most = 0.0;
  p.move({0.002, 0, -0.002}, 1e-3, [&](Vec3 f) { most = std::max(most, f.z / kArea); });
  expect_below("V18 sheared: largest pressure over f_c", most / kStrength, 0.9);
  expect_below("V18 sheared: pressure at the end over the residual", p.hold().z / kArea / kResidual, 1.001);
}

TEST_CASE("V18: a block is pushed over on a toe that crushes") {
  // Two rows of eight bear 0.4 of the weight each at most, so the third bears the rest: M = W b (0.8 · 0.375 + 0.2 · 0.1875).
  const double weight = 1800.0 * kGravity * 0.8;  // Pa
  cases::Case c = load("tilt").value;
  c.motion.reset();
  c.base->tilt = {0.0, 0.0};
  c.gravity.acceleration = {0.0, 0.0, -kGravity};
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.solver = cases::Solver::dynamics;
  c.analysis.direction = {1.0, 0.0};
  c.analysis.drop = 0.05;
  c.contact.compression = 3.2 * weight;
  const io::Capacity got = assess(c);
  expect_near("V18 block on its toe: multiplier, strength of 3.2 times the mean pressure", got.multiplier_at_rest,
              2.0 * 0.25 * (0.8 * 0.375 + 0.2 * 0.1875), 1e-2);
  expect_below("V18 block on its toe: share of the work that went into motion", std::abs(got.motion_share), 1e-2);
}

/// A block of 0.2 x 0.2 x 0.8 m on a bed that bears four times the mean pressure, pushed by states of rest. \param energy  J/m2
io::Capacity turned_over(const std::string& energy, AssessmentRows* rows) {
  cases::Case c = load("tilt", {"segments.rule=rim", "segments.size=0.005", "joints.default=bed", "joint_laws.bed.tension=0.0",
                                "joint_laws.bed.cohesion=0.0", "joint_laws.bed.friction=60.0", "joint_laws.bed.cap=0.0", "joint_laws.bed.compression=56448.0",
                                "contact.compression=56448.0", "contact.residual_compression=5644.8", "contact.crushing_energy=" + energy,
                                "base.tilt=[0.0, 0.0]"})
                      .value;
  c.analysis.kind = cases::AnalysisKind::pushover, c.analysis.direction = {1.0, 0.0};
  c.analysis.drop = 0.5, c.analysis.largest_drift = 0.05;
  return assess(c, rows);
}

TEST_CASE("V18: eccentric compression of a bed: the rectangular block of stress, and its fall as the toe crushes") {
  // The pressure over the length x at the toe is f − k_c θ s, s from the neutral axis: N = t (f x − k_c θ x²/2) and
  // M = ½ N b − t (f x²/2 − k_c θ x³/6); λ = 2 M/(N h) − θ, as the weight moves with the block. k_c = 0: M = ½ N (b − N/(f t)).
  const double b = 0.2, h = 0.8, strength = 56448.0, n = 1800.0 * 9.8 * b * b * h;
  const auto multiplier = [&](double turn, double energy) {
    const double slope = 0.5 * 0.81 * strength * strength / energy * turn;
    const double x = slope == 0.0 ? n / (strength * b) : (strength - std::sqrt(strength * strength - 2.0 * slope * n / b)) / slope;
    return 2.0 * (0.5 * n * b - b * (0.5 * strength * x * x - slope * x * x * x / 6.0)) / (n * h) - turn;
  };
  AssessmentRows rows;
  const io::Capacity plastic = turned_over("1e6", &rows);
  expect_near("V18 rectangular block of stress: multiplier", plastic.multiplier_at_rest, multiplier(0.0, 1e6), 1e-2);
  (void)turned_over("40", &rows);
  for (const double turn : {0.005, 0.01}) {
    std::size_t i = 0;
    while (i + 1 < rows.curve.displacement.size() && rows.curve.displacement[i] < 0.5 * h * turn) ++i;
    expect_near("V18 toe that crushes, turned by " + std::to_string(turn) + ": multiplier", rows.curve.factor[i],
                multiplier(rows.curve.displacement[i] / (0.5 * h), 40.0), 2e-2);
  }
}

TEST_CASE("V18: a crushing energy that would snap through is refused with the least that is allowed") {
  const auto refusal = [](const std::string& energy) -> std::string {
    try {
      Press p({"contact.compression=2e5", "contact.residual_compression=4e4", "contact.crushing_energy=" + energy});
    } catch (const cases::InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  const std::string little = refusal("24");  // (1.6e5)² / 2k = 24.49, where the ends of the bricks meet: k is half of the joint's
  CHECK(little.starts_with("contact.crushing_energy: = 24 J/m2 is no more than"));
  CHECK(little.find("= 24.49 J/m2") != std::string::npos);
  CHECK(refusal("25") == "accepted");
}

}  // namespace voussoir::testing
