// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/contact/contact_patch.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr double kStep = 5e-5;
constexpr int kPoints = 27, kPadded = 32;
/// tan φ of the upper brick (0), the lower (1) and the base (2).
constexpr double kTanPhi[9] = {9.0, 0.6, 0.45, 0.6, 9.0, 9.0, 0.45, 9.0, 9.0};
constexpr kernels::FrictionTable kFriction{kTanPhi, 3};

/// Faces of two bricks 0.2 × 0.1 × 0.1 m and of the base.
struct Bricks {
  std::vector<kernels::Face> faces;
  Bricks() {
    const double half[3] = {0.1, 0.05, 0.05};
    for (int body = 0; body < 2; ++body) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
          const Vec3 normal{axis == 0 ? sign : 0.0, axis == 1 ? sign : 0.0, axis == 2 ? sign : 0.0};
          const double l = half[axis];
          faces.push_back({normal, l, l * (1.0 - 0.0625) / 9.8e7, 2.0 * l * 1.25 / 9.8e7, 1800.0 * l, body});
        }
      }
    }
    faces.push_back({.normal = {0, 0, 1}, .material = 2});
  }
};

/// The lower face of brick 0 above brick 1, with its history.
struct Twin {
  kernels::AdvancePatch& advance;
  std::vector<double> s = std::vector<double>(kPadded), t = s, area = s;
  std::vector<kernels::PointSprings> springs = std::vector<kernels::PointSprings>(kPadded / kernels::kWidth);
  std::vector<std::int32_t> partner = std::vector<std::int32_t>(kPadded, kernels::kNobody),
                            face = std::vector<std::int32_t>(kPadded, kernels::kNoFace);
  std::vector<double> crushed{};  // m, by point; empty: contacts bear any pressure
  std::vector<double> pressed{};  // m, by point; empty: no contact.restitution
  kernels::Patch patch;
  std::vector<kernels::Candidate> candidates{{1, 6, 6}, {2, 12, 1}};
  kernels::PairWrench wrench[2];
  std::uint8_t on[2] = {0, 0};
  kernels::PatchResult last;

  explicit Twin(kernels::AdvancePatch& kernel) : advance(kernel) {
    for (std::size_t i = 0; i < kPadded; ++i) {
      const double k = static_cast<double>(i < kPoints ? i : kPoints - 1);
      s[i] = -0.09 + 0.02 * std::fmod(k, 9.0), t[i] = -0.04 + 0.04 * std::floor(k / 9.0), area[i] = i < kPoints ? 0.0008 : 0.0;
    }
    patch.element = 0, patch.face = 4, patch.face_number = 4, patch.face_count = 6, patch.centre = {0, 0, -0.05};
    patch.es = {0, 1, 0}, patch.et = {1, 0, 0};
    std::swap(s, t);
    patch.s_low = -0.04, patch.s_high = 0.04, patch.t_low = -0.09, patch.t_high = 0.07;
  }
  double travel[3] = {0.0, 0.0, 0.0};  // m
  double base = -0.0515;               // m, height
  void step(const TwoBodies& b, const Bricks& bricks, const kernels::ContactOptions& o) {
    const kernels::BodyConstants constants[3] = {{{0, 0, 0.1}, 50.0}, {{0, 0, 0}, 80.0}, {{0, 0, base}, 0.0}};
    const kernels::Bodies bodies{b.pose.data(), b.twist.data(), constants, travel};
    std::vector<double> depth(kPadded);
    std::vector<std::int32_t> candidate(kPadded), new_face(kPadded);
    std::vector<kernels::PlaneField> planes(6);
    const kernels::ContactPoints points{partner.data(), face.data(), springs.data(), crushed.empty() ? nullptr : crushed.data(),
                                        pressed.empty() ? nullptr : pressed.data()};
    last = advance(patch, {s.data(), t.data(), area.data(), kPoints}, points, last.touching, candidates, bodies, bricks.faces.data(), o,
                   {depth.data(), candidate.data(), new_face.data(), planes.data()}, wrench, on);
  }
};

