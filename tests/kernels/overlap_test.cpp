// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/contact/overlap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geometry/separation.h"
#include "tests/divided_box.h"
#include "tests/rounded_stone.h"

using namespace voussoir;

namespace {

/// A body as the kernel has it and as geometry has it, about its centroid; small cells, so that nothing is shared but numbers.
struct Body {
  geometry::ConvexBody exact;
  std::vector<kernels::Face> faces;
  std::vector<kernels::Crease> creases;
  [[nodiscard]] kernels::ConvexShape shape() const { return {exact.vertices, exact.directions, faces, creases}; }
};

/// Whether a loop goes straight from one vertex to another.
bool has_edge(const std::vector<std::int32_t>& loop, std::int32_t from, std::int32_t to) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] == from && loop[(i + 1) % loop.size()] == to) return true;
  }
  return false;
}

/// Of all pairs of faces the edges that both have.
std::vector<kernels::Crease> creases_of(const geometry::Polyhedron& p) {
  std::vector<kernels::Crease> out;
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    const auto& loop = p.faces[f];
    for (std::size_t g = 0; g < f; ++g) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::int32_t from = loop[i], to = loop[(i + 1) % loop.size()];
        if (!has_edge(p.faces[g], to, from)) continue;
        const Vec3 along = p.vertices[static_cast<std::size_t>(to)] - p.vertices[static_cast<std::size_t>(from)];
        out.push_back({normalised(along), from, static_cast<std::int32_t>(f), static_cast<std::int32_t>(g)});
      }
    }
  }
  return out;
}

Body body(const geometry::Polyhedron& p) {
  const Vec3 centroid = geometry::mass_properties(p).centroid;
  Body b;
  b.creases = creases_of(p);
  b.exact = geometry::convex_body(geometry::moved(p, -centroid));
  for (const geometry::HalfSpace& f : b.exact.faces) b.faces.push_back({.normal = f.normal, .distance = f.offset});
  return b;
}

std::vector<Body> bodies() {
  using Corners = std::vector<std::array<double, 2>>;
  std::vector<Body> all;
  all.push_back(body(geometry::make_box({0, 0, 0}, {0.2, 0.2, 0.1})));
  all.push_back(body(geometry::make_box({0, 0, 0}, {0.4, 0.1, 0.05})));
  all.push_back(body(geometry::make_prism(Corners{{0, 0}, {0.2, 0}, {0, 0.1}}, 0.0, 0.2)));
  all.push_back(body(geometry::make_prism(Corners{{-0.04, 0}, {0.04, 0}, {0.06, 0.2}, {-0.06, 0.2}}, 0.0, 0.2)));
  all.push_back(body(geometry::make_prism(Corners{{0, 0}, {0.2, 0}, {0.2, 0.08}, {0.1, 0.14}, {0, 0.08}}, 0.0, 0.1)));
  return all;
}

struct Random {
  std::mt19937_64 engine{2026};
  double operator()(double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; }
  static Quaternion about_x(double angle) { return {std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0}; }
  Quaternion turn() {
    for (;;) {
      const Quaternion q{(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)};
      const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
      if (n > 0.1 && n < 1.0) return {q.w / n, q.x / n, q.y / n, q.z / n};
    }
  }
};

