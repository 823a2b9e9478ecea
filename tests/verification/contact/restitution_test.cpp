// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cases/names.h"
#include "solver/contact/head_on.h"
#include "tests/verification/contact/impact.h"

// contact.restitution: the normal speed at the point of contact after an impact over that before it is the one asked for.
namespace voussoir::testing {
namespace {

struct Fall {
  std::string what;
  cases::Rotation turn;
  double beside = 0.0;  // m, along x, from above the centroid of the brick
};

/// An edge or a corner that lies lowest has the centroid above it. No friction: sliding at the faces beside an edge would take its own
/// share.
const Fall kFalls[] = {
    {"face", {{0, 0, 1}, 0.0, {}}}, {"edge", {{1, 0, 0}, 63.43494882292201, {}}}, {"corner", {{1, -1, 0}, 70.52877936550931, {}}}};

struct Outcome {
  double restitution = 0.0, residual = 0.0;
  double of_dashpots = 0.0;  // by solver::restitution_of at this step
  bool parted = false;
};

/// The impulse J of an impact fixes its line of action: along it a body at rest and one that flies without spin meet with -twist . J and
/// part with twist' . J, in any point of it. With J = M (twist' - twist) this needs only energies. \param v  m/s, of the body before
double restitution_of(double mass, Vec3 v, Vec3 after, double kinetic) {
  const double both = 0.5 * mass * dot(v, after);
  return (kinetic - both) / (0.5 * mass * dot(v, v) - both);
}

/// \param of_bound  step over that of "auto" \param gap  m, between the two at first
Outcome outcome_of(const Fall& f, double speed, std::optional<double> restitution, double of_bound, double gap) {
  cases::Case c = empty_case("restitution");
  c.contact.restitution = restitution, c.contact.friction = 0.0;
  c.blocks.push_back(block_of(Shape::brick, "brick", {}, {}, {}));
  const auto shape = geometry::rotated(geometry::make_prism(profile_of(Shape::brick), -0.1, 0.1), f.turn.axis, radians(f.turn.angle), {});
  const double up = 0.05 - geometry::bounds(shape).low.z + gap;
  c.blocks.push_back(block_of(Shape::brick, "body", f.turn, {f.beside, 0.0, up}, {0.0, 0.0, -speed}));
  c.time.step = of_bound * solver::choose_step(c, {}, cases::census(cases::build_model(c)).step_bound);
  ExactRun run(std::move(c), reference_kernels());
  const solver::Elements& e = run.elements();
  Outcome o;
  const cases::Census n = cases::census(run.sim().world().model);
  o.of_dashpots = solver::restitution_of(solver::head_on(run.sim().world(), n.step_element, n.step_face));
  bool met = false;
  run.sim().step({false, true});
  for (const double end = (gap + 0.03) / speed + 0.05; !o.parted && run.sim().time() < end;) {
    run.sim().step({false, true});
    const solver::EnergyRow& row = run.sim().energy();
    o.residual = std::max(o.residual, std::abs(row.residual));
    met = met || row.contact > 0.0;
    o.restitution = restitution_of(e.mass[1], {0.0, 0.0, -speed}, {e.vx[1], e.vy[1], e.vz[1]}, row.kinetic);
    o.parted = met && row.contact == 0.0 && o.restitution > 0.0;
  }
  return o;
}

/// A row of the manual for each kind of fall and restitution: the greatest error over speeds, steps and instants of meeting.
void sweep(const std::vector<double>& steps, int instants, const std::string& name) {
  for (const Fall& f : kFalls) {
    for (const double restitution : {0.2, 0.5, 0.8}) {
      double error = 0.0, residual = 0.0;
      for (const double speed : {0.1, 1.0, 5.0}) {
        for (const double of_bound : steps) {
          for (int k = 0; k < instants; ++k) {
            const Outcome o = outcome_of(f, speed, restitution, of_bound, 1e-4 + 1e-4 * speed * of_bound * k / instants);
            CHECK(o.parted);
            error = std::max(error, std::abs(o.restitution - restitution)), residual = std::max(residual, o.residual);
          }
        }
      }
      expect_below(name + ", " + f.what + ": greatest error of the restitution " + cases::text(restitution), error, 0.02);
      CHECK(residual <= 1e-4);
    }
  }
}

/// \return the greatest error over e and speeds for a body that falls on an edge tilted by so many degrees, off the centre
double error_at_tilt(double degrees) {
  double error = 0.0;
  for (const double restitution : {0.2, 0.5, 0.8}) {
    for (const double speed : {0.1, 1.0, 5.0}) {
      const Outcome o = outcome_of({"edge", {{1, 0, 0}, degrees, {}}, 0.01}, speed, restitution, 1.0 / 3.0, 1e-4);
      CHECK(o.parted);
      error = std::max(error, std::abs(o.restitution - restitution));
    }
  }
  return error;
}

/// A block of 0.2 x 0.2 x 0.8 m that is let go on one edge, tilted. \return s, until it is upright; 1 if it is not by then
double time_to_upright(double tilt, double restitution) {
  cases::Case c = empty_case("restitution");
  c.gravity.acceleration = {0.0, 0.0, -kGravity}, c.gravity.settle = false;
  c.contact.restitution = restitution;
  c.base = cases::Base{};
  cases::BlockSpec b;
  b.name = "block", b.material = "adobe", b.free = true;
  b.box = {Vec3{-0.1, -0.1, 1e-5}, Vec3{0.1, 0.1, 0.8 + 1e-5}};
  b.rotate = cases::Rotation{{0.0, 1.0, 0.0}, tilt * 180.0 / kPi, {0.1, 0.0, 1e-5}};
  c.blocks.push_back(b);
  ExactRun run(std::move(c), reference_kernels());
  const solver::Elements& e = run.elements();
  while (run.sim().time() < 1.0 && tilt + 2.0 * std::atan2(e.qy[0], e.qw[0]) > 0.0) run.sim().step({});
  return run.sim().time();
}

}  // namespace

TEST_CASE("restitution: what `check` says of the dashpots is what two elements that meet face to face give back") {
  for (const double of_bound : {1.0, 0.5, 0.1, 0.02}) {
    double got = 0.0, said = 0.0;
    constexpr int kInstants = 8;
    for (int k = 0; k < kInstants; ++k) {
      const Outcome o = outcome_of(kFalls[0], 1.0, std::nullopt, of_bound, 1e-4 + 2e-4 * of_bound * (k + 0.5) / kInstants);
      got += o.restitution / kInstants, said = o.of_dashpots;
    }
    expect_within("restitution of the dashpots, face to face, at " + cases::text(of_bound) + " of the bound", said, got, 0.01);
  }
}

TEST_CASE("restitution: two free bodies part with the share of their speed that is asked for") {
  sweep({1.0, 1.0 / 3.0, 0.1, 1.0 / 30.0, 0.01}, 1, "restitution");
}

// Flatter, the body turns and meets the other with a second edge.
TEST_CASE("restitution: an edge at any tilt pushes where it is") {
  for (double degrees = 15.0; degrees <= 75.0; degrees += 5.0)
    expect_below("restitution, edge tilted by " + cases::text(degrees) + " degrees: greatest error", error_at_tilt(degrees), 0.02);
}

// Without contact.restitution it rocks about its outermost row of points (V4).
TEST_CASE("restitution: a tilted block turns about its edge") {
  constexpr double half = 0.1, half_height = 0.4, tilt = 0.12;
  const double radius = std::hypot(half, half_height), alpha = std::atan(half / half_height);
  const double rate = std::sqrt(0.75 * kGravity / radius);  // Housner 1963: of a box, about an edge
  const double expected = std::acosh(1.0 / (1.0 - tilt / alpha)) / rate;
  for (const double restitution : {0.2, 0.5, 0.8})
    expect_near("restitution " + cases::text(restitution) + ", a tilted block: time to upright [s]", time_to_upright(tilt, restitution),
                expected, 0.03);
}

TEST_CASE("restitution: two free bodies part with the share of their speed that is asked for, whenever they meet" * doctest::skip()) {
  sweep({1.0, 1.0 / 3.0, 0.1, 1.0 / 30.0, 0.01}, 8, "restitution, whenever they meet");
}

}  // namespace voussoir::testing
