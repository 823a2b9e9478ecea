// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/names.h"
#include "tests/verification/fixture.h"

// THEORY.md (22a): what is symmetric stays so, whatever the order in which contact forces are summed.
namespace voussoir::testing {
namespace {

/// Angle by which a box of side `a` turns until friction under uniform pressure has stopped it [rad].
double spun(double spin, double a, double mu, double g) {
  const double root2 = std::numbers::sqrt2;
  const double mean_distance = (root2 + std::log(1.0 + root2)) / 6.0;  // from the middle of a square, over its side
  return spin * spin * a / (12.0 * mean_distance * mu * g);
}

}  // namespace

TEST_CASE("contact: a box spins flat on the base") {
  for (const double degrees : {20.0, 32.0}) {
    Run run("spinning_box", {"contact.friction=" + std::to_string(degrees)});
    run.settle();
    double tilt = 0.0;
    run.until(0.3, {}, [&] {
      const Quaternion q = run.orientation(0);
      tilt = std::max(tilt, 2.0 * std::hypot(q.x, q.y));
    });
    const Quaternion q = run.orientation(0);
    const std::string what = "contact, a box spins flat, " + std::to_string(std::lround(degrees)) + " degrees: ";
    expect_near(what + "angle [rad]", 2.0 * std::atan2(q.z, q.w), spun(10.0, 0.2, std::tan(degrees * kPi / 180.0), 9.8), 0.002);
    expect_below(what + "largest tilt [rad]", tilt, 1e-12);
  }
}

// THEORY.md (20d): at the step that the program chooses. Rougher, at half of it.
TEST_CASE("contact: a stiff box that spins with a tilt from the start comes to lie flat") {
  struct Box {
    double degrees, of_bound, restitution;
  };
  for (const Box& box : {Box{32.0, 1.0, 0.0}, Box{35.0, 1.0, 0.0}, Box{45.0, 0.5, 0.0}, Box{32.0, 1.0, 0.2}, Box{32.0, 1.0, 0.8}}) {
    for (const char* young : {"1e9", "1e10"}) {
      for (const char* tilting : {"1e-6", "1e-4"}) {
        std::vector<std::string> keys{std::string("materials.stone.young=") + young, "contact.friction=" + std::to_string(box.degrees),
                                      std::string("block[0].angular_velocity=[") + tilting + ",0,10]"};
        if (box.restitution > 0.0) keys.push_back("contact.restitution=" + std::to_string(box.restitution));
        cases::Case c = load("spinning_box", keys).value;
        c.time.step = box.of_bound * solver::choose_step(c, {}, cases::census(cases::build_model(c)).step_bound);
        Run run(std::move(c));
        run.settle();
        run.until(0.3);
        const Quaternion q = run.orientation(0);
        const std::string what = std::string("contact, a box of ") + young + " Pa spins, tilting at " + tilting + " rad/s, " +
                                 cases::text(box.degrees) + " degrees, e " + cases::text(box.restitution) + ": ";
        expect_near(what + "angle [rad]", 2.0 * std::atan2(q.z, q.w), spun(10.0, 0.2, std::tan(box.degrees * kPi / 180.0), 9.8), 0.002);
        expect_below(what + "tilt at the end [rad]", 2.0 * std::hypot(q.x, q.y), box.restitution > 0.0 ? 1e-7 : 1e-12);
      }
    }
  }
}

TEST_CASE("contact: a cube falls flat and centred on a cube") {
  double most = 0.0;
  for (const std::vector<std::string>& other : {std::vector<std::string>{},
                                                {"block[1].material=heavy"},
                                                {"block[0].material=heavy"},
                                                {"block[1].velocity=[0,0,-3]"},
                                                {"contact.damping=0.0"},
                                                {"contact.damping=0.3"},
                                                {"contact.restitution=0.5"},
                                                {"contact.normal=slave"}}) {
    Run run("cube_on_cube", other);
    run.until(1.0, {}, [&] {
      for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 u = run.displacement(i);
        const Quaternion q = run.orientation(i);
        most = std::max({most, std::abs(u.x), std::abs(u.y), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
      }
    });
  }
  expect_below("contact, a cube falls flat on a cube: motion beside that along z [m, rad]", most, 0.0);
}

}  // namespace voussoir::testing
