// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/contact/overlap_contact.h"
#include "solver/run/simulation.h"
#include "tests/divided_box.h"
#include "tests/rounded_stone.h"
#include "tests/solver/small_wall.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kRadius = 0.1, kSize = 0.02;  // m

cases::BlockSpec block(const std::string& name, const geometry::Polyhedron& p, Vec3 velocity) {
  cases::BlockSpec b;
  b.name = name, b.material = "adobe", b.free = true, b.velocity = velocity;
  b.vertices = p.vertices;
  for (const auto& loop : p.faces) b.faces.emplace_back(loop.begin(), loop.end());
  return b;
}

cases::BlockSpec stone(const std::string& name, Vec3 at, Vec3 velocity) {
  return block(name, geometry::moved(rounded_stone(17, 30, kRadius), at), velocity);
}

/// Two stones of 510 faces: one falls upon the other beside its middle, and both come to lie on the base.
cases::Case two_stones() {
  cases::Case c = small_wall(1, 1);
  c.segment_size = kSize;
  c.blocks = {stone("lower", {0, 0, kRadius + 0.001}, {}), stone("upper", {0.04, 0.02, 3.0 * kRadius + 0.02}, {0, 0, -1.0})};
  return c;
}

/// Two boxes turned by an eighth about x and y: an edge of the upper one falls across one of the lower. Edges in so many parts.
cases::Case two_boxes(int parts) {
  cases::Case c = small_wall(1, 1);
  c.segment_size = kSize;
  const geometry::Polyhedron box = divided_box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, parts);
  const geometry::Polyhedron lower = geometry::rotated(box, {1, 0, 0}, 0.785, {}), upper = geometry::rotated(box, {0, 1, 0}, 0.785, {});
  c.blocks = {block("lower", geometry::moved(lower, {0, 0, 0.15}), {}), block("upper", geometry::moved(upper, {0, 0, 0.44}), {0, 0, -1.0})};
  return c;
}

/// m, how deep the two are in each other after each of so many steps.
std::vector<double> depths(const cases::Case& c, int steps) {
  const cases::Model m = cases::build_model(c);
  const cases::GroundMotion still;
  solver::Simulation sim(c, m, still, {});
  std::vector<double> out;
  while (static_cast<int>(out.size()) < steps) {
    sim.step({});
    out.push_back(solver::overlap_of(sim.world(), 0, 1, 0.0).depth);
  }
  return out;
}

}  // namespace

TEST_CASE("boxes of 6 faces with 476 vertices within their edges meet edge across edge as plain boxes do") {
  const std::vector<double> plain = depths(two_boxes(1), 400), divided = depths(two_boxes(40), 400);
  double deepest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    deepest = std::max(deepest, plain[i]);
    if (std::max(plain[i], divided[i]) > 0.0) worst = std::max(worst, std::abs(plain[i] - divided[i]));
  }
  MESSAGE("deepest " << 1e3 * deepest << " mm, depths differ by " << worst << " m at most");
  CHECK(deepest > 5e-3);
  CHECK(worst < 1e-6);
}

TEST_CASE("stones of 510 faces meet, roll off and come to rest, and are never deeper in each other than is allowed") {
  const cases::Case c = two_stones();
  const cases::Model m = cases::build_model(c);
  REQUIRE(m.assembly.elements[0].face_count == 510);
  const cases::GroundMotion still;
  solver::Options plain;
  plain.reference_kernels = true;
  solver::Simulation fast(c, m, still, {}), reference(c, m, still, plain);
  double deepest = 0.0, apart = 0.0;
  int together = 0;
  while (fast.time() < 4.0) {
    fast.step({false, fast.steps() % 100 == 0});
    const solver::World& w = fast.world();
    const solver::Elements& e = w.elements;
    if (together < 100) {  // both kernel sets until they have met; rolling tells them apart
      reference.step({});
      const solver::Elements& r = reference.world().elements;
      for (std::size_t i = 0; i < 2; ++i) apart = std::max({apart, std::abs(e.ux[i] - r.ux[i]), std::abs(e.uz[i] - r.uz[i])});
    }
    const double depth = solver::overlap_of(w, 0, 1, 0.0).depth;
    if (depth > 0.0) ++together;
    deepest = std::max(deepest, depth);
  }
  MESSAGE("deepest " << 1e3 * deepest << " mm, apart by " << apart << " m, residual " << fast.worst_residual());
  const solver::Elements& e = fast.world().elements;
  CHECK(together > 100);
  CHECK(apart < 1e-9);
  CHECK(deepest < solver::allowed_overlap(fast.world(), 0, 1) + 1e-3);
  CHECK(fast.worst_residual() < 1e-3);
  for (std::size_t i = 0; i < 2; ++i) {  // on the base, on a face or as deep on an edge as is allowed
    const double height = e.body[i].ref.z + e.uz[i];
    CHECK(height > 0.97 * kRadius - solver::allowed_overlap(fast.world(), 0, e.base));
    CHECK(height < 1.01 * kRadius);
  }
}
