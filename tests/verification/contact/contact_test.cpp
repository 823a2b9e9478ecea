// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <vector>

#include "tests/verification/contact/contact_by_hand.h"
#include "tests/verification/fixture.h"

// V11, and: contact may never give out more energy than it took.
namespace voussoir::testing {
namespace {

/// Opens the pair by 1 mm, then presses it by up to 10 µm twice while it shears to and fro; s in 0 ... 3.
Vec3 path(double s) {
  if (s < 1.0) return {0.0, 0.0, 0.5e-3 * (1.0 - std::cos(2 * kPi * s))};
  return {2e-5 * std::sin(5 * kPi * (s - 1.0)), 1e-5 * std::sin(3 * kPi * (s - 1.0)), -1e-5 * std::sin(2 * kPi * (s - 1.0))};
}

struct Trace {
  std::vector<Vec3> force, moment;
  solver::Damage damage;
};

/// Forces on the upper brick along the path; `gap` is how far from the lower one it begins.
Trace follow(cases::Case c, double gap) {
  c.loads.clear();
  c.blocks[1].free = true;
  for (Vec3& corner : *c.blocks[1].box) corner.z += gap;
  Run run(c);
  const int steps = 6000;
  Trace trace;
  Vec3 last = path(0.0);
  for (int i = 0; i <= steps; ++i) {
    const Vec3 u = path(3.0 * i / steps);
    place(run, 1, u - Vec3{0.0, 0.0, gap}, (u - last) / run.sim().dt());
    run.cycle({true, false});
    const solver::ForcesRow& f = run.sim().forces();
    trace.force.push_back(f.base_shear);
    trace.moment.push_back(f.base_moment);
    last = u;
  }
  trace.damage = run.sim().damage();
  return trace;
}

/// What Eqs. 2 and 8 to 10 ask of the path, once the faces have parted: the force on the upper brick and its moment about the origin, as a
/// uniform traction acts half way between the two centres. The lower brick is fixed, so the upper one's β alone counts.
Trace by_hand(double step) {
  const Vec3 centre{0.1, 0.05, 0.1};  // m, of the faces
  const double area = 0.02, l = 0.05;
  const double beta = face_damping_bound({0.2, 0.1, 0.1}, Adobe::plane, Adobe::shear, Adobe::density, 1.0);
  PointByHand point(ContactByHand::between_likes(Adobe::plane, Adobe::shear, Adobe::density, l, 1.0, step * beta, std::tan(radians(32.0))));
  const int steps = 6000;
  Trace trace;
  Vec3 last = path(0.0);
  for (int i = 0; i <= steps; ++i) {
    const Vec3 u = path(3.0 * i / steps), f = area * point.step(u.z, (u - last) / step, step);
    trace.force.push_back(f);
    trace.moment.push_back(cross(centre + 0.5 * u, f));
    last = u;
  }
  return trace;
}

/// Largest difference from the opening on, relative to the largest value.
double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0, scale = 0.0;
  for (std::size_t i = a.size() / 4; i < a.size(); ++i) {
    most = std::max(most, norm(a[i] - b[i]));
    scale = std::max(scale, norm(a[i]));
  }
  return most / scale;
}

/// Of runs in which nothing but contact acts besides gravity, the largest shares of the energy in play. Above the start nothing is excused
/// but the error of the ledger; in between, a contact that opens inside a step gives back up to k v² Δt²/8, and edges that turn under load
/// cost the ledger a few 1e-4, both falling with Δt.
struct Gain {
  double above_start = 0.0, rise = 0.0, from_dashpots = 0.0, from_friction = 0.0, residual = 0.0;

