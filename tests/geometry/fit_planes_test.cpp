// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids/fit/fit_planes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "geometry/assembly.h"
#include "geometry/nth.h"
#include "geometry/prism.h"
#include "geometry/solids/fit/fit_cells.h"
#include "geometry/solids/fit/half_spaces.h"
#include "tests/geometry/random_masonry.h"

using namespace voussoir;
using namespace voussoir::geometry;
using masonry::Numbers;

namespace {

constexpr double kLimit = 0.03;  // m

/// Convex stones as `fit_planes` takes them. \param moved  m, by making the most warped of them convex
std::vector<FitStone> convex(const std::vector<Mesh>& stones, double& moved) {
  std::vector<FitStone> out;
  for (const Mesh& m : stones) {
    double by = 0.0;
    if (is_convex(m, 1e-9 * diagonal(m))) {
      out.push_back({{in_prism_order({m.vertices, m.faces})}, kLimit, 1e-3});
    } else {
      FitWork work(m.faces.size());
      const auto shape = nearly_convex(m, kLimit, by, work, 0);
      REQUIRE(shape.has_value());
      out.push_back({{*shape}, kLimit, 1e-3});
    }
    moved = std::max(moved, by);
  }
  return out;
}

/// How far the surfaces of two sets of pieces are from each other.
double distance_of(const std::vector<Polyhedron>& a, const std::vector<Polyhedron>& b) {
  return std::max(farthest_outside(a, b).out, farthest_outside(b, a).out);
}

using Areas = std::map<std::pair<std::int32_t, std::int32_t>, double>;  // m2, by pair of stones

/// Areas in which stones touch. Fails the test where stones overlap.
Areas touching(const std::vector<FittedStone>& stones) {
  std::vector<Part> parts;
  std::vector<std::int32_t> stone;
  for (std::size_t i = 0; i < stones.size(); ++i) {
    for (const Polyhedron& p : stones[i].pieces) {
      parts.push_back({.shape = &p, .segment_size = 10.0, .anchored = true});
      stone.push_back(static_cast<std::int32_t>(i));
    }
  }
  Areas out;
  for (const Joint& j : assemble(parts, std::nullopt).joints) out[{nth(stone, j.element_a), nth(stone, j.element_b)}] += j.area;
  return out;
}

}  // namespace

TEST_CASE("exact arches and walls keep their bits") {
  Numbers any(69);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    double moved = 0.0;
    const std::vector<FitStone> stones = convex(k % 2 == 0 ? masonry::arch(any) : masonry::wall(any), moved);
    CHECK(moved == 0.0);
    const std::vector<FittedStone> fitted = fit_planes(stones, std::nullopt);
    REQUIRE(fitted.size() == stones.size());
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      CHECK(!fitted[i].changed);
      REQUIRE(fitted[i].pieces.size() == 1);
      CHECK(fitted[i].pieces[0].vertices == stones[i].pieces[0].vertices);
    }
  }
}

TEST_CASE("arches and walls drawn without care come back within twice the carelessness, with all their joints") {
  Numbers any(70);
  double worst = 0.0, worst_volume = 0.0;
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const double most = any.between(1e-4, 8e-3);
    const std::vector<Mesh> exact = k % 2 == 0 ? masonry::arch(any) : masonry::wall(any);
    double unmoved = 0.0, moved = 0.0;
    const std::vector<FitStone> wanted = convex(exact, unmoved);
    const std::vector<FitStone> given = convex(masonry::drawn_without_care(exact, any, most), moved);
    const std::vector<FittedStone> fitted = fit_planes(given, std::nullopt);
    CHECK(moved <= 2.0 * most);
    for (std::size_t i = 0; i < fitted.size(); ++i) {
      const double off = distance_of(fitted[i].pieces, wanted[i].pieces) / most;
      worst = std::max(worst, off);
      CHECK(off <= 2.0);
      CHECK(distance_of(fitted[i].pieces, given[i].pieces) == doctest::Approx(fitted[i].moved));
      worst_volume = std::max(worst_volume, std::abs(fitted[i].now / volume_of(wanted[i].pieces) - 1.0));
      for (const Polyhedron& p : fitted[i].pieces) validate(p);
    }
    const Areas as_drawn = touching(fit_planes(wanted, std::nullopt)), now = touching(fitted);
    for (const auto& [pair, area] : as_drawn) {
      const auto found = now.find(pair);
      CAPTURE(area);
      if (area < 6.0 * most * 0.8) continue;  // a strip that carelessness may take away
      REQUIRE(found != now.end());
      CHECK(std::abs(found->second - area) < 6.0 * most * 0.8);
    }
  }
  MESSAGE("farthest from the exact stones, of the carelessness: " << worst << "; volume off by up to " << worst_volume);
}

namespace {

/// What becomes of the stones of a file that is moved, turned, mirrored or in another order.
void check_alike(const std::vector<Mesh>& here, const std::vector<Mesh>& there, const std::function<Vec3(Vec3)>& back, bool reversed) {
  double unused = 0.0;
  const std::vector<FittedStone> a = fit_planes(convex(here, unused), std::nullopt);
  const std::vector<FittedStone> b = fit_planes(convex(there, unused), std::nullopt);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const FittedStone& other = b[reversed ? a.size() - 1 - i : i];
    REQUIRE(other.pieces.size() == a[i].pieces.size());
    CHECK(other.now == doctest::Approx(a[i].now).epsilon(1e-9));
    CHECK(std::abs(other.moved - a[i].moved) < 1e-9);
    std::vector<Polyhedron> pieces = other.pieces;
    for (Polyhedron& p : pieces) {
      for (Vec3& v : p.vertices) v = back(v);
    }
    CHECK(farthest_outside(pieces, a[i].pieces).out < 1e-9);
  }
}

}  // namespace

