// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "kernels/whole_sides.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <vector>

#include "tests/kernels/side_fixture.h"

using namespace voussoir;
using namespace voussoir::testing;

namespace {

constexpr Vec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

/// All pairs of tangents along the axes, each with either sign: every side of every face of a brick, four ways round.
std::vector<std::array<Vec3, 2>> tangents_along_axes() {
  std::vector<std::array<Vec3, 2>> pairs;
  for (const Vec3 s : kAxes) {
    for (const Vec3 t : kAxes) {
      if (dot(s, t) == 0.0) pairs.push_back({s, t});
    }
  }
  return pairs;
}

/// Takes points away from one corner, so that the axes of the rectangle are no principal ones.
void cut_corner(SideUnderTest& u) {
  double area = 0.0, s = 0.0, t = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(u.n); ++i) {
    if (u.s[i] + u.t[i] > 0.04) u.area[i] *= 0.2;
    area += u.area[i], s += u.area[i] * u.s[i], t += u.area[i] * u.t[i];
  }
  for (std::size_t i = 0; i < u.s.size(); ++i) u.s[i] -= s / area, u.t[i] -= t / area;
}

/// Sides that look every way: along axes, with a corner cut, anyhow, on the base.
std::vector<SideUnderTest> sides_of_all_forms(Noise& noise) {
  std::vector<SideUnderTest> sides;
  for (const auto& [es, et] : tangents_along_axes()) {
    for (const bool cut : {false, true}) {
      SideUnderTest& u = sides.emplace_back(4, 8, 0.5);
      u.side.es = es, u.side.et = et;
      if (cut) cut_corner(u);
    }
  }
  for (int i = 0; i < 12; ++i) {
    SideUnderTest& u = sides.emplace_back(3, 4, i % 3 == 0 ? 0.0 : 0.5);
    const Quaternion q{noise(), noise(), noise(), noise()};
    const double f = 1.0 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    const Mat3 d = rotation_minus_identity({f * q.w, f * q.x, f * q.y, f * q.z});
    u.side.es = u.side.es + d * u.side.es, u.side.et = u.side.et + d * u.side.et;
    if (i % 3 == 1) u.put_onto_base();
    if (i % 2 == 0) cut_corner(u);
  }
  return sides;
}

/// Both bodies moved together by up to 0.3 m and 0.2 rad, and apart by about `opening` [m].
TwoBodies random_pose(const SideUnderTest& u, Noise& noise, double opening) {
  TwoBodies b;
  const Vec3 common = u.side.on_base ? Vec3{} : noise.vector(0.3), turn = noise.vector(0.2);
  b.place(0, common, turn);
  const Mat3 d = kernels::load_pose(b.pose.data(), 0).d;
  if (u.side.on_base) {
    b.place(0, noise.vector(opening) - d * u.side.ca, turn);
  } else {
    b.place(1, common + d * (u.side.ca - u.side.cb) + noise.vector(opening), turn + noise.vector(10.0 * opening));
  }
  return b;
}

/// Force and torque on both bodies by the short form; nothing if it does not prove that the side stays whole.
struct ShortForm {
  bool certain = false;
  alignas(64) std::array<double, 3 * kernels::kWrenchStride> wrench{};
};
ShortForm short_form(const kernels::SideBlock& block, unsigned live, const TwoBodies& b) {
  ShortForm r;
  const std::uint8_t lanes = static_cast<std::uint8_t>(live);
  const std::int32_t number[] = {0};
  unsigned done = 0;
  r.certain =
      kernels::advance_whole({&block, &lanes, number, 0, {}}, {b.pose.data(), b.twist.data(), r.wrench.data(), nullptr, {}}, done) == 1;
  return r;
}

SideStep by_segments(SideUnderTest u, const TwoBodies& b) {
  std::vector<kernels::SegmentEvent> events;
  return advance(kernels::advance_sides_reference, u, b, 5e-5, 0.0, {}, events);
}

Vec3 part(const ShortForm& r, int body, int at) {
  const double* row = r.wrench.data() + body * kernels::kWrenchStride + at;
  return {row[0], row[1], row[2]};
}

/// How often a bound passes a side, and how often a segment of it yields: never both.
struct Tally {
  int passed = 0, yielded = 0;
  void look(SideUnderTest& u, const TwoBodies& b) {
    const bool certain = short_form(u.block(kLane), 1U << kLane, b).certain, yields = by_segments(u, b).result.events > 0;
    CHECK_FALSE((certain && yields));
    passed += certain, yielded += yields;
  }
};

/// By the certificate at the corners, no bound before it.
bool certified(SideUnderTest u, const TwoBodies& b) {
  std::vector<kernels::SegmentEvent> events;
  const kernels::FailureOptions o{.in_tension = kernels::ShearInTension::coulomb};
  return !advance(kernels::advance_sides, u, b, 5e-5, 0.0, o, events, kernels::SideState::whole).looked_at;
}

}  // namespace