  void watch(Run& run, double end) {
    run.cycle({false, true});
    const solver::EnergyRow start = run.sim().energy();
    double play = start.kinetic;  // and the fall of the centroids by half a brick's length
    for (std::size_t i = 0; i < run.count(); ++i) play += run.mass(i) * norm(run.description().gravity.acceleration) * 0.1;
    double least = mechanical(start);
    run.until(end, {false, true}, [&] {
      const solver::EnergyRow& e = run.sim().energy();
      least = std::min(least, mechanical(e));
      above_start = std::max(above_start, (mechanical(e) - mechanical(start)) / play);
      rise = std::max(rise, (mechanical(e) - least) / play);
      from_dashpots = std::max(from_dashpots, -e.dashpot / play);
      from_friction = std::max(from_friction, -e.friction / play);
      residual = std::max(residual, e.residual);
    });
    CHECK(run.sim().energy().dashpot + run.sim().energy().friction > 0.0);
  }
  void expect(const std::string& what) const {
    expect_below("contact, " + what + ": energy above the start, over that in play", above_start, 1e-4);
    expect_below("contact, " + what + ": largest rise of energy, over that in play", rise, 1e-3);
    expect_below("contact, " + what + ": energy out of dashpots, over that in play", from_dashpots, 1e-3);
    expect_below("contact, " + what + ": energy out of friction, over that in play", from_friction, 1e-3);
    expect_below("contact, " + what + ": residual of the ledger", residual, 1e-3);
  }
};

}  // namespace

TEST_CASE("V11: a pair broken in tension presses and rubs like one never bonded") {
  cases::Case bonded = load("couplet").value;
  bonded.joint_laws["normal"].thickness = 0.0;
  bonded.contact.friction = bonded.joint_laws["normal"].friction;
  bonded.damping = {};
  cases::Case dry = bonded;
  dry.joints.default_law = "dry";
  const Trace broken = follow(bonded, 0.0), never = follow(dry, 0.0), met = follow(dry, 2e-3);
  CHECK(broken.damage.bonded == 0);
  CHECK(broken.damage.tension > 0);
  const Trace expected = by_hand(*bonded.time.step);
  for (const auto& [what, got] :
       {std::pair{"broken joint", &broken}, std::pair{"dry joint", &never}, std::pair{"blocks that meet", &met}}) {
    expect_below(std::string("V11 force against Eqs. 8 to 10 by hand, ") + what, difference(expected.force, got->force), 1e-9);
    expect_below(std::string("V11 moment against Eqs. 8 to 10 by hand, ") + what, difference(expected.moment, got->moment), 1e-9);
  }
}

struct Jump {
  double normal = 0.0;            // largest change of the normal force in a step, over the force
  double along = 0.0, arm = 0.0;  // m: of the force along the slide, over the normal one; of the moment about the brick's centroid, over it
};

/// A brick slides by half a segment over the base or a longer brick, tilted, its outer row of points `depth` under the face. On a brick,
/// joint and patches measure depths that differ by half of tilt × slide, or twice that from patch to patch. Nothing if the joint is open.
std::optional<Jump> largest_jump(bool on_brick, double tilt, double depth) {
  const double half_segment = 0.0125, half_length = 0.1;  // m
  cases::Case c = load("couplet").value;
  c.joints.default_law = "dry";
  c.loads.clear();
  if (on_brick) {
    c.blocks[0].box->at(0).x -= 0.1, c.blocks[0].box->at(1).x += 0.1;
  } else {
    c.blocks.pop_back(), c.base.emplace();
  }
  c.blocks.back().fixed = false;
  c.segment_size = 2 * half_segment;
  c.output.history.clear();
  Run run(c);
  const std::size_t moved = run.count() - 1;
  solver::Elements& e = run.sim().world().elements;
  Vec3 force, arm;
  Jump jump;
  const int steps = 400;
  const double part = 5e-6;  // m
  const double lift = (half_length - half_segment) * std::sin(std::abs(tilt)) - 0.05 * (1.0 - std::cos(tilt)) - depth;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 u{half_segment + 0.05 * std::sin(tilt) - 0.5 * steps * part + i * part, 0.0, lift};
    place(run, moved, u, {part / run.sim().dt(), 0.0, 0.0});
    e.qw[moved] = std::cos(0.5 * tilt), e.qy[moved] = std::sin(0.5 * tilt);
    kernels::drift(e.view(), run.sim().world().element_rows(), 0.0, 0, e.rows);
    const Vec3 x = run.position(moved);
    run.cycle({true, false});
    const solver::ForcesRow& now = run.sim().forces();
    if (i == 0 && now.base_shear.z == 0.0) return std::nullopt;
    const Vec3 moment = (1.0 / now.base_shear.z) * (now.base_moment - cross(x, now.base_shear));
    if (i > steps / 4) {  // by then friction has built up; the joint comes apart half way
      jump.normal = std::max(jump.normal, std::abs(now.base_shear.z - force.z) / std::max(now.base_shear.z, force.z));
      jump.along = std::max(jump.along, std::abs(now.base_shear.x / now.base_shear.z - force.x / force.z));
      jump.arm = std::max(jump.arm, norm(moment - arm));
    }
    force = now.base_shear, arm = moment;
  }
  const solver::Sides& sides = run.sim().world().sides;
  for (std::size_t id = 0; id < sides.joint.size(); ++id) CHECK((sides.joint[id] < 0 || sides.retired[id] == 1));
  return jump;
}