/// First b, then a.
Quaternion product(Quaternion a, Quaternion b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

constexpr double kNone = -std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("overlap: 10,000 random pairs are as deep in each other as geometry says, and the axis parts them") {
  const std::vector<Body> all = bodies();
  Random random;
  int deep = 0, apart = 0;
  double worst = 0.0, least_gain = 0.0, asymmetry = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const Body &a = all[static_cast<std::size_t>(i) % 5], &b = all[static_cast<std::size_t>(i) / 5 % 5];
    const Quaternion qa = random.turn(), qb = i % 4 == 0 ? qa : random.turn();  // a quarter of them parallel
    const Vec3 ref_a{random(-10, 10), random(-10, 10), random(0, 5)};
    const Vec3 apart_by{random(-0.2, 0.2), random(-0.2, 0.2), random(-0.2, 0.2)};
    const kernels::Pose pa{{}, rotation_minus_identity(qa)}, pb{{}, rotation_minus_identity(qb)};
    const kernels::Overlap o = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, kNone);
    const kernels::Overlap back = kernels::overlap_of(b.shape(), pb, a.shape(), pa, -apart_by, kNone);
    const geometry::ConvexBody ga = geometry::placed(a.exact, rotation(qa), ref_a);
    const geometry::ConvexBody gb = geometry::placed(b.exact, rotation(qb), ref_a + apart_by);
    const double depth = geometry::penetration_of(ga, gb).depth;
    worst = std::max(worst, std::abs(o.depth - depth));
    asymmetry = std::max(asymmetry, std::abs(o.depth - back.depth));
    CHECK(std::abs(norm(o.normal) - 1.0) < 1e-12);
    // Along the normal, out of a, the depth is gone.
    const Vec3 off = o.depth * o.normal;
    if (o.depth > 0.0) least_gain = std::max(least_gain, geometry::penetration_of(ga, geometry::placed(gb, Mat3{}, off)).depth);
    CHECK(norm((o.arm_a - o.arm_b) - apart_by) < 1e-12);
    (depth > 0.0 ? deep : apart) += 1;
  }
  MESSAGE(deep << " overlap, " << apart << " do not; depths differ by " << worst << " m at most");
  CHECK(worst < 1e-9);
  CHECK(asymmetry < 1e-9);
  CHECK(least_gain < 1e-9);
  CHECK(deep > 2000);
  CHECK(apart > 500);
}

/// m, by which a point is outside of a body.
double outside(const geometry::ConvexBody& body, Vec3 x) {
  double most = -std::numeric_limits<double>::infinity();
  for (const geometry::HalfSpace& f : body.faces) most = std::max(most, dot(f.normal, x) - f.offset);
  return most;
}

TEST_CASE("overlap: two bodies meet at a point of both, also where an edge or a face lies along a face") {
  const std::vector<Body> all = bodies();
  Random random;
  int flush = 0;
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Body &a = all[static_cast<std::size_t>(i) % 5], &b = all[static_cast<std::size_t>(i) / 5 % 5];
    const bool parallel = i % 4 != 0;  // turned alike, or about one axis: as a block that lies on an edge
    const Quaternion qa = parallel ? Quaternion{} : random.turn(), qb = i % 4 == 1 ? Quaternion{}
                                                                        : parallel ? Random::about_x(random(0, 3))
                                                                                   : random.turn();
    const Vec3 apart_by{random(-0.2, 0.2), random(-0.2, 0.2), random(-0.2, 0.2)};
    const kernels::Pose pa{{}, rotation_minus_identity(qa)}, pb{{}, rotation_minus_identity(qb)};
    const kernels::Overlap o = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, 0.0);
    if (o.depth <= 0.0 || o.depth > 0.02) continue;  // no deeper than the thinnest body is thick
    flush += parallel ? 1 : 0;
    const geometry::ConvexBody ga = geometry::placed(a.exact, rotation(qa), {}), gb = geometry::placed(b.exact, rotation(qb), apart_by);
    worst = std::max(worst, std::max(outside(ga, o.arm_a), outside(gb, o.arm_a)) - 0.5 * o.depth);
  }
  CHECK(flush > 1000);
  CHECK(worst < 1e-8);
}

TEST_CASE("overlap: what lies flat meets the base, or a small face, in its middle") {
  const Body slab = body(geometry::make_box({-0.4, -0.3, 0.0}, {0.4, 0.3, 0.1})),
             pier = body(geometry::make_box({0.2, 0.0, 0.0}, {0.3, 0.1, 0.5}));
  const kernels::Pose flat{{}, Mat3::zero()};
  const kernels::Overlap base = kernels::overlap_with_base(slab.shape(), flat, 0.04);
  CHECK(base.depth == doctest::Approx(0.01));
  CHECK(std::hypot(base.arm_a.x, base.arm_a.y) < 1e-12);
  // The slab 1 mm in the top of a pier that stands under a part of it where none of its edges and diagonals is.
  const kernels::Overlap top = kernels::overlap_of(pier.shape(), flat, slab.shape(), flat, {-0.25, -0.05, 0.299}, 0.0);
  CHECK(top.depth == doctest::Approx(0.001));
  CHECK(std::hypot(top.arm_a.x, top.arm_a.y) < 1e-12);
}

