// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/run/simulation.h"
#include "solver/schedule/colouring.h"
#include "solver/setup/setup.h"
#include "solver/world/errors.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

double furthest_apart(const solver::Simulation& a, const solver::Simulation& b) {
  double worst = 0.0;
  for (std::size_t e = 0; e < static_cast<std::size_t>(a.world().elements.count); ++e) {
    const solver::Elements &p = a.world().elements, &q = b.world().elements;
    worst = std::max(worst, norm({p.ux[e] - q.ux[e], p.uy[e] - q.uy[e], p.uz[e] - q.uz[e]}));
  }
  return worst;
}

double largest_displacement(const solver::Simulation& s) {
  double worst = 0.0;
  for (std::size_t e = 0; e < static_cast<std::size_t>(s.world().elements.count); ++e) {
    worst = std::max(worst, norm({s.world().elements.ux[e], s.world().elements.uy[e], s.world().elements.uz[e]}));
  }
  return worst;
}

}  // namespace

TEST_CASE("decomposition: no two tasks of a colour share an element, every side has one place") {
  // A wall of 20 by 6 bricks, one beam along all of it, and sides on the base.
  std::vector<Vec3> centroids;
  std::vector<solver::Writes> sides;
  for (int x = 0; x < 20; ++x) {
    for (int z = 0; z < 6; ++z) {
      const auto e = static_cast<std::int32_t>(centroids.size());
      centroids.push_back({0.2 * x + 0.1 * (z % 2), 0.0, 0.1 * z});
      sides.push_back({e, z == 0 ? -1 : e - 1});
      if (x > 0) sides.push_back({e, e - 6});
      if (x > 0 && z % 2 == 0 && z > 0) sides.push_back({e, e - 7});
    }
  }
  const auto beam = static_cast<std::int32_t>(centroids.size());
  centroids.push_back({2.0, 0.0, 0.6});
  for (int x = 0; x < 20; ++x) sides.push_back({beam, 6 * x + 5});
  std::vector<std::int32_t> kinds(sides.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = static_cast<std::int32_t>(i % 3);
  for (const bool out_of_cache : {false, true}) {
    const solver::Decomposition d = solver::decompose(sides, kinds, centroids, 0.25, out_of_cache);
    CHECK(d.colours.size() == 4);
    std::vector<int> placed(sides.size(), 0);
    for (const std::int32_t i : d.overflow) ++placed[static_cast<std::size_t>(i)];
    for (const auto& tasks : d.colours) {
      std::vector<int> owner(centroids.size(), -1);
      for (std::size_t t = 0; t < tasks.size(); ++t) {
        for (const std::int32_t i : tasks[t]) {
          ++placed[static_cast<std::size_t>(i)];
          for (const std::int32_t e : sides[static_cast<std::size_t>(i)]) {
            if (e < 0) continue;
            int& of = owner[static_cast<std::size_t>(e)];
            CHECK((of == -1 || of == static_cast<int>(t)));
            of = static_cast<int>(t);
          }
        }
      }
    }
    CHECK(std::all_of(placed.begin(), placed.end(), [](int n) { return n == 1; }));
    CHECK(d.overflow.size() > 10);  // the beam's far ends
    CHECK(d.overflow.size() < 20);
  }
  CHECK(solver::choose_cell(sides, centroids, false) > 0.2);
}

TEST_CASE("decomposition: cells of a large model are larger, so that most elements lie within one") {
  const auto cell_of_a_floor = [](int edge, bool out_of_cache = false) {  // of edge × edge slabs, 0.2 m each
    std::vector<Vec3> centroids;
    std::vector<solver::Writes> sides;
    for (int x = 0; x < edge; ++x) {
      for (int y = 0; y < edge; ++y) {
        centroids.push_back({0.2 * x, 0.2 * y, 0.0});
        if (y > 0) sides.push_back({x * edge + y, x * edge + y - 1});
      }
    }
    return solver::choose_cell(sides, centroids, out_of_cache);
  };
  CHECK(cell_of_a_floor(70) == doctest::Approx(std::sqrt(32.0) * 0.2).epsilon(0.02));         // thirty-two slabs of 4,900
  CHECK(cell_of_a_floor(71) == doctest::Approx(8 * 0.2).epsilon(0.02));                       // sixty-four of 5,041
  CHECK(cell_of_a_floor(71, true) == doctest::Approx(std::sqrt(512.0) * 0.2).epsilon(0.02));  // five hundred and twelve
}

TEST_CASE("decomposition: in a task of an out-of-cache model full blocks of one kind come first") {
  // Columns of two bricks in one cell: sides of three kinds, twenty-one of each.
  std::vector<Vec3> centroids;
  std::vector<solver::Writes> sides;
  std::vector<std::int32_t> kinds;
  for (int k = 0; k < 63; ++k) {
    centroids.insert(centroids.end(), {{0.01 * k, 0.0, 0.0}, {0.01 * k, 0.0, 0.1}});
    sides.push_back({2 * k, 2 * k + 1}), kinds.push_back(k % 3);
  }
  const auto kinds_in_order = [&](bool out_of_cache) {
    const solver::Decomposition d = solver::decompose(sides, kinds, centroids, 10.0, out_of_cache);
    std::vector<std::int32_t> order;
    for (const std::int32_t i : d.colours.at(0).at(0)) order.push_back(kinds[static_cast<std::size_t>(i)]);
    return order;
  };
  std::vector<std::int32_t> near, far;  // twenty-one of each; sixteen of each, then five
  for (int kind = 0; kind < 3; ++kind) near.insert(near.end(), 21, kind), far.insert(far.end(), 16, kind);
  for (int kind = 0; kind < 3; ++kind) far.insert(far.end(), 5, kind);
  CHECK(kinds_in_order(false) == near);
  CHECK(kinds_in_order(true) == far);
}

TEST_CASE("fast and reference kernels: the same wall until it cracks, then the same segments break in the same order") {
  const cases::Case c = small_wall(4, 6);
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion g = strong_shaking();
  solver::Options plain;
  plain.reference_kernels = true;
  solver::Simulation fast(c, m, g, {}), reference(c, m, g, plain);
  int i = 0;
  for (; fast.damage().tension == 0; ++i) fast.step({}), reference.step({});
  CHECK(furthest_apart(fast, reference) < 1e-10 * largest_displacement(fast));
  CHECK(fast.damage().tension == reference.damage().tension);
  for (const int end = i + 1500; i < end; ++i) fast.step({false, true}), reference.step({false, true});
  REQUIRE(std::min(fast.cracks().size(), reference.cracks().size()) > 200);
  for (std::size_t k = 0; k < 200; ++k) {  // the same segments in the same order
    const solver::CrackRow &a = fast.cracks()[k], &b = reference.cracks()[k];
    CAPTURE(k);
    CHECK(a.time == b.time);
    CHECK(a.joint == b.joint);
    CHECK(a.mode == b.mode);
    CHECK(norm(a.position - b.position) < 1e-6);
  }
  CHECK(fast.energy().input == doctest::Approx(reference.energy().input).epsilon(1e-6));
}

TEST_CASE("internal forces cancel: a floating cluster keeps its momenta to round-off and its energy") {
  cases::Case c = small_wall(3, 3, 1e6);
  c.base.reset();
  c.gravity.acceleration = {0, 0, 0};
  c.damping.alpha = 0.0;
  for (auto& b : c.blocks) b.free = true;
  // Spinning as one body about the centre (0.3, 0.05, 0.15).
  const Vec3 spin{0.3, -0.2, 0.5}, centre{0.3, 0.05, 0.15}, drift{0.1, 0.2, -0.3};
  for (auto& b : c.blocks) {
    const Vec3 x = 0.5 * ((*b.box)[0] + (*b.box)[1]);
    b.velocity = drift + cross(spin, x - centre), b.angular_velocity = spin;
  }
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion still;
  solver::Simulation s(c, m, still, {});
  const auto momenta = [&](Vec3& linear, Vec3& angular) {
    linear = angular = {};
    const solver::Elements& e = s.world().elements;
    for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
      const Vec3 p = e.mass[i] * Vec3{e.vx[i], e.vy[i], e.vz[i]};
      const Vec3 x = e.body[i].ref + Vec3{e.ux[i], e.uy[i], e.uz[i]};
      linear += p, angular += cross(x, p) + Vec3{e.lx[i], e.ly[i], e.lz[i]};
    }
  };
  Vec3 p0, l0, p1, l1;
  momenta(p0, l0);
  s.step({false, true});
  const double energy = s.energy().kinetic;
  for (int i = 0; i < 20000; ++i) s.step({false, i % 500 == 0});
  momenta(p1, l1);
  CHECK(norm(p1 - p0) < 1e-12 * norm(p0));
  CHECK(norm(l1 - l0) < 1e-12 * (norm(l0) + norm(p0)));
  CHECK(s.energy().kinetic + s.energy().strain == doctest::Approx(energy).epsilon(1e-6));
}