TEST_CASE("the short form of a whole side, whatever way it looks, equals the sum over its segments to 1e-11") {
  Noise noise(11);
  for (SideUnderTest& u : sides_of_all_forms(noise)) {
    u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
    for (int i = 0; i < 20; ++i) {
      const TwoBodies b = random_pose(u, noise, 1e-6);
      const ShortForm r = short_form(u.block(kLane), 1U << kLane, b);
      REQUIRE(r.certain);
      const SideStep s = by_segments(u, b);
      const double unit = u.side.k.kn * 0.02 * 1e-6;  // k A max|u|
      CHECK(norm(s.force_a) > 1e-3 * unit);
      CHECK(distance(part(r, 0, 0), s.force_a) < 1e-11 * unit);
      CHECK(distance(part(r, 0, 3), s.torque_a) < 1e-11 * unit);
      CHECK(distance(part(r, 1, 0), s.force_b) < 1e-11 * unit);
      CHECK(distance(part(r, 1, 3), s.torque_b) < 1e-11 * unit);
      CHECK(norm(part(r, 2, 0)) == 0.0);
    }
  }
}

TEST_CASE("sides along an axis take the form without tangents, others do not; both give the same") {
  Noise noise(12);
  int along_an_axis = 0;
  for (SideUnderTest& u : sides_of_all_forms(noise)) {
    u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
    kernels::SideBlock block = u.block(kLane);
    const int axis = kernels::axis_of_side(u.side.es, u.side.et);
    const bool oblique = std::abs(u.constants.sst[kLane]) > 1e-9 * u.constants.sss[kLane];
    CHECK(u.whole.axis == (oblique || u.side.mean != 0.5 ? -1 : axis));
    const TwoBodies b = random_pose(u, noise, 1e-6);
    const ShortForm r = short_form(block, 1U << kLane, b);
    kernels::WholeConstants anyhow = u.whole;
    anyhow.axis = -1;
    kernels::set_whole(block, anyhow);
    const ShortForm g = short_form(block, 1U << kLane, b);
    REQUIRE(r.certain);
    REQUIRE(g.certain);
    for (std::size_t i = 0; i < r.wrench.size(); ++i) CHECK(std::abs(r.wrench[i] - g.wrench[i]) < 1e-11 * u.side.k.kn * 0.02 * 1e-6);
    along_an_axis += u.whole.axis >= 0;
  }
  CHECK(along_an_axis == 24);
}

TEST_CASE("sides that look one way or different ways share a block, each as if it were alone") {
  Noise noise(13);
  const std::vector<SideUnderTest> sides = sides_of_all_forms(noise);
  int one_axis = 0, two_axes = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i % 5; j < sides.size(); j += 5) {
      SideUnderTest one = sides[i], other = sides[j];
      if (one.side.on_base || other.side.on_base) continue;
      for (SideUnderTest* u : {&one, &other}) u->side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
      const TwoBodies b = random_pose(one, noise, 1e-6);
      const kernels::SideBlock first = one.block(2), second = other.block(kLane);
      kernels::SideBlock block = first;
      kernels::SideConstants both = one.constants;
      auto* to = reinterpret_cast<double*>(&both);
      const auto* from = reinterpret_cast<const double*>(&other.constants);
      for (std::size_t k = 0; k < kernels::kSideNumbers; ++k) to[k * kernels::kLanes + kLane] = from[k * kernels::kLanes + kLane];
      block.master[kLane] = second.master[kLane], block.slave[kLane] = second.slave[kLane];
      const kernels::WholeConstants whole = kernels::whole_constants(both, 0);
      CHECK(whole.axis == (one.whole.axis == other.whole.axis ? one.whole.axis : -1));
      one_axis += whole.axis >= 0;
      two_axes += whole.axis < 0 && one.whole.axis >= 0 && other.whole.axis >= 0;
      kernels::set_whole(block, whole);
      const ShortForm r = short_form(block, 1U << 2 | 1U << kLane, b);
      const ShortForm x = short_form(first, 1U << 2, b), y = short_form(second, 1U << kLane, b);
      REQUIRE(r.certain);
      REQUIRE(x.certain);
      REQUIRE(y.certain);
      for (std::size_t k = 0; k < r.wrench.size(); ++k) {
        CHECK(std::abs(r.wrench[k] - (x.wrench[k] + y.wrench[k])) < 1e-11 * one.side.k.kn * 0.02 * 1e-6);
      }
    }
  }
  CHECK(one_axis > 30);
  CHECK(two_axes > 60);
}