void compare(const Twin& a, const Twin& b, double unit) {
  CHECK(a.last.touching == b.last.touching);
  CHECK(a.partner == b.partner);
  CHECK(a.face == b.face);
  CHECK(a.last.stored == doctest::Approx(b.last.stored).epsilon(1e-9).scale(1e-6));
  for (int k = 0; k < 2; ++k) {
    REQUIRE(a.on[k] == b.on[k]);
    if (!a.on[k]) continue;
    CHECK(distance(a.wrench[k].force, b.wrench[k].force) < 1e-10 * unit);
    CHECK(distance(a.wrench[k].torque_a, b.wrench[k].torque_a) < 1e-10 * unit);
    CHECK(distance(a.wrench[k].torque_b, b.wrench[k].torque_b) < 1e-10 * unit);
    CHECK(distance(a.wrench[k].dash_force, b.wrench[k].dash_force) < 1e-10 * unit);
    CHECK(distance(a.wrench[k].dash_torque_b, b.wrench[k].dash_torque_b) < 1e-10 * unit);
  }
}

/// Bricks one above the other: the upper one is pulled down, shaken at random, and drifts towards the edge of the lower one and the base
/// beyond.
class ShakenBrick {
 public:
  explicit ShakenBrick(std::uint64_t seed) : noise_(seed) {}

  /// Both bricks after one more step. \param travel  m, bound on the path of the upper one: grows
  TwoBodies next(double& travel) {
    v_ = v_ + noise_.vector(4e-3) + kStep * Vec3{0.02, 0.0, -2000.0 * u_.z};
    w_ = 0.99 * w_ + noise_.vector(3e-2);
    u_ = u_ + kStep * v_, turn_ = turn_ + kStep * w_;
    travel += 1.001 * kStep * (norm(v_) + norm(w_) * norm(Vec3{0.1, 0.05, 0.05}));
    TwoBodies b;
    b.place(0, u_, turn_), b.move(0, v_, w_);
    return b;
  }

 private:
  Noise noise_;
  Vec3 u_{0.0, 0.0, 1e-5}, turn_{}, v_{0.0, 0.0, -0.02}, w_{};
};

/// A step of both kernels, which must agree. \param unit  N, the largest force so far
void step_both(Twin& fast, Twin& plain, const TwoBodies& b, const Bricks& bricks, const kernels::ContactOptions& o, double& unit) {
  fast.step(b, bricks, o), plain.step(b, bricks, o);
  unit = std::max({unit, norm(plain.wrench[0].force), norm(plain.wrench[1].force)});
  compare(fast, plain, unit);
}

}  // namespace

TEST_CASE("vector and plain patches go the same way through touching, rubbing, rocking and letting go") {
  const Bricks bricks;
  int touching = 0, letting_go = 0, on_base = 0, not_looked = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
    kernels::ContactOptions o{kStep, 1.0, kFriction, seed % 4 == 0};
    o.dashpot_excess = seed % 5 == 0 ? kernels::kUnbounded : kernels::kBounded;
    ShakenBrick brick(seed);
    double unit = 1.0, lost_fast = 0.0, lost_plain = 0.0;
    for (int i = 0; i < 1500; ++i) {
      const TwoBodies b = brick.next(fast.travel[0]);
      const int before = plain.last.touching;
      const double safe = fast.candidates[0].safe;
      step_both(fast, plain, b, bricks, o, unit);
      lost_fast += fast.last.friction + fast.last.impact, lost_plain += plain.last.friction + plain.last.impact;
      touching += plain.last.touching > 0, letting_go += plain.last.touching < before, on_base += plain.on[1];
      not_looked += fast.candidates[0].safe == safe && safe != kernels::kLookNow;
    }
    CHECK(lost_fast == doctest::Approx(lost_plain).epsilon(1e-7).scale(1e-4));
  }
  CHECK(touching > 2000);
  CHECK(letting_go > 200);
  CHECK(not_looked > 5000);
  MESSAGE("steps in touch " << touching << ", letting go " << letting_go << ", on the base " << on_base << ", without a look "
                            << not_looked);
}

