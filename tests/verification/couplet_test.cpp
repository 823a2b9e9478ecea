// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "tests/verification/fixture.h"

// V5: two bricks, the lower one fixed; what the joint carries is what it does to the upper one.
namespace voussoir::testing {
namespace {

constexpr double kTension = 1.27e5, kCohesion = 3.04e4, kCompression = 4.9e5, kCap = 9.0;  // Pa, law "normal"
const double kTanPhi = std::tan(radians(32.0));
constexpr double kWidth = 0.2, kDepth = 0.1, kArea = kWidth * kDepth;

std::string triple(const std::string& key, Vec3 v) {
  return key + "=[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
}

struct Peak {
  Vec3 force, moment;   // largest components the joint carried, N, N m (about the centre of the upper brick)
  Vec3 first_force;     // what it carried when its first segment reached a limit
  bool failed = false;  // a segment has reached a limit
  std::int64_t tension = 0, slipped = 0, compression = 0;
};

std::int64_t events(const solver::Damage& d) { return d.tension + d.shear + d.compression + d.slipped; }

Vec3 larger(Vec3 a, Vec3 b) { return {std::max(a.x, std::abs(b.x)), std::max(a.y, std::abs(b.y)), std::max(a.z, std::abs(b.z))}; }

/// Loads the couplet: force[0] grows over the first 0.2 s, force[1] and moment[1] from 0.3 to 0.8 s. Ends `after` s behind the first event.
Peak break_couplet(Vec3 first, Vec3 second, Vec3 moment, double after, bool first_grows_slowly = false) {
  Run run("couplet", {triple("load[0].force", first), triple("load[1].force", second), triple("load[1].moment", moment),
                      first_grows_slowly ? "load[0].ramp=[0.0,0.5]" : "load[0].ramp=[0.0,0.2]"});
  Peak p;
  double end = 1.0;
  while (run.time() < end) {
    const Vec3 x = run.position(1);
    run.sim().step({true, false});
    const solver::ForcesRow& f = run.sim().forces();
    p.force = larger(p.force, f.base_shear);
    p.moment = larger(p.moment, f.base_moment - cross(x, f.base_shear));
    if (p.failed || events(run.sim().damage()) == 0) continue;
    p.failed = true;
    p.first_force = f.base_shear;
    end = run.time() + after;
  }
  const solver::Damage& d = run.sim().damage();
  p.tension = d.tension, p.slipped = d.slipped, p.compression = d.compression;
  return p;
}

/// Shear strength at a normal stress (tension positive): Eqs. 5-7, Eq. 6 without its slope in tension.
double envelope(double sigma) {
  if (sigma >= 0.0) return kCohesion;
  return std::min(kCohesion - sigma * kTanPhi, std::sqrt((kCompression * kCompression - sigma * sigma) / kCap));
}

}  // namespace

TEST_CASE("V5: couplet in pure tension") {
  const double expected = kTension * kArea;
  const Peak p = break_couplet({0, 0, 1.1 * expected}, {}, {}, 0.0, true);
  CHECK(p.failed);
  CHECK(p.tension > 0);
  expect_near("V5 pure tension [N]", p.force.z, expected, 1e-3);
}

TEST_CASE("V5: couplet in pure shear") {
  const double expected = kCohesion * kArea;
  const Peak p = break_couplet({}, {1.1 * expected, 0, 0}, {}, 0.01);
  CHECK(p.failed);
  CHECK(p.slipped > 0);
  expect_near("V5 pure shear [N]", p.force.x, expected, 1e-3);
}

TEST_CASE("V5: couplet in shear under compression") {
  for (const double normal : {200.0, 1000.0, 2500.0}) {
    const double expected = kCohesion * kArea + normal * kTanPhi;
    const Peak p = break_couplet({0, 0, -normal}, {1.1 * expected, 0, 0}, {}, 0.01);
    CHECK(p.failed);
    expect_near("V5 shear under " + std::to_string(static_cast<int>(normal)) + " N [N]", p.force.x, expected, 1e-3);
  }
}

TEST_CASE("V5: couplet in compression") {
  const double expected = kCompression * kArea;
  const Peak p = break_couplet({0, 0, -1.1 * expected}, {}, {}, 0.01, true);
  CHECK(p.failed);
  CHECK(p.compression > 0);
  expect_near("V5 compression [N]", p.force.z, expected, 1e-3);
}

TEST_CASE("V5: the envelope of Eqs. 5-7") {
  for (const double sigma : {0.95 * kTension, 0.5 * kTension, 0.0, -2.0e4, -1.0e5, -1.4e5, -2.0e5, -3.0e5, -4.0e5, -4.8e5}) {
    const double tau = envelope(sigma);
    const Peak p = break_couplet({0, 0, sigma * kArea}, {1.1 * tau * kArea, 0, 0}, {}, 0.0);
    CHECK(p.failed);
    CAPTURE(sigma);
    CHECK(std::abs(-p.first_force.z / kArea - sigma) < 1e-3 * std::max(std::abs(sigma), kCohesion));
    expect_near("V5 envelope, shear at " + std::to_string(static_cast<int>(sigma)) + " Pa [Pa]", std::abs(p.first_force.x) / kArea, tau,
                1e-3);
  }
}

TEST_CASE("V5: bond wrench about the long edge") {
  const double n = 4.0;  // segments over the depth
  const double expected = kTension * kWidth * kDepth * kDepth / 6.0 * (1.0 + 1.0 / n);
  const Peak p = break_couplet({}, {}, {1.1 * expected, 0, 0}, 0.01);
  CHECK(p.failed);
  CHECK(p.tension > 0);
  expect_near("V5 bond wrench [N m]", p.moment.x, expected, 1e-2);
}

}  // namespace voussoir::testing