TEST_CASE("the short form keeps its digits while bodies turn against each other, or is not taken") {
  Noise noise(16);
  int taken = 0, left = 0;
  for (SideUnderTest& u : sides_of_all_forms(noise)) {
    if (u.side.on_base) continue;  // its normal does not turn
    u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
    for (int i = 0; i < 20; ++i) {
      const double turn = 0.3 * std::pow(10.0, noise() - 1.0);  // rad
      const TwoBodies b = random_pose(u, noise, 0.1 * turn);
      const ShortForm r = short_form(u.block(kLane), 1U << kLane, b);
      (r.certain ? taken : left) += 1;
      if (!r.certain) continue;
      const SideStep s = by_segments(u, b);
      const double unit = u.side.k.kn * 0.02 * 0.1 * turn;
      CHECK(distance(part(r, 0, 0), s.force_a) < 1e-11 * unit);
      CHECK(distance(part(r, 0, 3), s.torque_a) < 1e-11 * unit);
      CHECK(distance(part(r, 1, 3), s.torque_b) < 1e-11 * unit);
    }
  }
  CHECK(taken > 500);
  CHECK(left > 100);
}

TEST_CASE("the bound never passes a side in which a segment yields, and passes most that are far from it") {
  Noise noise(14);
  int far = 0, passed = 0, yielded = 0;
  for (const SideUnderTest& form : sides_of_all_forms(noise)) {
    for (int i = 0; i < 200; ++i) {
      SideUnderTest u = form;
      const auto factor = [&] { return std::pow(10.0, noise()); };
      u.side.strength = {1.27e5 * factor(), 3.04e4 * factor(), std::tan(0.5585), 4.9e5 * factor(), noise() > 0.0 ? 9.0 : 0.0};
      if (i % 4 == 1) u.side.k.ks = 3.0 * u.side.k.kn;
      if (i % 10 == 3) u.side.strength.tension = 0.0;
      const TwoBodies b = random_pose(u, noise, 6e-5 * std::pow(10.0, 1.5 * noise() - 0.5));
      const bool certain = short_form(u.block(kLane), 1U << kLane, b).certain;
      const bool yields = by_segments(u, b).result.events > 0;
      CHECK_FALSE((certain && yields));
      yielded += yields;
      SideUnderTest weaker = u;
      kernels::Strength& s = weaker.side.strength;
      s.tension *= 0.4, s.cohesion *= 0.4, s.compression *= 0.4;
      if (by_segments(weaker, b).result.events > 0) continue;
      ++far, passed += certain;
    }
  }
  CHECK(yielded > 2000);
  CHECK(far > 2000);
  CHECK(passed > 0.8 * far);
}

TEST_CASE("the bound leaves of the cap what shear takes: pressure up to it, with and without slide") {
  SideUnderTest u(4, 8, 0.5);
  const double pressed = u.side.strength.compression / u.side.k.kn, slid = u.side.strength.cohesion / u.side.k.ks;
  u.side.strength.cap = 9.0;
  u.side.strength.cohesion *= 100.0;  // friction is not what ends it
  Tally tally;
  for (int i = 0; i <= 100; ++i) {
    for (int j = 0; j <= 40; ++j) {
      TwoBodies b;
      b.place(1, {-(0.8 + 0.0022 * i) * pressed, 0.1 * j * slid, 0.0}, {});
      tally.look(u, b);
    }
  }
  CHECK(tally.passed > 100);
  CHECK(tally.yielded > 100);
}

TEST_CASE("without tensile strength no round-off lets the bound or the certificate pass what pulls") {
  Noise noise(17);
  SideUnderTest u(4, 8, 0.5);
  u.side.strength = {0.0, 1e12, 0.6, 1e12, 9.0};
  Tally tally;
  int also_certified = 0;
  for (int i = 0; i < 4000; ++i) {  // slid along the face as it stands, neither pressed nor pulled but by round-off
    TwoBodies b;
    const Vec3 common = noise.vector(0.3), turn = noise.vector(0.2);
    b.place(0, common, turn);
    const Mat3 d = kernels::load_pose(b.pose.data(), 0).d;
    const Vec3 slide = 1e-6 * (u.side.es + d * u.side.es), press = (i % 2 == 0 ? 0.0 : -1e-12) * Vec3{1.0, 0.0, 0.0};
    b.place(1, common + d * (u.side.ca - u.side.cb) + slide + press + d * press, turn);
    tally.look(u, b);
    CHECK_FALSE((certified(u, b) && by_segments(u, b).result.events > 0));
    also_certified += certified(u, b);
  }
  CHECK(tally.passed > 1000);
  CHECK(also_certified > 1000);
  CHECK(tally.yielded > 500);
}

