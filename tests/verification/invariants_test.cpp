// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "tests/verification/fixture.h"

// V12: the response does not know where the house stands, how it is turned, nor in which order its bricks are numbered.
namespace voussoir::testing {
namespace {

constexpr double kEnd = 0.5,
                 kEndOfHouse = 0.05;  // s; by then the house is cracked all over. Later a point may break a step earlier in one of both

/// Where a point of the first case lies in the second. Linear but for `shift`.
struct Image {
  std::function<Vec3(Vec3)> turn = [](Vec3 x) { return x; };
  Vec3 shift;
};

/// Elements of both runs by place: index in `b` of the image of each element of `a`.
std::vector<std::size_t> partners(const Run& a, const Run& b, const Image& image) {
  const auto key = [](Vec3 x) {
    return std::array<long long, 3>{std::llround(1e6 * x.x), std::llround(1e6 * x.y), std::llround(1e6 * x.z)};
  };
  std::map<std::array<long long, 3>, std::size_t> places;
  for (std::size_t i = 0; i < b.count(); ++i) places[key(b.position(i) - image.shift)] = i;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < a.count(); ++i) found.push_back(places.at(key(image.turn(a.position(i)))));
  return found;
}

struct Difference {
  double most = 0.0, scale = 0.0;  // m, between displacements; largest displacement
  solver::Damage a, b;
};

/// Runs both side by side.
Difference compare(const cases::Case& first, const cases::Case& second, const Image& image, double end) {
  Run a(first), b(second);
  const std::vector<std::size_t> partner = partners(a, b, image);
  Difference d;
  a.until(end, {}, [&] {
    if (a.sim().steps() % 100 == 0) {
      for (std::size_t i = 0; i < a.count(); ++i) {
        d.most = std::max(d.most, norm(image.turn(a.displacement(i)) - b.displacement(partner[i])));
        d.scale = std::max(d.scale, norm(a.displacement(i)));
      }
    }
    for (std::int64_t k = 0; k < b.sim().cycle(); ++k) b.sim().step({});
  });
  d.a = a.sim().damage(), d.b = b.sim().damage();
  return d;
}

void expect_same(const std::string& what, const cases::Case& first, const cases::Case& second, const Image& image, double end = kEnd) {
  const Difference d = compare(first, second, image, end);
  MESSAGE(what, ": largest displacement ", d.scale, " m, broken in tension ", d.a.tension, ", slipped ", d.a.slipped);
  CHECK(d.scale > 1e-3);     // it moved,
  CHECK(d.a.tension > 100);  // and cracked
  CHECK(d.a.tension == d.b.tension);
  CHECK(d.a.shear == d.b.shear);
  CHECK(d.a.compression == d.b.compression);
  CHECK(d.a.slipped == d.b.slipped);
  expect_below("V12 " + what + ", difference over largest displacement", d.most / d.scale, 1e-6);
}

/// The wall under a pulse across and along that cracks it at once, so that half a second has cracks, slip and rocking in it.
cases::Case shaken_wall(const std::vector<std::string>& more = {}) {
  std::vector<std::string> keys{"gravity.settle=false", "motion.record=", "motion.x=pulse.csv", "motion.y=pulse.csv",
                                "motion.scale=[0.1,0.3,1.0]"};
  keys.insert(keys.end(), more.begin(), more.end());
  return load("wall", keys).value;
}

/// A house as free blocks, in the order of its elements.
cases::Case as_blocks(cases::Case c) {
  const cases::Model m = cases::build_model(c);
  c.house.reset();
  for (std::size_t i = 0; i < m.blocks.size(); ++i) {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (const Vec3& v : m.blocks[i].shape.vertices) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    cases::BlockSpec b;
    b.name = "b" + std::to_string(i), b.material = m.materials[static_cast<std::size_t>(m.blocks[i].material)].name;
    b.box = {{low, high}};
    c.blocks.push_back(b);
  }
  return c;
}

/// The blocks where a map along the axes brings them.
void place(cases::Case& c, Vec3 (*map)(Vec3)) {
  for (cases::BlockSpec& b : c.blocks) {
    const Vec3 p = map((*b.box)[0]), q = map((*b.box)[1]);
    b.box = {
        {Vec3{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)}, {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}}};
  }
}
Vec3 mirror(Vec3 x) { return {-x.x, x.y, x.z}; }
Vec3 quarter_turn(Vec3 x) { return {-x.y, x.x, x.z}; }

/// The courses at odd heights a hair aside within the wall, so that the grids of bed joints do not coincide; one course of timber.
cases::Case with_timber(cases::Case c) {
  c.materials["timber"] = {600.0, 9.8e8, 0.3};
  double length = 0.0;
  for (const cases::BlockSpec& b : c.blocks) length = std::max(length, (*b.box)[1].x);
  for (cases::BlockSpec& b : c.blocks) {
    auto& [low, high] = *b.box;
    const auto course = std::lround(low.z / (high.z - low.z));
    for (double* x : {&low.x, &high.x}) {
      if (course % 2 == 1 && *x > 0.01 && *x < length - 0.01) *x -= 0.01;
    }
    if (course == 3) b.material = "timber";
  }
  return c;
}