TEST_CASE("contact goes on without a jump where a joint comes apart: a tilted brick slides by half a segment") {
  Jump most;
  int touching = 0;
  for (const bool on_brick : {false, true}) {
    for (const double tilt : {1e-3, -1e-3, 0.1, -0.1}) {
      if (on_brick && tilt != 1e-3)
        continue;  // else the row that carries slides off, or depths differ by too much to touch before and after
      for (const double depth : {8.75e-5, 1e-5}) {  // half of the brick inside; one row of segments
        CAPTURE(on_brick);
        CAPTURE(tilt);
        CAPTURE(depth);
        const std::optional<Jump> j = largest_jump(on_brick, tilt, depth);
        if (!j) continue;
        most = {std::max(most.normal, j->normal), std::max(most.along, j->along), std::max(most.arm, j->arm)};
        ++touching;
      }
    }
  }
  CHECK(touching == 10);
  expect_below("contact: largest jump of the normal force in a step, over the force", most.normal, 2e-3);
  expect_below("contact: largest jump of the force along a slide, over the normal one", most.along, 2e-3);
  expect_below("contact: largest jump of the force's arm about the brick [m]", most.arm, 1e-4);
}

/// What changes in the step in which a tilted joint of two bricks comes apart, over what there was.
struct HandOver {
  double force = 0.0, energy = 0.0;
};

/// A brick stands on the outer row of points under its end, tilted; its joint comes apart as the tilt passes 0.15 rad (`bonded` false: no
/// bond is left), or as that end, whose bonds hold at any tilt, has slid by half a segment along the joint's mean tangent, forwards or
/// back.
HandOver hand_over(bool bonded, double tilt, double way) {
  const double half_segment = 0.0125, row = 0.1 - half_segment, depth = 3e-5;  // m
  cases::Case c = load("couplet").value;
  c.loads.clear();
  c.blocks[0].box->at(0).x -= 0.1, c.blocks[0].box->at(1).x += 0.1;
  c.blocks[1].free = true;
  c.segment_size = 2 * half_segment;
  // Bonds that open at once where the faces part, and slip like a contact where they are pressed together.
  c.joint_laws["normal"].tension = 1.0, c.joint_laws["normal"].cohesion = 1e-3, c.joint_laws["normal"].compression = 1e12;
  if (!bonded) c.joints.default_law = "dry";
  Run run(c);
  solver::Elements& e = run.sim().world().elements;
  const auto put = [&](double t, double slide, double rate) {
    // Its lower right row stays where it was, but for the depth and the slide, both in the joint's own axes, which lie half way.
    const Vec3 normal{std::sin(0.5 * t), 0.0, std::cos(0.5 * t)}, tangent{normal.z, 0.0, -normal.x};
    const Vec3 u = Vec3{row - (row * std::cos(t) - 0.05 * std::sin(t)), 0.0, row * std::sin(t) - 0.05 * (1.0 - std::cos(t))} -
                   depth * normal + slide * tangent;
    place(run, 1, u, (rate / run.sim().dt()) * tangent);
    e.qw[1] = std::cos(0.5 * t), e.qy[1] = std::sin(0.5 * t);
    kernels::drift(e.view(), run.sim().world().element_rows(), 0.0, 0, e.rows);
    run.cycle({true, true});
  };
  const auto apart = [&] {
    const solver::Sides& s = run.sim().world().sides;
    return std::ranges::any_of(s.retired,
                               [&](const auto& r) { return r == 1 && s.joint[static_cast<std::size_t>(&r - s.retired.data())] >= 0; });
  };
  const int coarse = 2000, fine = 400;
  for (int i = 0; i < coarse; ++i)
    put(tilt * (bonded ? std::min(1.0, 2.0 * i / coarse) : 1.0 * i / coarse),
        bonded ? way * half_segment * std::max(0.0, 2.0 * i / coarse - 1.0) : 0.0, 0.0);
  CHECK(!apart());
  HandOver most;
  Vec3 force;
  double energy = 0.0;
  for (int i = 0; i < fine && !apart(); ++i) {
    bonded ? put(tilt, way * (half_segment + 1e-8 * i), way * 1e-8) : put(tilt + 1e-6 * i, 0.0, 0.0);
    force = run.sim().forces().base_shear, energy = run.sim().energy().contact + run.sim().energy().strain;
  }
  REQUIRE(apart());
  REQUIRE(force.z > 0.0);
  bonded ? put(tilt, way * (half_segment + 2e-8), 0.0) : put(tilt + 2e-6, 0.0, 0.0);
  most.force = norm(run.sim().forces().base_shear - force) / norm(force);
  most.energy = std::abs(run.sim().energy().contact + run.sim().energy().strain - energy) / energy;
  return most;
}

