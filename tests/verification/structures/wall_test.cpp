// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <vector>

#include "tests/verification/collapse.h"

// A small wall up to its first crack: the discrete closed forms, and how step and segment size converge. What comes after the first crack
// is chaotic; see scripts/ensemble.
namespace voussoir::testing {
namespace {

/// The wall of wall.toml: a cantilever one brick thick with n contact points over its thickness.
struct Wall {
  double height = 0.6, thickness = 0.1;  // m
  int courses = 6, points = 4;

  [[nodiscard]] double segment() const { return thickness / points; }
  [[nodiscard]] double course() const { return height / courses; }
  /// Acceleration across the wall at which its lowest joint reaches the tensile strength f [m/s2]: 3 ρ H² a / b stress by bending over
  /// (1 + 1/n), less the weight ρ g H.
  [[nodiscard]] double first_crack(double f) const {
    const double weight = Adobe::density * kGravity * height;
    return (f + weight) * thickness * (1.0 + 1.0 / points) / (3.0 * Adobe::density * height * height);
  }
  /// Displacement of the centroids of the top course under the acceleration `a` across the wall: rotations and slides of the joints, each
  /// with the moment and shear of what lies above it. The lowest joint has half the compliance: its base is rigid.
  [[nodiscard]] double deflection(double a) const {
    const double inertia = thickness * thickness * thickness / 12.0 * (1.0 - 1.0 / (points * points));  // of 1 m
    const double c = course(), load = Adobe::density * thickness * a, top = height - 0.5 * c;
    double u = 0.0;
    for (int i = 0; i < courses; ++i) {
      const double z = i * c, above = height - z, share = i == 0 ? 0.5 : 1.0;
      const double turn = share * c * 0.5 * load * above * above / (Adobe::plane * inertia);
      const double slide = share * c * load * above / (Adobe::shear * thickness);
      u += turn * (top - z) + slide;
    }
    return u;
  }
};

std::vector<std::string> with(const Wall& w, std::vector<std::string> more) {
  more.push_back("segments.size=" + std::to_string(w.segment()));
  return more;
}

double top_deflection(const Run& run) {
  double sum = 0.0;
  int n = 0;
  for (std::size_t i = 0; i < run.count(); ++i) {
    if (run.position(i).z > 0.5) sum += run.displacement(i).y, ++n;
  }
  return sum / n;
}

/// Top of the wall at rest under a steady acceleration across it, without the weight, which would bend it on by 0.6 %.
double steady_deflection(const Wall& w, double a) {
  Run run("wall", with(w, {"motion=", "joints.default=strong", "house.joint=strong",
                           "gravity.acceleration=[0.0," + std::to_string(a) + ",0.0]", "gravity.settle_limit=2.0"}));
  CHECK(run.settle());
  return top_deflection(run);
}

/// Acceleration at which the first segment opens when it grows by 0.3 m/s2 in a second.
double acceleration_at_first_crack(const Wall& w) {
  Run run("wall", with(w, {"motion.record=", "motion.y=ramp.csv", "time.step=2e-4",
                           "damping.ratio=", "damping.frequency=", "damping.alpha=10.0", "gravity.settle_limit=1.0"}));
  CHECK(run.settle());
  CHECK(run.sim().damage().tension == 0);
  while (run.sim().damage().tension == 0 && run.time() < 4.0) run.cycle({});
  return norm(cases::acceleration_at(run.motion(), run.time()));
}

/// Top of the wall, uncracked, 0.1 s into the ramp. (A pulse that is there at once would show how the scheme starts: velocities belong to
/// half a step before time zero.)
double early_deflection(double step) {
  Run run("wall", {"motion.record=", "motion.y=ramp.csv", "joints.default=strong", "house.joint=strong", "gravity.acceleration=[0,0,0]",
                   "time.step=" + std::to_string(1e6 * step) + "e-6"});
  run.until(0.1);
  return top_deflection(run);
}

/// Whether the wall, mortared but for its foot, goes over within 3 s under a steady acceleration across it. At rest it leans by the
/// shortening of its toe alone.
bool overturns(double acceleration) {
  Run run("parapet", {"gravity.acceleration=[0.0," + std::to_string(acceleration) + ",-9.8]"});
  run.settle();
  while (run.time() < run.description().time.duration && top_deflection(run) < 0.02) run.until(run.time() + 0.05);
  return top_deflection(run) >= 0.02;
}

}  // namespace

TEST_CASE("wall: deflection under a steady acceleration, and its convergence with the size of segments") {
  const double a = 0.5;
  std::array<double, 3> got{}, expected{};
  std::size_t k = 0;
  for (const int points : {2, 4, 8}) {
    Wall w;
    w.points = points;
    got[k] = steady_deflection(w, a), expected[k] = w.deflection(a);
    expect_near("wall: steady deflection of the top, n = " + std::to_string(points) + " [m]", got[k], expected[k], 1e-3);
    ++k;
  }
  expect_near("wall: steady deflection, (u2 - u4)/(u4 - u8)", (got[0] - got[1]) / (got[1] - got[2]),
              (4.0 / 3.0 - 16.0 / 15.0) / (16.0 / 15.0 - 64.0 / 63.0), 2e-2);
}

TEST_CASE("wall: first crack under a slowly growing acceleration, and its convergence with the size of segments") {
  const double f = 4.6e3;  // Pa, law "weak"
  Wall fine;
  fine.points = 1 << 20;
  const double continuum = fine.first_crack(f);
  std::array<double, 3> excess{};
  std::size_t k = 0;
  Curve curve{"wall_first_crack",
              "Wall: acceleration at the first crack",
              "contact points over the thickness n",
              "over the continuum's, less 1",
              true,
              {}};
  Series computed{"computed", "o", {}, {}}, exact{"1/n", "--", {}, {}};
  for (const int points : {2, 4, 8}) {
    Wall w;
    w.points = points;
    const double got = acceleration_at_first_crack(w);
    expect_near("wall: acceleration at the first crack, n = " + std::to_string(points) + " [m/s2]", got, w.first_crack(f), 1e-2);
    excess[k++] = got / continuum - 1.0;
    computed.x.push_back(points), computed.y.push_back(got / continuum - 1.0);
    exact.x.push_back(points), exact.y.push_back(1.0 / points);
  }
  curve.series = {computed, exact};
  write(curve);
  for (std::size_t i = 0; i < 2; ++i) expect_near("wall: first crack, excess(n)/excess(2n)", excess[i] / excess[i + 1], 2.0, 0.1);
}

TEST_CASE("wall: second order in the step until the first crack") {
  const std::array<double, 3> u{early_deflection(2e-4), early_deflection(1e-4), early_deflection(5e-5)};
  expect_near("wall: (u(dt) - u(dt/2))/(u(dt/2) - u(dt/4))", (u[0] - u[1]) / (u[1] - u[2]), 4.0, 0.1);
}

TEST_CASE("parapet: overturning under a steady acceleration across it") {
  const Wall w;
  const double ratio = w.thickness * (1.0 - 1.0 / w.points) / w.height, low = 0.95 * ratio, high = 1.05 * ratio;
  CHECK(!overturns(low * kGravity));
  CHECK(overturns(high * kGravity));
  const double got = bisect(low, high, 0.01 * ratio, [](double a) { return overturns(a * kGravity); });
  expect_near("parapet: acceleration that overturns it over g, t_e/h", got, ratio, 2e-2);
}

}  // namespace voussoir::testing