/// Where a house lies that `house.turn` has turned by a quarter.
Image turned_image(const cases::Case& first, const cases::Case& turned) {
  const auto middle = [](const cases::Case& c) {
    Vec3 low{1e300, 1e300, 0.0}, high{-1e300, -1e300, 0.0};
    for (const geometry::Element& e : cases::build_model(c).assembly.elements) {
      const Vec3 x = e.mass.centroid;
      low = {std::min(low.x, x.x), std::min(low.y, x.y), 0.0}, high = {std::max(high.x, x.x), std::max(high.y, x.y), 0.0};
    }
    return 0.5 * (low + high);
  };
  return {quarter_turn, middle(turned) - quarter_turn(middle(first))};
}

}  // namespace

TEST_CASE("V12: turned by a right angle, with the motion") {
  // x' = −y, y' = x: what went along x goes along y, what went along y goes along −x.
  const cases::Case first = shaken_wall(), turned = shaken_wall({"house.turn=90", "motion.scale=[-0.3,0.1,1.0]"});
  expect_same("turned by 90 degrees", first, turned, turned_image(first, turned));
}

TEST_CASE("V12: moved by 1 km") {
  expect_same("moved by 1 km", shaken_wall(), shaken_wall({"house.origin=[1000.0,-1000.0]"}),
              {[](Vec3 x) { return x; }, {1000.0, -1000.0, 0.0}});
}

TEST_CASE("V12: renumbered") {
  cases::Case other = as_blocks(shaken_wall());
  std::reverse(other.blocks.begin(), other.blocks.end());
  std::rotate(other.blocks.begin(), other.blocks.begin() + 7, other.blocks.end());
  expect_same("renumbered", shaken_wall(), other, {});
}

TEST_CASE("V12: mirrored") {
  cases::Case other = as_blocks(shaken_wall());
  place(other, mirror);
  other.motion->scale[0] *= -1.0;
  expect_same("mirrored", as_blocks(shaken_wall()), other, {mirror, {}});
}

TEST_CASE("V12: joints of two sides, and a course of timber") {
  const cases::Case first = with_timber(as_blocks(shaken_wall()));
  const auto two_sided = [](const geometry::Joint& j) { return j.element_b >= 0 && !j.merged; };
  CHECK(std::ranges::count_if(cases::build_model(first).assembly.joints, two_sided) > 30);
  SUBCASE("renumbered") {
    cases::Case other = first;
    std::rotate(other.blocks.begin(), other.blocks.begin() + 31, other.blocks.end());
    std::ranges::reverse(other.blocks.begin(), other.blocks.begin() + 20);
    expect_same("two sides, renumbered", first, other, {});
  }
  SUBCASE("mirrored") {
    cases::Case other = first;
    place(other, mirror);
    other.motion->scale[0] *= -1.0;
    expect_same("two sides, mirrored", first, other, {mirror, {}});
  }
  SUBCASE("turned") {
    cases::Case other = first;
    place(other, quarter_turn);
    other.motion->scale = {-first.motion->scale[1], first.motion->scale[0], first.motion->scale[2]};
    expect_same("two sides, turned by 90 degrees", first, other, {quarter_turn, {}});
  }
}

TEST_CASE("V12: a house of four walls with a door, a lintel and a roof") {
  const cases::Case first = load("small_house").value;
  SUBCASE("turned") {
    const cases::Case turned = load("small_house", {"house.turn=90", "motion.scale=[-0.3,0.2,0.1]"}).value;
    expect_same("house turned by 90 degrees", first, turned, turned_image(first, turned), kEndOfHouse);
  }
  SUBCASE("moved") {
    expect_same("house moved by 1 km", first, load("small_house", {"house.origin=[1000.0,-1000.0]"}).value,
                {[](Vec3 x) { return x; }, {1000.0, -1000.0, 0.0}}, kEndOfHouse);
  }
  // Blocks know no members of timber: all of it is one wood, and so in both.
  cases::Case blocks = as_blocks(first);
  blocks.joints.between.push_back({{"wood", "wood"}, "wood"});
  cases::Case other = blocks;
  SUBCASE("renumbered") {
    std::rotate(other.blocks.begin(), other.blocks.begin() + 101, other.blocks.end());
    std::ranges::reverse(other.blocks.begin(), other.blocks.begin() + 250);
    expect_same("house renumbered", blocks, other, {}, kEndOfHouse);
  }
  SUBCASE("mirrored") {
    place(other, mirror);
    other.motion->scale[0] *= -1.0;
    expect_same("house mirrored", blocks, other, {mirror, {}}, kEndOfHouse);
  }
}

}  // namespace voussoir::testing