TEST_CASE("contact goes on without a jump where a joint comes apart: at the tilts of bricks that rock and fall") {
  HandOver most;
  const auto look = [&](bool bonded, double tilt, double way) {
    const HandOver now = hand_over(bonded, tilt, way);
    MESSAGE(bonded, " ", tilt, " ", way, ": force ", now.force, ", energy ", now.energy);
    most = {std::max(most.force, now.force / (tilt * tilt)), std::max(most.energy, now.energy / (tilt * tilt))};
  };
  // The joint pushes along the mean normal, the two patches half along each face's: together by cos(tilt/2) of it, 1 − tilt²/8. Friction
  // turns with them.
  look(false, 0.15 - 1e-4, 0.0);
  for (const double tilt : {0.15, 0.2, 0.3, 0.5}) {
    for (const double way : {1.0, -1.0}) look(true, tilt, way);
  }
  expect_below("contact: jump of the force where a joint tilted by 0.15 to 0.5 rad comes apart, over the force and the tilt squared",
               most.force, 0.2);
  expect_below("contact: jump of the springs' energy there, over that energy and the tilt squared", most.energy, 0.2);
}

TEST_CASE("contact stops what falls by more than 3 mm in a step") {
  for (int i = 0; i < 8; ++i) {
    const double z = 0.02 + 7e-4 * i;  // so that it arrives at another part of its step each time
    const std::string box = "block[0].box=[[0,0," + std::to_string(z) + "],[0.5,0.5," + std::to_string(0.5 + z) + "]]";
    Run run("drop", {box, "block[0].rotate=", "block[0].velocity=[0.0,0.0,-5.5]", "time.step=1e-3"});
    double lowest = 0.0;
    run.until(0.1, {}, [&] { lowest = std::min(lowest, run.position(0).z - 0.25); });
    CAPTURE(z);
    CAPTURE(lowest);
    CHECK(lowest > -0.03);
    CHECK(run.velocity(0).z > -1.0);
  }
}

