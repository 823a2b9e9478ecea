// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "cases/case.h"
#include "cases/model.h"
#include "solver/run/simulation.h"

using namespace voussoir;

// Wood slides on wood at one angle, however the two came to touch: Eq. 8, THEORY.md (18).
namespace {

constexpr double kGravity = 9.8, kPhi = 24.0;  // degrees, of wood on wood; everything else has another
double tan_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

cases::BlockSpec block(const char* name, const char* material, Vec3 low, Vec3 high) {
  cases::BlockSpec b;
  b.name = name, b.material = material, b.box = {low, high};
  b.free = true;  // it may begin above the others
  return b;
}

/// A wooden plank that does not move, without friction against anything but wood, and what lies on it.
cases::Case on_a_plank(std::vector<cases::BlockSpec> blocks, double slope) {
  cases::Case c;
  c.gravity.settle = false;
  const double angle = slope * std::numbers::pi / 180.0;
  c.gravity.acceleration = {kGravity * std::sin(angle), 0.0, -kGravity * std::cos(angle)};
  c.materials["wood"] = {700.0, 6.3e8, 0.3};
  c.materials["adobe"] = {1800.0, 9.8e7, 0.25};
  c.contact.friction = 50.0;
  c.contact.between = {{{"adobe", "wood"}, 10.0}, {{"wood", "wood"}, kPhi}};
  c.blocks = {block("plank", "wood", {-0.1, -0.1, -0.1}, {1.5, 0.3, 0.0})};
  c.blocks[0].fixed = true, c.blocks[0].free = false;
  for (cases::BlockSpec& b : blocks) c.blocks.push_back(std::move(b));
  return c;
}

struct Run {
  explicit Run(cases::Case what) : c(std::move(what)), model(cases::build_model(c)) {
    solver::Options o;
    o.threads = 1;
    sim = std::make_unique<solver::Simulation>(c, model, cases::GroundMotion{}, o);
    sim->start_shaking();
  }
  void until(double time) {
    while (sim->time() < time - 0.5 * sim->dt()) sim->step({});
  }
  [[nodiscard]] const solver::Elements& elements() const { return sim->world().elements; }
  cases::Case c;
  cases::Model model;
  std::unique_ptr<solver::Simulation> sim;
};

/// The block that slides: joined to the plank by a bond that the first step breaks, or put down on it from a little above.
cases::Case slider(bool joined, double slope) {
  const double gap = joined ? 0.0 : 1e-4;
  cases::Case c = on_a_plank({block("slider", "wood", {0.0, 0.0, gap}, {0.2, 0.2, 0.05 + gap})}, slope);
  if (joined) {
    c.joint_laws["bond"] = {
        .tension = 1.0, .cohesion = 1.0, .friction = 3.0, .compression = 1e7};  // its own angle is not that of what follows
    c.failure.post_shear = cases::PostShear::brittle;
    c.joints.default_law = "bond";
  }
  return c;
}

}  // namespace

TEST_CASE("friction: wood on wood slides at its angle, whether it was joined there, came there, or has left its joint") {
  for (const bool joined : {true, false}) {
    CAPTURE(joined);
    Run rests(slider(joined, kPhi - 0.5));
    CHECK(rests.sim->world().model.assembly.joints.size() == (joined ? 1 : 0));
    rests.until(0.5);
    const double at_rest = rests.elements().vx[1];
    CHECK(std::abs(at_rest) < 1e-3);
    Run slides(slider(joined, kPhi + 6.0));
    const double angle = (kPhi + 6.0) * std::numbers::pi / 180.0;
    const double expected = kGravity * (std::sin(angle) - tan_of(kPhi) * std::cos(angle));
    for (const double from : {0.1, 0.4}) {  // on the joint's own side, up to half a segment of slide; and past it
      slides.until(from);
      const double v = slides.elements().vx[1], x = slides.elements().ux[1];
      CAPTURE(x);
      if (joined) CHECK((slides.sim->world().sides.retired[0] != 0) == (from > 0.2));
      slides.until(from + 0.05);
      CHECK((slides.elements().vx[1] - v) / 0.05 == doctest::Approx(expected).epsilon(5e-3));
    }
  }
}

TEST_CASE("friction: bodies that overlap slide at the same angle, and each pair of materials at its own") {
  // A bar falls on its edge across another one on its edge, midway between two points of either: they see nothing, their overlap does.
  for (const char* material : {"wood", "adobe"}) {
    CAPTURE(material);
    const double half = 0.05 * std::numbers::sqrt2, x = 0.3028, z = 2.0 * half - 0.05 + 1e-4;  // m, of the bar's middle
    cases::Case c = on_a_plank({block("bar", material, {x - 0.05, -0.1, z - 0.05}, {x + 0.05, 0.3, z + 0.05})}, 0.0);
    c.blocks[0] = block("rail", "wood", {-0.5, 0.05, -0.1}, {1.5, 0.15, 0.0});
    c.blocks[0].fixed = true, c.blocks[0].free = false;
    c.blocks[0].rotate = {{1.0, 0.0, 0.0}, 45.0, {0.0, 0.1, -0.05}};
    c.blocks[1].rotate = {{0.0, 1.0, 0.0}, 45.0, {x, 0.1, z}};
    c.blocks[1].velocity = {3.0, 0.0, -0.6};  // so fast that it slides as long as they touch
    Run run(c);
    const auto velocity = [&] { return Vec3{run.elements().vx[1], run.elements().vy[1], run.elements().vz[1]}; };
    const auto touch = [&] { return !run.sim->world().overlaps.springs.empty(); };
    while (!touch() && run.sim->time() < 0.02) run.sim->step({});
    REQUIRE(touch());

    while (touch()) run.sim->step({});
    const Vec3 push = velocity() - Vec3{3.0, 0.0, -0.6} + Vec3{0.0, 0.0, kGravity * run.sim->time()};  // per mass, of the contact
    CHECK(push.z > 0.8);
    CHECK(-push.x / push.z == doctest::Approx(tan_of(material[0] == 'w' ? kPhi : 10.0)).epsilon(5e-3));
  }
}