TEST_CASE("overlap: an edge that lies along a face, or along the base, meets it in its middle, however it is turned") {
  // The deepest of two corners is found twice, with other round-off; neither way may lose it.
  const Body slab = body(geometry::make_box({-0.15, -0.05, 0.0}, {0.15, 0.05, 0.2})),
             brick = body(geometry::make_box({-0.075, -0.05, 0.0}, {0.075, 0.05, 0.2}));
  Random random;
  double worst = 0.0, worst_on_base = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double tilt = random(0.002, 0.1), deep = random(0.002, 0.006);
    const Quaternion leaning{std::cos(0.5 * tilt), 0.0, std::sin(0.5 * tilt), 0.0}, turn = i % 2 == 0 ? Quaternion{} : random.turn();
    const Mat3 all = rotation(turn);
    const kernels::Pose pa{{}, rotation_minus_identity(turn)}, pb{{}, rotation_minus_identity(product(turn, leaning))};
    const Vec3 corner = rotation(leaning) * Vec3{0.075, 0.0, -0.1};  // the lower edge
    const Vec3 foot{random(0.0, 0.14), random(-0.02, 0.02), 0.1 - deep}, apart_by = all * (foot - corner);
    const double y0 = std::max(-0.05, foot.y - 0.05), y1 = std::min(0.05, foot.y + 0.05);  // of the edge, what is over the face
    const Vec3 expected = all * Vec3{foot.x, 0.5 * (y0 + y1), 0.1 - 0.5 * deep};
    for (const auto overlap : {kernels::overlap_of, kernels::overlap_of_many})
      worst = std::max(worst, norm(overlap(slab.shape(), pa, brick.shape(), pb, apart_by, 0.0).arm_a - expected));
    const kernels::Pose about_z{{}, rotation_minus_identity(product({std::cos(0.1 * i), 0.0, 0.0, std::sin(0.1 * i)}, leaning))};
    const Vec3 middle = (Mat3{} + about_z.d) * Vec3{0.075, 0.0, -0.1};
    const kernels::Overlap base = kernels::overlap_with_base(brick.shape(), about_z, -middle.z - deep);
    worst_on_base = std::max(worst_on_base, norm(base.arm_a - middle - Vec3{0.0, 0.0, 0.5 * deep}));
  }
  CHECK(worst < 1e-9);
  CHECK(worst_on_base < 1e-9);
}

TEST_CASE("overlap: a look that stops early has shown some axis of no more depth") {
  const std::vector<Body> all = bodies();
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Body &a = all[static_cast<std::size_t>(i) % 5], &b = all[static_cast<std::size_t>(i) / 5 % 5];
    const kernels::Pose pa{{}, rotation_minus_identity(random.turn())}, pb{{}, rotation_minus_identity(random.turn())};
    const Vec3 apart_by{random(-0.2, 0.2), random(-0.2, 0.2), random(-0.2, 0.2)};
    const double exact = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, kNone).depth;
    const double enough = exact + random(-0.01, 0.01), quick = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, enough).depth;
    if (exact > enough) {
      CHECK(quick == exact);
    } else {
      CHECK(quick >= exact);
      CHECK(quick <= enough);
    }
  }
}

TEST_CASE("overlap: leaving axes out gives what all axes give") {
  const std::vector<Body> all = bodies();
  Random random;
  double worst = 0.0, least_gain = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const Body &a = all[static_cast<std::size_t>(i) % 5], &b = all[static_cast<std::size_t>(i) / 5 % 5];
    const Quaternion qa = random.turn(), qb = i % 4 == 0 ? qa : random.turn();
    const kernels::Pose pa{{}, rotation_minus_identity(qa)}, pb{{}, rotation_minus_identity(qb)};
    const Vec3 apart_by{random(-0.2, 0.2), random(-0.2, 0.2), random(-0.2, 0.2)};
    const kernels::Overlap o = kernels::overlap_of_many(a.shape(), pa, b.shape(), pb, apart_by, kNone);
    const double depth = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, kNone).depth;
    CHECK(std::abs(norm(o.normal) - 1.0) < 1e-12);
    CHECK(norm((o.arm_a - o.arm_b) - apart_by) < 1e-12);
    if (depth <= 0.0) {  // how far apart is a bound
      CHECK(o.depth <= 1e-12);
      CHECK(o.depth >= depth - 1e-9);
      continue;
    }
    worst = std::max(worst, std::abs(o.depth - depth));
    const Vec3 off = apart_by + o.depth * o.normal;
    least_gain = std::max(least_gain, kernels::overlap_of(a.shape(), pa, b.shape(), pb, off, kNone).depth);
  }
  MESSAGE("depths differ by " << worst << " m at most");
  CHECK(worst < 1e-9);
  CHECK(least_gain < 1e-9);
}