TEST_CASE("contact gives out no more energy than it took: bricks dropped") {
  struct Fall {
    const char *name, *axis;
    double angle;
  };
  Gain gain;
  for (const Fall& f :
       {Fall{"flat", "[0,0,1]", 0.0}, Fall{"almost flat", "[0,1,0]", 1.0}, Fall{"on its long edge", "[1,0,0]", 30.0},
        Fall{"on its short edge", "[0,1,0]", 40.0}, Fall{"on a corner", "[1,1,0.3]", 45.0}, Fall{"upright", "[0,1,0]", 90.0}}) {
    for (const double speed : {0.1, 1.0, 4.0}) {
      const std::string v = std::to_string(speed);
      Run run("drop", {std::string("block[0].rotate.axis=") + f.axis, "block[0].rotate.angle=" + std::to_string(f.angle),
                       "block[0].velocity=[" + std::to_string(0.3 * speed) + ",0.0,-" + v + "]"});
      CAPTURE(f.name);
      CAPTURE(speed);
      gain.watch(run, 0.5);
    }
  }
  gain.expect("bricks dropped");
}

TEST_CASE("contact gives out no more energy than it took: a brick rocks from corner to corner at the step that the program chooses") {
  Gain gain;
  double speed_left = 0.0, height_left = 0.0;
  for (const char* turn : {"0.001", "0.002", "0.005", "0.01"}) {
    for (const char* speed : {"1.5", "1.75"}) {
      Run run("edge_drop",
              {"block[0].rotate.axis=[1.0,0.0," + std::string(turn) + "]", "block[0].velocity=[0.0,0.0,-" + std::string(speed) + "]"});
      gain.watch(run, 4.0);
      speed_left = std::max(speed_left, norm(run.velocity(0)));
      height_left = std::max(height_left, std::abs(run.position(0).z - 0.05));
    }
  }
  const std::string what = "contact, a brick rocks from corner to corner: ";
  expect_below(what + "energy above the start, over that in play", gain.above_start, 1e-4);
  expect_below(what + "residual of the ledger", gain.residual, 1e-3);
  expect_below(what + "speed at the end [m/s]", speed_left, 1e-6);
  expect_below(what + "height at the end off that of a brick that lies [m]", height_left, 1e-5);
}

// THEORY.md (21b). The axes and speeds are some of 150 by chance at which the ledger was off by 0.2 to 6 % while the force acted at the
// corner that was the deeper one before it had acted.
TEST_CASE("contact gives out no more energy than it took: the corners of an edge take turns while a brick is turned back") {
  double residual = 0.0;
  for (const auto& [turn, speed] : {std::pair{"0.000751536", "1.827"},
                                    {"0.00084122", "1.823"},
                                    {"0.00112218", "1.822"},
                                    {"0.000829065", "1.409"},
                                    {"0.000540853", "1.812"},
                                    {"0.00375879", "1.125"}}) {
    Run run("edge_drop",
            {"block[0].rotate.axis=[1.0,0.0," + std::string(turn) + "]", "block[0].velocity=[0.0,0.0,-" + std::string(speed) + "]"});
    run.cycle({false, true});
    run.until(0.06, {false, true}, [&] { residual = std::max(residual, run.sim().energy().residual); });
  }
  expect_below("contact, corners of an edge take turns: residual of the ledger", residual, 1e-4);
}

TEST_CASE("contact gives out no more energy than it took: a brick slides into a step") {
  Gain gain;
  for (const char* speed : {"0.9", "2.0", "4.0"}) {
    Run run("slide_step", {std::string("block[0].velocity=[") + speed + ",0.0,0.0]"});
    CAPTURE(speed);
    gain.watch(run, 0.5);
  }
  gain.expect("a brick slides into a step");
}

TEST_CASE("contact gives out no more energy than it took: bricks collide") {
  Gain gain;
  for (const double angle : {0.0, 25.0, 50.0}) {
    Run run("collision", {"block[1].rotate.angle=" + std::to_string(angle)});
    const double before = run.mass(1) * norm(run.velocity(1));
    CAPTURE(angle);
    gain.watch(run, 0.3);
    Vec3 after;
    for (std::size_t i = 0; i < 2; ++i) after += run.mass(i) * run.velocity(i);
    CHECK(norm(after - Vec3{before, 0.0, 0.0}) < 1e-12 * before);
    CHECK(run.velocity(0).x > 0.0);  // it was hit
  }
  gain.expect("bricks collide");
}

}  // namespace voussoir::testing