TEST_CASE("vector and plain patches crush the same way, and what is crushed stays so when a point lets go") {
  const Bricks bricks;
  int crushed = 0, recessed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
    for (Twin* t : {&fast, &plain}) t->crushed.assign(kPadded, 0.0);
    kernels::ContactOptions o{kStep, 1.0, kFriction, seed % 4 == 0};
    o.crushing = seed % 2 ? kernels::Crushing{.strength = 4e4, .residual = 1e4, .slope = 2e8, .depth = 5e-4}
                          : kernels::Crushing{.strength = 3e4, .depth = 2e-4};
    ShakenBrick brick(100 + seed);
    double unit = 1.0, lost_fast = 0.0, lost_plain = 0.0;
    for (int i = 0; i < 1000; ++i) {
      step_both(fast, plain, brick.next(fast.travel[0]), bricks, o, unit);
      lost_fast += fast.last.fracture, lost_plain += plain.last.fracture;
      REQUIRE(plain.last.fracture >= -1e-12);
      for (int k = 0; k < kPoints; ++k) {
        const auto p = static_cast<std::size_t>(k);
        REQUIRE(fast.crushed[p] == doctest::Approx(plain.crushed[p]).epsilon(1e-8).scale(1e-6));
        const kernels::ContactPoints q{plain.partner.data(), plain.face.data(), plain.springs.data(), plain.crushed.data()};
        if (plain.partner[p] != kernels::kNobody || plain.crushed[p] == 0.0) continue;
        REQUIRE(q.closure(k) == -plain.crushed[p]);
        ++recessed;
      }
    }
    CHECK(lost_fast == doctest::Approx(lost_plain).epsilon(1e-7).scale(1e-4));
    for (const double depth : plain.crushed) crushed += depth > 0.0;
  }
  CHECK(crushed > 50);
  CHECK(recessed > 500);
}

TEST_CASE("vector and plain patches give back the same share of an impact, and a point that lets go forgets how it was pressed") {
  const Bricks bricks;
  int pressed = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
    for (Twin* t : {&fast, &plain}) {
      t->pressed.assign(kPadded, 0.0);
      if (seed % 3 == 0) t->crushed.assign(kPadded, 0.0);
    }
    kernels::ContactOptions o{kStep, 1.0, kFriction, seed % 4 == 0};
    o.restitution = 0.2 * static_cast<double>(1 + seed % 5);
    if (seed % 3 == 0) o.crushing = {.strength = 3e4, .depth = 2e-4};
    ShakenBrick brick(200 + seed);
    double unit = 1.0, lost_fast = 0.0, lost_plain = 0.0;
    for (int i = 0; i < 1000; ++i) {
      step_both(fast, plain, brick.next(fast.travel[0]), bricks, o, unit);
      lost_fast += fast.last.impact, lost_plain += plain.last.impact;
      for (std::size_t p = 0; p < kPoints; ++p) {
        REQUIRE(fast.pressed[p] == doctest::Approx(plain.pressed[p]).epsilon(1e-8).scale(1e-6));
        if (plain.partner[p] == kernels::kNobody) REQUIRE(plain.pressed[p] == 0.0);
        pressed += plain.pressed[p] > 0.0;
      }
    }
    CHECK(lost_fast == doctest::Approx(lost_plain).epsilon(1e-7).scale(1e-4));
  }
  CHECK(pressed > 5000);
}

TEST_CASE("a patch keeps the stiffness of its broken joint against the face it was joined to, and against no other") {
  const Bricks bricks;
  const auto push = [&](std::int32_t origin, std::int32_t origin_face) {
    Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
    TwoBodies b;
    b.place(0, {0.0, 0.0, -1e-5}, {}), b.move(0, {0.0, 0.0, -0.5}, {});  // it was outside before
    for (Twin* t : {&fast, &plain}) {
      t->patch.origin = origin, t->patch.origin_face = origin_face, t->patch.origin_kn = 3e8;
      t->step(b, bricks, {kStep, 0.0, kFriction});
    }
    compare(fast, plain, 1e3);
    return norm(fast.wrench[0].force);
  };
  constexpr std::int32_t kUpper = 11, kLower = 10;  // of brick 1
  const kernels::Face &a = bricks.faces[4], &b = bricks.faces[kUpper];
  const double area = 0.5 * 0.0008 * kPoints;
  CHECK(push(kernels::kNobody, -1) == doctest::Approx(1e-5 * area / (a.compliance_n + b.compliance_n)).epsilon(1e-9));
  CHECK(push(1, kUpper) == doctest::Approx(1e-5 * area * 3e8).epsilon(1e-9));
  CHECK(push(1, kLower) == push(kernels::kNobody, -1));
}