TEST_CASE("the base carries the weight of a wall at rest, at its middle") {
  cases::Case c = small_wall(4, 6, 100.0);
  c.gravity.settle = true;
  c.gravity.ramp = 0.2;
  c.output.history = {{"top", {0.4, 0.05, 0.55}}};
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion still;
  solver::Simulation s(c, m, still, {});
  while (!s.at_rest() && !s.settled_too_long()) s.step({false, s.steps() % 100 == 0});
  CHECK(s.at_rest());
  s.start_shaking();
  s.step({true, true});
  const double weight = 0.8 * 0.1 * 0.6 * 1800.0 * 9.8;
  CHECK(s.forces().base_shear.z == doctest::Approx(weight).epsilon(1e-3));
  CHECK(s.forces().base_moment.x == doctest::Approx(weight * 0.05).epsilon(1e-3));
  CHECK(s.forces().base_moment.y == doctest::Approx(-weight * 0.4).epsilon(1e-3));
  CHECK(std::abs(s.history()[0].displacement.z) < 1e-9);
}

TEST_CASE("congruent sides share their constants, which fit the place of each") {
  const cases::Model m = cases::build_model(small_wall(30, 6));
  const std::unique_ptr<solver::World> w = solver::build_world(small_wall(30, 6), m, {});
  const solver::Sides& s = w->sides;
  CHECK(2 * s.constants.size() < s.blocks.size());
  const auto centroid = [&](std::int32_t e) {
    const auto i = static_cast<std::size_t>(e);
    return w->elements.body[i].ref;
  };
  for (std::int64_t id = 0; id < s.count(); ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (s.joint[i] < 0) continue;
    const kernels::Side side = s.side(id);
    const Vec3 centre = m.assembly.joints[static_cast<std::size_t>(s.joint[i])].centre;
    CHECK(norm(centroid(side.master) + side.ca - centre) < 1e-11);
    CHECK(norm(centroid(side.slave) + side.cb - centre) < 1e-11);
    const kernels::PointsView points = w->points.view(s.set[i]);
    double area = 0.0, sss = 0.0;
    for (int k = 0; k < points.n; ++k)
      area += side.factor * points.area[k], sss += side.factor * points.area[k] * points.s[k] * points.s[k];
    const kernels::SideBlock& b = s.blocks[i / kernels::kLanes];
    CHECK(std::abs(b.constants->area[i % kernels::kLanes] - area) < 1e-11 * area);
    CHECK(std::abs(b.constants->sss[i % kernels::kLanes] - sss) < 1e-11 * sss);
  }
}

