// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "geometry/solids/flatten.h"
#include "geometry/solids/pieces.h"
#include "geometry/solids/triangles.h"
#include "tests/io/input/stones/stones_fixture.h"

// Files as drawing programs write them: rounded coordinates, doubled faces, more planes at a corner than can meet there.
using namespace stones;
using namespace voussoir;

namespace {

bool says(const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; }

double rounded(double x, double to) { return std::round(x / to) * to; }

/// A course of a groin: a stone of two barrel vaults at once, folded along the upright plane through their diagonal.
Mesh groin(int course, double raster) {
  constexpr double kCourse = 0.2, kRadius = 1.8, kThickness = 0.25, kTurn = 0.3;  // rad, m, m, rad
  Mesh m;
  const auto add = [&](double r, int k, double along, bool mirrored) {
    const double x = r * std::cos(kCourse * k), y = along * x;
    const Vec3 p{mirrored ? y : x, mirrored ? x : y, r * std::sin(kCourse * k)};
    const Vec3 q{std::cos(kTurn) * p.x - std::sin(kTurn) * p.y, std::sin(kTurn) * p.x + std::cos(kTurn) * p.y, p.z};
    m.vertices.push_back({rounded(q.x, raster), rounded(q.y, raster), rounded(q.z, raster)});
  };
  for (const auto& [along, mirrored] : {std::pair{0.5, false}, std::pair{1.0, false}, std::pair{0.5, true}}) {
    for (const double r : {kRadius, kRadius + kThickness}) add(r, course, along, mirrored);
    for (const double r : {kRadius + kThickness, kRadius}) add(r, course + 1, along, mirrored);
  }
  m.faces = {{0, 1, 2, 3}, {11, 10, 9, 8}};
  for (const std::int32_t leg : {0, 4}) {
    for (std::int32_t i = 0; i < 4; ++i) m.faces.push_back({leg + (i + 1) % 4, leg + i, leg + i + 4, leg + (i + 1) % 4 + 4});
  }
  if (geometry::volume(m) < 0.0) {
    for (auto& loop : m.faces) std::reverse(loop.begin(), loop.end());
  }
  return m;
}

double shortest_edge(const geometry::Polyhedron& p) {
  double least = 1e300;
  for (const auto& loop : p.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      least = std::min(
          least, norm(p.vertices[static_cast<std::size_t>(loop[i])] - p.vertices[static_cast<std::size_t>(loop[(i + 1) % loop.size()])]));
  }
  return least;
}

/// Four faces that meet at one apex.
Mesh pyramid() {
  return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}, {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

/// A slab of thickness 0.3 m on face `f` of a mesh, lifted off it by `gap`.
Mesh slab_on(const Mesh& m, std::size_t f, double gap) {
  const geometry::LoopPlane plane = geometry::loop_plane(m, f);
  Mesh out;
  const auto n = static_cast<std::int32_t>(m.faces[f].size());
  for (const double height : {gap, 0.3}) {
    for (const std::int32_t v : m.faces[f]) out.vertices.push_back(m.vertices[static_cast<std::size_t>(v)] + height * plane.normal);
  }
  std::vector<std::int32_t> low, high;
  for (std::int32_t i = 0; i < n; ++i) {
    low.push_back(n - 1 - i), high.push_back(n + i);
    out.faces.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
  }
  out.faces.push_back(low);
  out.faces.push_back(high);
  return out;
}

}  // namespace

TEST_CASE("stones of a groin drawn in tenths of a millimetre: cut along the fold, without slivers") {
  const TempFolder folder;
  for (const double raster : {1e-4, 2.5e-5, 1e-12}) {
    CAPTURE(raster);
    for (int course = 0; course < 6; ++course) {
      CAPTURE(course);
      const Mesh drawn = groin(course, raster);
      const auto c = load(folder.write("a.obj", obj({{"groin", drawn}})), "supports = 100.0");
      const auto& pieces = c.stones[0].stones[0].pieces;
      CHECK(pieces.size() >= 2);
      CHECK(pieces.size() <= 3);
      double sum = 0.0;
      for (const auto& piece : pieces) sum += geometry::mass_properties(piece.shape).volume;
      CHECK(sum == doctest::Approx(geometry::volume(drawn)).epsilon(2e-3));
      if (pieces.size() == 2) {
        for (const auto& piece : pieces) CHECK(shortest_edge(piece.shape) > 0.1);
      }
    }
  }
}

TEST_CASE("a cut between two faces goes through the corner that it would just miss") {
  // A bent bar in plan: the fold turns by 0.5 rad; the outer corner is drawn 0.03 mm beside the plane that halves it.
  const double a = 0.25;
  Mesh m;
  for (const double z : {0.0, 0.4}) {
    m.vertices.insert(m.vertices.end(), {{0, 0, z}, {0, 0.4, z}, {-std::cos(2 * a), -std::sin(2 * a), z}, {1, 0, z}, {1, 0.4, z}});
    const Vec3 out{-std::sin(2 * a), std::cos(2 * a), 0};
    m.vertices.push_back(m.vertices[m.vertices.size() - 3] + 0.4 * out);
    m.vertices[m.vertices.size() - 5] = Vec3{-0.4 * std::tan(a) + 3e-5, 0.4, z};
  }
  // From above: 0 inner fold, 1 outer fold, 2 and 5 the one end, 3 and 4 the other; 6 to 11 over them.
  const std::vector<std::int32_t> round{0, 3, 4, 1, 5, 2};
  std::vector<std::int32_t> low, high;
  for (std::size_t i = 0; i < 6; ++i) {
    low.push_back(round[5 - i]), high.push_back(round[i] + 6);
    const std::int32_t p = round[i], q = round[(i + 1) % 6];
    m.faces.push_back({p, q, q + 6, p + 6});
  }
  m.faces.push_back(low);
  m.faces.push_back(high);
  REQUIRE_FALSE(geometry::fault_of(m));
  const auto pieces = geometry::convex_pieces(m, 1e-3);
  REQUIRE(pieces.size() == 2);
  for (const auto& piece : pieces) CHECK(shortest_edge(piece) > 0.1);
  double least = 1e300;
  for (const auto& piece : geometry::convex_pieces(m, 1e-6)) least = std::min(least, shortest_edge(piece));
  CHECK(least < 1e-4);  // as the bisector cuts it
}

TEST_CASE("faces that stand twice are read once, and told") {
  const TempFolder folder;
  std::string text = obj({{"cube", box({0, 0, 0}, {1, 1, 1})}});
  const std::size_t last = text.rfind("f ");
  text += text.substr(last);
  const auto c = load(folder.write("a.obj", text), "supports = \"ground\"");
  REQUIRE(c.stones[0].stones.size() == 1);
  CHECK(c.stones[0].stones[0].pieces[0].shape.faces.size() == 6);
  CHECK(says(c.stones[0].notes.at(0), "1 face that stand twice left out"));
}

TEST_CASE("four planes of contacts that miss one point by a hair are let go by less than contacts may be apart") {
  const Mesh core = pyramid();
  std::vector<geometry::RoughSolid> solids{{core, 1e-3, {}}};
  const double gaps[] = {2.2e-6, 2.0e-6, 2.4e-6, 2.1e-6};  // m: the planes in the middle miss a common point by some 1e-7
  for (std::size_t f = 1; f <= 4; ++f) solids.push_back({slab_on(core, f, gaps[f - 1]), 1e-3, {}});
  CHECK_NOTHROW(geometry::flatten(solids, std::nullopt));
  for (std::size_t f = 0; f < 5; ++f) CHECK(geometry::warp(solids[0].mesh, f) <= 1e-9 * geometry::diagonal(core));
  for (std::size_t f = 1; f <= 4; ++f) {
    const auto own = geometry::loop_plane(solids[0].mesh, f);
    const Mesh& slab = solids[f].mesh;
    for (std::size_t v = 0; v < 3; ++v) CHECK(std::abs(dot(slab.vertices[v] - own.centre, own.normal)) < 1e-6);
  }
}

TEST_CASE("warped faces are parted into triangles where the case says so") {
  const TempFolder folder;
  Mesh low = box({0, 0, 0}, {1, 1, 1}), high = box({0, 0, 1}, {1, 1, 2});
  std::string file;
  SUBCASE("a face that bulges: one convex stone") {
    for (Vec3& v : low.vertices) v.z += v.z > 0.5 && std::abs(v.x - v.y) < 0.5 ? 0.04 : 0.0;  // the corners on the diagonal that is chosen
    file = folder.write("a.obj", obj({{"low", low}}));
    CHECK(says(refusal(file, "supports = \"ground\""), "stones.warped = \"triangles\""));
    const auto c = load(file, "supports = \"ground\"\nwarped = \"triangles\"");
    const auto& stone = c.stones[0].stones[0];
    CHECK(says(stone.change, "1 warped face parted into triangles"));
    double sum = 0.0;
    for (const auto& piece : stone.pieces) sum += geometry::mass_properties(piece.shape).volume;
    CHECK((sum == doctest::Approx(1.0 + 0.04 * 2.0 / 3.0).epsilon(1e-9) || sum == doctest::Approx(1.0 + 0.04 / 3.0).epsilon(1e-9)));
  }
  SUBCASE("a joint that is warped: both stones are parted alike and touch all over") {
    for (Mesh* m : {&low, &high}) {
      for (Vec3& v : m->vertices) v.z += v.z > 0.5 && v.z < 1.5 && v.x > 0.5 && v.y > 0.5 ? 0.05 : 0.0;
    }
    file = folder.write("a.obj", obj({{"low", low}, {"high", high}}));
    CHECK(says(refusal(file, "supports = \"ground\""), "has a face warped by 12.5 mm"));
    const auto c = load(file, "supports = \"ground\"\nwarped = \"triangles\"");
    const cases::Model m = model_of(c);
    double area = 0.0, volume = 0.0;
    for (const auto& joint : m.assembly.joints) {
      const auto a = static_cast<std::size_t>(joint.element_a), b = static_cast<std::size_t>(joint.element_b);
      if (joint.element_b >= 0 && m.blocks[a].stone != m.blocks[b].stone) area += joint.area;
    }
    for (const auto& e : m.assembly.elements) volume += e.mass.volume;
    CHECK(volume == doctest::Approx(2.0).epsilon(1e-9));
    const double half = 0.5 * std::sqrt(1.0 + 0.05 * 0.05), folded = 0.5 + 0.5 * std::sqrt(1.0 + 2.0 * 0.05 * 0.05);
    CHECK((area == doctest::Approx(2.0 * half).epsilon(1e-9) || area == doctest::Approx(folded).epsilon(1e-9)));
  }
  SUBCASE("an order of corners that starts elsewhere, and the other way round, changes nothing") {
    std::size_t parted = 0;
    Mesh one{{{0, 0, 0}, {2, 0, 0.1}, {3, 1, -0.1}, {2, 2, 0.1}, {0, 2, 0}, {-1, 1, 0.1}}, {{0, 1, 2, 3, 4, 5}}}, other = one;
    other.faces = {{3, 2, 1, 0, 5, 4}};
    const auto edges = [](const Mesh& m) {
      std::set<std::pair<std::int32_t, std::int32_t>> out;
      for (const auto& loop : m.faces) {
        for (std::size_t i = 0; i < loop.size(); ++i) out.insert(std::minmax({loop[i], loop[(i + 1) % loop.size()]}));
      }
      return out;
    };
    one = geometry::with_parted_faces(one, 1e-3, parted);
    CHECK(one.faces.size() == 4);
    CHECK(edges(one) == edges(geometry::with_parted_faces(other, 1e-3, parted)));
    CHECK(parted == 2);
  }
}