TEST_CASE("points that one partner lets go find the next in the same step") {
  const Bricks bricks;
  Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
  int on_both = 0;
  for (Twin* t : {&fast, &plain}) t->base = 0.0499;  // 0.1 mm under the other brick's top
  for (int i = 0; i <= 250; ++i) {                   // pressed 0.2 mm into the other brick, pushed over its edge
    TwoBodies b;
    b.place(0, {1e-3 * i, 0.0, -2e-4}, {}), b.move(0, {1e-3 / kStep, 0.0, 0.0}, {});
    fast.travel[0] += 1.001e-3;
    for (Twin* t : {&fast, &plain}) t->step(b, bricks, {kStep, 1.0, kFriction});
    compare(fast, plain, std::max({1.0, norm(plain.wrench[0].force), norm(plain.wrench[1].force)}));
    CHECK(fast.last.touching == kPoints);
    on_both += fast.on[0] && fast.on[1];
  }
  CHECK(on_both > 100);
}

TEST_CASE("a pair that has parted when a search comes lets its points go") {
  const Bricks bricks;
  Twin t(kernels::advance_patch);
  const kernels::ContactOptions o{kStep, 1.0, kFriction};
  TwoBodies b;
  b.place(0, {0.0, 0.0, -2e-4}, {});
  t.step(b, bricks, o);
  CHECK(t.last.touching > 0);
  b.place(0, {0.195, 0.0, -2e-4}, {});  // beyond the other brick's end, not up from its top
  t.candidates = {{1, 6, 6}, {2, 12, 1}};
  t.candidates[0].safe = 5e-3;  // the gap that the search finds
  t.step(b, bricks, o);
  CHECK(t.last.touching == 0);
}

TEST_CASE("points are not looked at only while both bodies together have travelled less than what was found safe") {
  const Bricks bricks;
  TwoBodies b;
  b.place(0, {0.0, 0.0, -2e-4}, {});  // pressed 0.2 mm into the other brick
  const auto touches = [&](double travel_of_patch, double travel_of_other) {
    Twin t(kernels::advance_patch);
    for (kernels::Candidate& c : t.candidates) c.face = kernels::kNoFace, c.safe = 5e-4;
    t.travel[0] = travel_of_patch, t.travel[1] = travel_of_other;
    t.step(b, bricks, {kStep, 1.0, kFriction});
    return t.last.touching > 0;
  };
  CHECK(touches(6e-4, 0.0));
  CHECK(touches(0.0, 6e-4));
  CHECK(touches(3e-4, 3e-4));
  CHECK_FALSE(touches(2e-4, 2e-4));
}

TEST_CASE("a point takes the partner that stops it, then the one it was joined to, then that in which it is deeper") {
  const Bricks bricks;
  const auto partner = [&](double z, double base, std::int32_t origin, bool other_way_round) {
    Twin fast(kernels::advance_patch), plain(kernels::advance_patch_reference);
    for (Twin* t : {&fast, &plain}) {
      t->base = base;
      t->patch.origin = origin;
      if (other_way_round) std::swap(t->candidates[0], t->candidates[1]);
      TwoBodies b;
      b.place(0, {0.0, 0.0, z}, {});
      t->step(b, bricks, {kStep, 1.0, kFriction});
    }
    CHECK(fast.partner == plain.partner);
    CHECK(std::count(fast.partner.begin(), fast.partner.begin() + kPoints, fast.partner[0]) == kPoints);
    return fast.partner[0];
  };
  for (const bool other_way_round : {false, true}) {
    CAPTURE(other_way_round);
    CHECK(partner(-2e-4, 0.0499, kernels::kNobody, other_way_round) == 1);  // 0.2 mm in the brick, 0.1 mm in the base
    CHECK(partner(-2e-4, 0.0499, 2, other_way_round) == 2);
    CHECK(partner(-2e-4, 0.0499, 1, other_way_round) == 1);
    CHECK(partner(-4e-3, 0.0461, kernels::kNobody, other_way_round) == 2);  // 4 mm in the brick: no face of it stops it
    CHECK(partner(-4e-3, 0.0461, 1, other_way_round) == 2);
  }
}