TEST_CASE("moved, turned, mirrored and renumbered stones are fitted alike, to a nanometre") {
  Numbers any(71);
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    const std::vector<Mesh> stones =
        masonry::drawn_without_care(k % 2 == 0 ? masonry::arch(any) : masonry::wall(any), any, any.between(1e-4, 8e-3));
    const Vec3 by = any.vector(10.0);
    std::vector<Mesh> there = stones;
    for (Mesh& m : there) {
      for (Vec3& v : m.vertices) v += by;
    }
    check_alike(
        stones, there, [&](Vec3 v) { return v - by; }, false);

    const Vec3 axis = any.vector(1.0);
    const double angle = any.between(0.1, 3.0);
    there = stones;
    for (Mesh& m : there) m.vertices = rotated({m.vertices, {}}, axis, angle, {}).vertices;
    check_alike(
        stones, there,
        [&](Vec3 v) {
          return rotated({{v}, {}}, axis, -angle, {}).vertices[0];
        },
        false);

    there = stones;
    for (Mesh& m : there) {
      for (Vec3& v : m.vertices) v.x = -v.x;
      for (auto& loop : m.faces) std::reverse(loop.begin(), loop.end());
    }
    check_alike(
        stones, there,
        [](Vec3 v) {
          return Vec3{-v.x, v.y, v.z};
        },
        false);

    there.assign(stones.rbegin(), stones.rend());
    check_alike(
        stones, there, [](Vec3 v) { return v; }, true);
  }
}

TEST_CASE("stones deep in each other are parted by one plane, and gaps are closed") {
  // Two boxes side by side, one half a decimetre in the other, over a third that stands a centimetre lower.
  const auto stone = [](Vec3 low, Vec3 high) { return FitStone{{make_box(low, high)}, 0.06, 1e-3}; };
  const std::vector<FitStone> stones{stone({0, 0, 0}, {0.5, 0.3, 0.2}), stone({0.4, 0, 0}, {0.9, 0.3, 0.2}),
                                     stone({0.1, 0, -0.3}, {0.8, 0.3, -0.01})};
  const std::vector<FittedStone> done = fit_planes(stones, std::nullopt);
  const Areas areas = touching(done);
  CHECK(areas.at({0, 1}) == doctest::Approx(0.3 * 0.205));
  CHECK(areas.at({0, 2}) == doctest::Approx(0.3 * 0.35));
  CHECK(areas.at({1, 2}) == doctest::Approx(0.3 * 0.35));
  CHECK(done[0].moved == doctest::Approx(0.05));
  CHECK(done[2].moved == doctest::Approx(0.005));
  CHECK(done[2].now == doctest::Approx(0.7 * 0.3 * 0.295));
}

TEST_CASE("a face under two neighbours at unlike angles is cut into pieces, and both keep their joints") {
  // Two stones lean towards each other, like the sides of a valley, in which their one support is broader.
  const auto leaning = [](double sign) {
    Polyhedron p = make_box({sign > 0 ? 0.0 : -0.4, 0, 0.3}, {sign > 0 ? 0.4 : 0.0, 0.3, 0.5});
    return rotated(p, {0, 1, 0}, -sign * 0.12, {0, 0, 0.3});
  };
  const std::vector<FitStone> stones{
      {{make_box({-0.4, 0, 0}, {0.4, 0.3, 0.32})}, 0.03, 1e-3}, {{leaning(1.0)}, 0.03, 1e-3}, {{leaning(-1.0)}, 0.03, 1e-3}};
  const std::vector<FittedStone> done = fit_planes(stones, std::nullopt);
  CHECK(done[0].pieces.size() == 2);
  const Areas areas = touching(done);
  CHECK(areas.at({0, 1}) > 0.1);
  CHECK(areas.at({0, 2}) > 0.1);
}

TEST_CASE("the base cuts stones that reach under it, and those that stand over it are filled") {
  const std::vector<FitStone> stones{{{make_box({0, 0, -0.01}, {0.3, 0.3, 0.3})}, 0.03, 1e-3},
                                     {{make_box({1, 0, 0.02}, {1.3, 0.3, 0.3})}, 0.03, 1e-3}};
  for (const FittedStone& s : fit_planes(stones, 0.0)) CHECK(s.now == doctest::Approx(0.3 * 0.3 * 0.3));
}

TEST_CASE("the work of a fit is bounded by the faces of the file, and the stone at fault is told") {
  FitWork work(100);
  CHECK_NOTHROW(work.add(1.1e9, 0));
  try {
    work.add(2e8, 7);
    FAIL("no bound");
  } catch (const ModelError& e) {
    CHECK(e.subject() == 7);
  }
  // A slab under so many stones, each on a plane of its own, that the pairs of their planes alone would take minutes.
  std::vector<FaceShare> shares;
  for (int i = 0; i < 40000; ++i)
    shares.push_back({0, {{0, 0, 1}, 1e-4 * i}, {{0.0, 0.0, 1e-4 * i}, {1.0, 0.0, 1e-4 * i}, {0.0, 1.0, 1e-4 * i}}});
  const std::vector<HalfSpace> own{{{0, 0, 1}, 0.0}};
  FitWork few(6);
  CHECK_THROWS_WITH_AS(fitted_cells(own, shares, few, 3), doctest::Contains("cannot be fitted within reasonable time"), ModelError);
}
