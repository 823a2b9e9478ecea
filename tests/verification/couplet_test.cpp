// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/verification/couplet.h"

#include <algorithm>
#include <vector>

// V5: two bricks, the lower one fixed; what the joint carries is what it does to the upper one.
namespace voussoir::testing {
namespace {

std::string triple(const std::string& key, Vec3 v) {
  return key + "=[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
}

struct Failure {
  Vec3 force, moment;   // most the joint carried before its first segment reached a limit; N, N m about the centroid of the upper brick
  Vec3 plateau;         // largest components of the force, also in the 0.01 s behind it, N
  bool failed = false;  // a segment has reached a limit
  solver::Damage damage;
};

Vec3 larger(Vec3 a, Vec3 b) { return {std::max(a.x, std::abs(b.x)), std::max(a.y, std::abs(b.y)), std::max(a.z, std::abs(b.z))}; }

/// Loads the couplet: `first` grows in 1 s, `second` and `moment` from 1.5 to 4.5 s.
Failure break_couplet(Vec3 first, Vec3 second, Vec3 moment, double segment = kDepth / 4) {
  Run run("couplet", {triple("load[0].force", first), triple("load[1].force", second), triple("load[1].moment", moment),
                      "segments.size=" + std::to_string(segment)});
  Failure p;
  double end = run.description().time.duration;
  while (run.time() < end) {
    const Vec3 x = run.position(1);
    run.cycle({true, false});
    const solver::ForcesRow& f = run.sim().forces();
    p.plateau = larger(p.plateau, f.base_shear);
    if (p.failed) continue;
    p.damage = run.sim().damage();
    p.failed = events(p.damage) > 0;
    if (p.failed) {
      end = run.time() + 0.01;
    } else {  // a step with an event is already without the segments that broke in it
      p.force = larger(p.force, f.base_shear);
      p.moment = larger(p.moment, f.base_moment - cross(x, f.base_shear));
    }
  }
  return p;
}

/// Shear strength at a normal stress (tension positive): Eqs. 5-7, Eq. 6 without its slope in tension.
double envelope(double sigma) {
  if (sigma >= 0.0) return kCohesion;
  return std::min(kCohesion - sigma * kTanPhi, std::sqrt((kCompression * kCompression - sigma * sigma) / kCap));
}

}  // namespace

// Loads go 0.2 % beyond the strength: enough to reach it, too little for the inertia of a sliding brick to bend the joint.
constexpr double kBeyond = 1.002;

TEST_CASE("V5: couplet in pure tension") {
  const double expected = kTension * kArea;
  const Failure p = break_couplet({}, {0, 0, kBeyond * expected}, {});
  CHECK(p.failed);
  CHECK(p.damage.tension > 0);
  expect_near("V5 pure tension [N]", p.plateau.z, expected, 1e-3);
}

TEST_CASE("V5: couplet in pure shear") {
  const double expected = kCohesion * kArea;
  const Failure p = break_couplet({}, {kBeyond * expected, 0, 0}, {});
  CHECK(p.failed);
  CHECK(p.damage.slipped > 0);
  expect_near("V5 pure shear [N]", p.plateau.x, expected, 1e-3);
}

TEST_CASE("V5: couplet in shear under compression") {
  for (const double normal : {200.0, 1000.0, 2500.0}) {
    const double expected = kCohesion * kArea + normal * kTanPhi;
    const Failure p = break_couplet({0, 0, -normal}, {kBeyond * expected, 0, 0}, {});
    CHECK(p.failed);
    CHECK(p.damage.slipped > 0);
    expect_near("V5 shear under " + std::to_string(static_cast<int>(normal)) + " N [N]", p.plateau.x, expected, 1e-3);
  }
}

TEST_CASE("V5: couplet in compression") {
  const double expected = kCompression * kArea;
  const Failure p = break_couplet({}, {0, 0, -kBeyond * expected}, {});
  CHECK(p.failed);
  CHECK(p.damage.compression > 0);
  expect_near("V5 compression [N]", p.force.z, expected, 1e-3);
}

TEST_CASE("V5: crushing plateau and unloading") {
  Press press;
  const double slow = 1e-4, closing = kCompression / kStiffness;  // m/s: dashpots add 2e-4 of f_m at most; m
  double most = 0.0, least = 1e300;
  press.move({0, 0, -2.0 * closing}, slow, [&](Vec3 f) {
    most = std::max(most, f.z);
    if (press.u() < -1.001 * closing) least = std::min(least, f.z);
  });
  expect_near("V5 crushing plateau, largest [N]", most, kCompression * kArea, 1e-3);
  expect_near("V5 crushing plateau, least [N]", least, kCompression * kArea, 1e-3);
  press.move({0, 0, 0.5 * closing}, slow, [](Vec3) {});
  expect_near("V5 half unloaded with the initial stiffness [N]", press.hold().z, 0.5 * kCompression * kArea, 1e-3);
  press.move({0, 0, 0.51 * closing}, slow, [](Vec3) {});
  expect_below("V5 unloaded: no tension after crushing [N]", norm(press.hold()), 1e-9);
}

TEST_CASE("V5: the envelope of Eqs. 5-7") {
  Curve curve{"v5_envelope",
              "V5: envelope of Eqs. 5-7, law \"normal\"",
              "normal stress [kPa], tension positive",
              "shear stress at the limit [kPa]",
              false,
              {}};
  Series got{"computed", "o", {}, {}}, exact{"closed form", "-", {}, {}};
  for (double sigma = -kCompression; sigma <= kTension; sigma += 2e3)
    exact.x.push_back(1e-3 * sigma), exact.y.push_back(1e-3 * envelope(sigma));
  for (const double sigma : {0.999 * kTension, 0.5 * kTension, 0.0, -2.0e4, -1.0e5, -1.4e5, -2.0e5, -3.0e5, -4.0e5, -4.8e5}) {
    const double tau = envelope(sigma);
    Press press;
    press.move({0, 0, sigma / kStiffness}, 1e-3, [](Vec3) {});
    CAPTURE(sigma);
    CHECK(!press.failed());
    Vec3 last;
    press.move({1.001 * tau / kShearStiffness, 0, 0}, 1e-4, [&](Vec3 f) {
      if (!press.failed()) last = f;
    });
    CHECK(press.failed());
    CHECK(std::abs(-last.z / kArea - sigma) <= 1e-3 * std::max(std::abs(sigma), kCohesion));
    expect_near("V5 envelope, shear at " + std::to_string(static_cast<int>(sigma)) + " Pa [Pa]", std::abs(last.x) / kArea, tau, 1e-3);
    got.x.push_back(1e-3 * sigma), got.y.push_back(1e-3 * std::abs(last.x) / kArea);
  }
  curve.series = {got, exact};
  write(curve);
}

TEST_CASE("V5: the envelope does not know the direction of shear in the joint") {
  for (const double angle : {30.0, 135.0, 250.0}) {  // degrees
    const Vec3 along{std::cos(radians(angle)), std::sin(radians(angle)), 0.0};
    for (const double sigma : {0.0, -1.0e5, -3.0e5}) {
      const double tau = envelope(sigma);
      Press press;
      press.move({0, 0, sigma / kStiffness}, 1e-3, [](Vec3) {});
      Vec3 last;
      press.move((1.001 * tau / kShearStiffness) * along, 1e-4, [&](Vec3 f) {
        if (!press.failed()) last = f;
      });
      CHECK(press.failed());
      const std::string where =
          " at " + std::to_string(static_cast<int>(sigma)) + " Pa, " + std::to_string(static_cast<int>(angle)) + " degrees";
      expect_near("V5 envelope, shear" + where + " [Pa]", std::hypot(last.x, last.y) / kArea, tau, 1e-3);
      expect_below("V5 envelope, shear across its direction" + where + ", over the limit",
                   std::abs(last.x * along.y - last.y * along.x) / kArea / tau, 1e-3);
    }
  }
}

TEST_CASE("V5: tension while shear is held at half of the cohesion") {
  Press press;
  const double tau = 0.5 * kCohesion;
  press.move({tau / kShearStiffness, 0, 0}, 1e-3, [](Vec3) {});
  CHECK(!press.failed());
  Vec3 last;
  press.move({0, 0, 1.001 * kTension / kStiffness}, 1e-4, [&](Vec3 f) {
    if (!press.failed()) last = f;
  });
  CHECK(press.damage().tension > 0);
  CHECK(press.damage().slipped == 0);
  expect_near("V5 tension under shear [Pa]", -last.z / kArea, kTension, 1e-3);
  expect_near("V5 shear held under tension [Pa]", std::abs(last.x) / kArea, tau, 1e-3);
}

TEST_CASE("V5: bond wrench about the long edge, and its convergence with the size of segments") {
  const double continuum = kTension * kWidth * kDepth * kDepth / 6.0;
  Series got{"computed", "o", {}, {}}, exact{"1/n", "--", {}, {}};
  for (const int n : {2, 4, 8}) {  // segments over the depth
    const double expected = continuum * (1.0 + 1.0 / n);
    const Failure p = break_couplet({}, {}, {1.02 * expected, 0, 0}, kDepth / n);
    CHECK(p.failed);
    CHECK(p.damage.tension > 0);
    expect_near("V5 bond wrench, n = " + std::to_string(n) + " [N m]", std::abs(p.moment.x), expected, 1e-2);
    got.x.push_back(n), got.y.push_back(std::abs(p.moment.x) / continuum - 1.0);
    exact.x.push_back(n), exact.y.push_back(1.0 / n);
  }
  write(Curve{"v5_bond_wrench",
              "V5: moment at the first crack of a bond wrench",
              "contact points over the depth n",
              "over the continuum's, less 1",
              true,
              {got, exact}});
}

}  // namespace voussoir::testing