TEST_CASE("the bound keeps its digits where pressure is strong and cohesion is not; strengths without end") {
  Noise noise(18);
  SideUnderTest u(4, 8, 0.5);
  Tally tally;
  for (int i = 0; i < 8000; ++i) {
    u.side.strength = {1e15, 1.0, 0.0, 1e15, i % 2 == 0 ? 0.0 : 9.0};
    const double slid = u.side.strength.cohesion / u.side.k.ks;
    TwoBodies b;
    b.place(1, {-slid * std::pow(10.0, 5.0 + 5.0 * noise()), 0.8 * slid * noise(), 0.8 * slid * noise()}, {});
    tally.look(u, b);
  }
  CHECK(tally.passed > 500);
  CHECK(tally.yielded > 200);
  const double endless = std::numeric_limits<double>::infinity();
  for (const kernels::Strength s : {kernels::Strength{1e15, 1e15, 0.6, 1e15, 9.0},
                                    {1e160, 1e160, 0.6, 1e160, 9.0},
                                    {1e5, 1e160, 0.6, 1e6, 0.0},
                                    {endless, 1e5, 0.6, endless, 9.0}}) {
    u.side.strength = s;
    CHECK(short_form(u.block(kLane), 1U << kLane, random_pose(u, noise, 1e-7)).certain);
  }
}

TEST_CASE("a side that is not certain leaves its neighbours in the block as they are done, once") {
  Noise noise(19);
  SideUnderTest strong(4, 8, 0.5);
  strong.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
  const TwoBodies b = random_pose(strong, noise, 1e-6);
  kernels::SideBlock block = strong.block(1);
  const ShortForm alone = short_form(block, 1U << 1, b);
  kernels::WholeConstants whole = strong.whole;
  const auto copy_lane = [](auto& to, int l, int from) {
    for (auto* column : {&to.force, &to.about_s, &to.about_t, &to.normal, &to.mean, &to.normal_turns}) (*column)[l] = (*column)[from];
  };
  copy_lane(whole, kLane, 1);  // in lane 5 a side whose bound never passes: its limits are 0, and d is not
  block.master[kLane] = block.master[1], block.slave[kLane] = block.slave[1];
  for (auto* column : {&whole.forward, &whole.backward, &whole.slide2}) (*column)[kLane] = -1.0;
  kernels::set_whole(block, whole);
  std::array<double, 3 * kernels::kWrenchStride> wrench{};
  const std::uint8_t live[] = {1U << 1 | 1U << kLane};
  const std::int32_t number[] = {0};
  unsigned done = 0;
  CHECK(kernels::advance_whole({&block, live, number, 0, {}}, {b.pose.data(), b.twist.data(), wrench.data(), nullptr, {}}, done) == 0);
  CHECK(done == (kernels::kWidth == 4 ? 1U << 1 : 0U));  // groups of four: lane 1 is in the first, lane 5 in the second
  for (std::size_t k = 0; k < wrench.size(); ++k) CHECK(wrench[k] == (done != 0 ? alone.wrench[k] : 0.0));
}

TEST_CASE("a run of blocks goes on up to the first side that is not certain to stay whole") {
  Noise noise(15);
  SideUnderTest u(4, 8, 0.5);
  u.side.strength = {1e12, 1e12, 0.6, 1e12, 9.0};
  std::vector<SideUnderTest> sides(5, u);  // a block's constants are those of its own object
  sides[2].side.es = {0.0, 0.8, 0.6}, sides[2].side.et = {0.0, -0.6, 0.8};
  sides[3].side.strength.tension = sides[3].side.strength.cohesion = 0.0;
  const TwoBodies b = random_pose(u, noise, 1e-6);
  const kernels::SideBlock blocks[] = {sides[0].block(1), sides[1].block(2), sides[2].block(3), sides[3].block(4), sides[4].block(5)};
  const std::uint8_t live[] = {1U << 1, 1U << 2, 1U << 3, 1U << 4, 1U << 5};
  const std::int32_t all[] = {0, 1, 2, 3, 4}, some[] = {4, 1, 0};
  std::array<double, 3 * kernels::kWrenchStride> wrench{};
  const kernels::Rows rows{b.pose.data(), b.twist.data(), wrench.data(), nullptr, {}};
  unsigned lanes = 0xff;
  CHECK(kernels::advance_whole({blocks, live, all, 0, {}}, rows, lanes) == 3);
  CHECK(lanes == 0);
  const Vec3 force{wrench[0], wrench[1], wrench[2]};
  CHECK(norm(force) == doctest::Approx(3.0 * norm(part(short_form(blocks[0], live[0], b), 0, 0))).epsilon(1e-9));
  CHECK(kernels::advance_whole({blocks, live, some, 0, {}}, rows, lanes) == 3);
  CHECK(kernels::advance_whole({blocks, live, {}, 0, {}}, rows, lanes) == 0);
}