TEST_CASE("a point that is found deep has no force at first and then carries what it is pressed further") {
  const Bricks bricks;
  const double area = 0.5 * 0.0008 * kPoints, stiffness = area / (bricks.faces[4].compliance_n + bricks.faces[11].compliance_n);
  for (const double depth : {2e-3, 4e-3, 9e-3}) {
    CAPTURE(depth);
    for (kernels::AdvancePatch* kernel : {&kernels::advance_patch, &kernels::advance_patch_reference}) {
      Twin t(*kernel);
      const auto force_at = [&](double z) {
        TwoBodies b;
        b.place(0, {0.0, 0.0, z}, {});
        t.travel[0] += 1e-3;
        t.step(b, bricks, {kStep, 0.0, kFriction});
        return t.on[0] != 0 ? norm(t.wrench[0].force) : 0.0;
      };
      CHECK(force_at(-depth) < 1e-9 * stiffness);
      CHECK(t.last.touching == kPoints);
      CHECK(force_at(-depth - 2e-5) == doctest::Approx(2e-5 * stiffness).epsilon(1e-9));
    }
  }
}

TEST_CASE("a point deep under the top that came in past an edge is held by the side through which it came") {
  const Bricks bricks;
  for (kernels::AdvancePatch* kernel : {&kernels::advance_patch, &kernels::advance_patch_reference}) {
    Twin t(*kernel);
    TwoBodies b;
    b.place(0, {-0.17 + 1e-5, 0.0, -5e-3}, {}), b.move(0, {1.0, 0.0, 0.0}, {});  // the foremost three points are 10 um past the end
    t.step(b, bricks, {kStep, 0.0, kFriction});
    CHECK(t.last.touching == 3);
    CHECK(std::count(t.face.begin(), t.face.end(), 6) == 3);
    REQUIRE(t.on[0] != 0);
    const double stiffness = 0.5 * 0.0008 * 3 / (bricks.faces[4].compliance_n + bricks.faces[6].compliance_n);
    CHECK(t.wrench[0].force.x == doctest::Approx(-1e-5 * stiffness).epsilon(1e-6));
  }
}

TEST_CASE("a point that comes in past an edge is held by the face it crossed, or stays free where points lie on edges") {
  const Bricks bricks;
  for (auto* kernel : {kernels::advance_patch, kernels::advance_patch_reference}) {
    for (const bool crossed : {true, false}) {
      kernels::ContactOptions o{kStep, 1.0, kFriction};
      o.crossed_faces = crossed;
      Twin twin(*kernel);
      // The lower face of brick 0 is half way down brick 1 and moves in from its side at x = 0.1.
      const double speed = 0.4, in = 0.5 * kStep * speed;
      TwoBodies b;
      b.place(0, {0.19 - in, 0.0, -0.05 - 1e-6}, {}), b.move(0, {-speed, 0.0, 0.0}, {});
      twin.step(b, bricks, o);
      const auto with = [&](std::int32_t partner) { return std::count(twin.partner.begin(), twin.partner.end(), partner); };
      CHECK(with(1) == (crossed ? 3 : 0));
      CHECK(twin.on[0] == (crossed ? 1 : 0));
      if (crossed) {
        CHECK(twin.wrench[0].force.x > 0.0);
        continue;
      }
      twin.base = 0.0;  // now the face stands on the ground, by a thousandth of a millimetre
      b.move(0, {}, {});
      twin.travel[0] = 1.0;
      twin.step(b, bricks, o);
      CHECK(with(2) == kPoints);
      CHECK(twin.on[0] == 0);
    }
  }
}