TEST_CASE("overlap: stones of many faces are as deep in each other, and in bricks, as geometry says") {
  const std::vector<Body> few = bodies();
  const Body many = body(testing::rounded_stone(12, 14, 0.12));  // 168 faces
  REQUIRE(!kernels::is_small(many.faces.size(), many.exact.vertices.size()));
  Random random;
  int deep = 0;
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const bool both = i % 10 == 0, first = i % 2 == 0;  // all axes of two such stones take geometry a while
    const Body &a = first ? many : few[static_cast<std::size_t>(i) % 5], &b = both || !first ? many : few[static_cast<std::size_t>(i) % 5];
    const Quaternion qa = random.turn(), qb = random.turn();
    const kernels::Pose pa{{}, rotation_minus_identity(qa)}, pb{{}, rotation_minus_identity(qb)};
    const Vec3 apart_by{random(-0.12, 0.12), random(-0.12, 0.12), random(-0.12, 0.12)};
    const kernels::Overlap o = kernels::overlap_of(a.shape(), pa, b.shape(), pb, apart_by, kNone);
    const geometry::ConvexBody ga = geometry::placed(a.exact, rotation(qa), {}), gb = geometry::placed(b.exact, rotation(qb), apart_by);
    const double depth = geometry::penetration_of(ga, gb).depth;
    worst = std::max(worst, std::abs(o.depth - depth));
    if (depth > 0.0) ++deep;
  }
  MESSAGE("depths differ by " << worst << " m at most");
  CHECK(worst < 1e-9);
  CHECK(deep > 20);
}

TEST_CASE("overlap: a box whose edges are divided, with more vertices than its faces have corners, is as deep as the box") {
  const std::vector<Body> few = bodies();
  const Vec3 low{0, 0, 0}, high{0.3, 0.2, 0.1};
  const Body plain = body(geometry::make_box(low, high)), divided = body(testing::divided_box(low, high, 100));
  REQUIRE(divided.faces.size() == 6);
  REQUIRE(!kernels::is_small(6, divided.exact.vertices.size()));
  Random random;
  int deep = 0;
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Body& other = i % 10 == 0 ? divided : few[static_cast<std::size_t>(i) % 5];
    const Body& plain_other = i % 10 == 0 ? plain : other;
    const kernels::Pose pa{{}, rotation_minus_identity(random.turn())}, pb{{}, rotation_minus_identity(random.turn())};
    const Vec3 apart_by{random(-0.15, 0.15), random(-0.15, 0.15), random(-0.15, 0.15)};
    const double exact = kernels::overlap_of(plain.shape(), pa, plain_other.shape(), pb, apart_by, kNone).depth;
    const double depth = kernels::overlap_of(divided.shape(), pa, other.shape(), pb, apart_by, kNone).depth;
    const double back = kernels::overlap_of(other.shape(), pb, divided.shape(), pa, -apart_by, kNone).depth;
    if (exact > 0.0) worst = std::max({worst, std::abs(depth - exact), std::abs(back - exact)});
    if (exact > 0.0) ++deep;
  }
  MESSAGE("depths differ by " << worst << " m at most");
  CHECK(worst < 1e-9);
  CHECK(deep > 50);
}

TEST_CASE("overlap: with the base it is how far the lowest vertex lies under its plane") {
  const std::vector<Body> all = bodies();
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Body& a = all[static_cast<std::size_t>(i) % 5];
    const Quaternion q = random.turn();
    const double height = random(-0.1, 0.2);
    const kernels::Overlap o = kernels::overlap_with_base(a.shape(), {{}, rotation_minus_identity(q)}, height);
    CHECK(std::abs(o.depth - geometry::depth_under(geometry::placed(a.exact, rotation(q), {0, 0, height}), 0.0)) < 1e-12);
    CHECK(o.normal == Vec3{0.0, 0.0, -1.0});
  }
}