TEST_CASE("while a structure settles its rotations are damped too, and the ledger knows; afterwards they are not") {
  cases::Case c = small_wall(1, 1);
  c.base.reset();
  c.damping.alpha = 0.0;
  c.gravity.settle = true;
  c.gravity.ramp = 0.1;
  c.time.step = 1e-4;
  c.blocks[0].free = true;
  c.blocks[0].angular_velocity = {0.4, -0.3, 0.9};
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion still;
  solver::Simulation s(c, m, still, {});
  const solver::Elements& e = s.world().elements;
  solver::set_initial_velocities(s.world());  // as it does when the shaking begins
  const auto momentum = [&] { return norm(Vec3{e.lx[0], e.ly[0], e.lz[0]}); };
  const double before = momentum(), alpha = e.alpha[0];
  REQUIRE(alpha > 100.0);
  for (int i = 0; i < 200; ++i) s.step({false, true});
  CHECK(momentum() == doctest::Approx(before * std::pow((1.0 - 0.5e-4 * alpha) / (1.0 + 0.5e-4 * alpha), 200)).scale(0.0).epsilon(1e-12));
  CHECK(s.worst_residual() < 1e-6);  // J turns with the body: the trapezoid rule is not exact
  const double lost = s.energy().damping;
  CHECK(lost > 0.9 * s.energy().input);
}

TEST_CASE("without a ramp, or with rows further apart than it, a structure settles until it rests") {
  for (const double ramp : {0.0, 0.01}) {
    cases::Case c = small_wall(2, 3);
    c.gravity.settle = true;
    c.gravity.ramp = ramp;
    c.damping.frequency = 20.0;
    const cases::Model m = cases::build_model(c);
    const cases::GroundMotion still;
    solver::Simulation s(c, m, still, {});
    while (!s.at_rest() && !s.settled_too_long()) s.step({false, s.steps() % 1000 == 0});
    CHECK(s.at_rest());
    CHECK(s.steps() > 1000);
    CHECK(s.energy().strain > 0.0);
  }
}

TEST_CASE("a support whose history begins away from zero stands there from the first step on, and has no speed") {
  cases::Case c = small_wall(1, 1);
  c.base.reset();
  c.gravity.acceleration = {};
  c.time.step = 1e-4;
  c.blocks[0].fixed = true;
  cases::Model m = cases::build_model(c);
  cases::SupportHistory& h = m.support_motions.emplace_back();
  h.time = {0.0, 1.0}, h.displacement = {{0.01, 0.0, 0.0}, {0.01, 0.0, 0.0}};
  m.blocks[0].support_motion = 0;
  const cases::GroundMotion still;
  solver::Simulation s(c, m, still, {});
  const solver::Elements& e = s.world().elements;
  for (int i = 0; i < 3; ++i) {
    s.step({});
    CHECK(e.vx[0] == 0.0);
    CHECK(e.ux[0] == 0.01);
  }
}

TEST_CASE("a block with more faces than a patch can number is refused, one of 162 is not") {
  cases::Case c = small_wall(1, 1);
  cases::BlockSpec b;
  b.name = "drum", b.material = "adobe", b.free = true, b.extrude = {{2.0, 2.2}};
  for (int i = 0; i < 160; ++i)
    b.polygon.push_back({std::cos(0.0125 * 3.141592653589793 * i), 2.0 + std::sin(0.0125 * 3.141592653589793 * i)});
  c.blocks.push_back(b);
  cases::Model m = cases::build_model(c);
  const cases::GroundMotion still;
  CHECK_NOTHROW(solver::Simulation(c, m, still, {}));
  geometry::Element& drum = m.assembly.elements.back();
  REQUIRE(drum.face_count == 162);
  drum.face_count = kernels::kMostFaces + 1;  // no polygon of a test has so many
  m.assembly.faces.resize(static_cast<std::size_t>(drum.first_face + drum.face_count), m.assembly.faces.back());
  CHECK_THROWS_WITH_AS(solver::Simulation(c, m, still, {}), doctest::Contains("65535"), cases::InputError);
}

TEST_CASE("a wedge that falls on its sharpest corner finds hold") {
  // None of the faces at that corner opposes the base by more than half: those that do most must carry it.
  cases::Case c = small_wall(1, 1);
  cases::BlockSpec& wedge = c.blocks.front();
  wedge.box.reset();
  wedge.polygon = {{0.0, 0.1}, {0.05, 0.2}, {-0.05, 0.2}};  // 53 degrees
  wedge.extrude = {{0.0, 0.2}};
  wedge.rotate = cases::Rotation{{0.0, 1.0, 0.0}, 25.0, {0.0, 0.0, 0.02}};
  wedge.free = true;
  const cases::Model m = cases::build_model(c);
  solver::Simulation sim(c, m, {}, {});
  const solver::Elements& e = sim.world().elements;
  CHECK(e.ixz[0] != 0.0);
  CHECK(e.principal[0] == 0);
  const auto lowest = [&] {
    const kernels::Pose pose = kernels::load_pose(e.pose.data(), 0);
    double z = 1e300;
    for (const Vec3& v : m.blocks[0].shape.vertices) {
      const Vec3 r = v - e.body[0].ref;
      z = std::min(z, (v + pose.u + pose.d * r).z);
    }
    return z;
  };
  double least = 0.0;
  for (double t = 0.0; t < 0.8; t += sim.dt()) {
    sim.step({});
    least = std::min(least, lowest());
  }
  CHECK(least > -0.02);  // points lie half a segment from the edge
  CHECK(least < 0.0);
  CHECK(std::abs(e.uz[0]) < 0.1);
  MESSAGE("the lowest corner sank by " << -1e3 * least << " mm");
}

TEST_CASE("the ledger closes where a support that speeds up and slows down works against the dashpots of what stands on it") {
  cases::Case c = small_wall(1, 0);
  c.joints.default_law = "dry";
  c.damping = {};
  c.blocks = {brick(0, 0, 0.0, 0.2), brick(1, 0, 0.0, 0.2)};
  c.blocks[0].fixed = true;
  cases::Model m = cases::build_model(c);
  cases::SupportHistory& motion = m.support_motions.emplace_back();
  for (int i = 0; i <= 400; ++i) {
    const double t = 5e-4 * i, phase = 2.0 * std::numbers::pi * 10.0 * t;
    motion.time.push_back(t), motion.displacement.push_back({2e-4 * std::sin(phase), 0.0, 1e-5 * (1.0 - std::cos(phase))});
  }
  m.blocks[0].support_motion = 0;
  solver::Simulation sim(c, m, {}, {});
  while (sim.time() < 0.2) sim.step({false, true});
  CHECK(sim.energy().dashpot > 0.0);
  CHECK(sim.worst_residual() < 1e-6);
}
