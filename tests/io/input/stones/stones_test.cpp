// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/stones.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "cases/loads/loads.h"
#include "cases/solids/stone_blocks.h"
#include "geometry/separation.h"
#include "io/input/stones/stone_sizes.h"
#include "io/output/results/checkpoint_stones.h"
#include "tests/io/input/stones/written_files.h"

using namespace stones;
using voussoir::cases::Model;

namespace {

const std::string kBase = "[base]\nz = 0.0\n";

bool says(const std::string& message, const std::string& words) { return message.find(words) != std::string::npos; }

double rounded(double x, double to) { return std::round(x / to) * to; }

/// Turned a little about z, then every corner to a raster, as files with few decimals have them: so no face is quite plane.
std::vector<Named> coarse(std::vector<Named> all, double raster) {
  for (Named& n : all) {
    n.mesh.vertices = voussoir::geometry::rotated({n.mesh.vertices, {}}, {0, 0, 1}, 0.3, {}).vertices;
    for (Vec3& v : n.mesh.vertices) v = {rounded(v.x, raster), rounded(v.y, raster), rounded(v.z, raster)};
  }
  return all;
}

/// An extruded outline in the x-z plane, counter-clockwise seen from -y.
Named extruded(const std::string& name, const std::vector<std::array<double, 2>>& outline, double depth) {
  Named n{name, {}};
  const auto k = static_cast<std::int32_t>(outline.size());
  for (const double y : {0.0, depth}) {
    for (const auto& p : outline) n.mesh.vertices.push_back({p[0], y, p[1]});
  }
  std::vector<std::int32_t> front, back;
  for (std::int32_t i = 0; i < k; ++i) {
    front.push_back(i);
    back.push_back(2 * k - 1 - i);
    n.mesh.faces.push_back({i, i + k, (i + 1) % k + k, (i + 1) % k});
  }
  n.mesh.faces.push_back(front);
  n.mesh.faces.push_back(back);
  return n;
}

double total_volume(const Model& m) {
  double sum = 0.0;
  for (const auto& e : m.assembly.elements) sum += e.mass.volume;
  return sum;
}

}  // namespace

TEST_CASE("an arch drawn in half millimetres: faces a little apart are put into one plane") {
  const TempFolder folder;
  const auto all = arch(17, 2.0, 2.37, 0.7), drawn = coarse(all, 5e-4);
  const Model exact = model_of(load(folder.write("exact.obj", obj(all)), "", kBase));
  SUBCASE("as quadrilaterals, which are warped") {
    const auto c = load(folder.write("a.obj", obj(drawn)), "", kBase);
    const Model m = model_of(c);
    CHECK(m.assembly.joints.size() == exact.assembly.joints.size());
    CHECK(total_volume(m) == doctest::Approx(total_volume(exact)).epsilon(3e-3));
    for (const auto& stone : c.stones[0].stones) CHECK(stone.pieces.size() == 1);
    CHECK(says(c.stones[0].stones[5].change, "corners moved by up to 0."));
  }
  SUBCASE("as triangles") {
    std::vector<Named> triangles = drawn;
    for (Named& n : triangles) n.mesh = in_triangles(n.mesh);
    const Model m = model_of(load(folder.write("a.obj", obj(triangles)), "", kBase));
    CHECK(m.blocks.size() == 17);
    CHECK(m.assembly.joints.size() >= exact.assembly.joints.size());
    CHECK(total_volume(m) == doctest::Approx(total_volume(exact)).epsilon(3e-3));
  }
  SUBCASE("with a snap that is too small nothing holds it") {
    CHECK(says(refusal(folder.write("a.obj", obj(drawn)), "snap = 1e-5", kBase), "warped by"));
  }
}

TEST_CASE("stones that touch exactly keep their bits, whatever snap is") {
  const TempFolder folder;
  const std::string file = folder.write("a.obj", obj(arch(9, 2.0, 2.4, 0.7)));
  const auto a = load(file, "snap = 0.0", kBase), b = load(file, "snap = 0.02", kBase);
  for (std::size_t i = 0; i < 9; ++i) {
    CHECK(a.stones[0].stones[i].change.empty());
    CHECK(a.stones[0].stones[i].pieces[0].shape.vertices == b.stones[0].stones[i].pieces[0].shape.vertices);
  }
}

TEST_CASE("a gap is a bed of mortar: stones are grown to its middle, and its thickness enters the law") {
  const TempFolder folder;
  const std::string file = folder.write("a.obj", obj({{"low", box({0, 0, 0}, {1, 0.5, 0.3})},
                                                      {"left", box({0, 0, 0.31}, {0.495, 0.5, 0.6})},
                                                      {"right", box({0.505, 0, 0.31}, {1, 0.5, 0.6})}}));
  const std::string mortar = kBase +
                             "[joint_laws.mortar]\ntension = 1e5\ncohesion = 2e5\nfriction = 30.0\ncompression = 1e7\nthickness = "
                             "0.02\nyoung = 3e8\npoisson = 0.2\n";
  const auto c = load(file, "gap = 0.01\njoint = \"mortar\"", mortar);
  const Model m = model_of(c);
  REQUIRE(m.assembly.joints.size() == 4);  // two beds, an upright, the base
  for (std::size_t j = 0; j < m.assembly.joints.size(); ++j) {
    const auto& law = m.laws[static_cast<std::size_t>(m.joint_law[j])];
    const bool base = m.assembly.joints[j].element_b < 0;
    CHECK(law.name == (base ? "dry" : "mortar, bed of 10 mm"));
    CHECK(law.value.thickness == doctest::Approx(base ? 0.0 : 0.01));
    if (!base) CHECK(law.value.young == 3e8);
  }
  const auto top = voussoir::geometry::bounds(m.blocks[0].shape).high.z;
  CHECK(top == doctest::Approx(0.305).epsilon(1e-12));
  CHECK(total_volume(m) == doctest::Approx(1.0 * 0.5 * 0.6).epsilon(1e-12));
  CHECK(says(c.stones[0].stones[1].change, "grown to the middle of mortar on 2 faces"));
  CHECK(says(refusal(file, "gap = 0.01", mortar), "has no young"));
  CHECK(says(refusal(file, "joint = \"mortar\"", mortar), "touches nothing"));
}

TEST_CASE("a stone that is not convex is cut along its reflex edges, and its pieces never part unless a law says so") {
  const TempFolder folder;
  const Named l = extruded("L", {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.5);
  SUBCASE("an L") {
    const auto c = load(folder.write("a.obj", obj({l})), "", kBase);
    const Model m = model_of(c);
    REQUIRE(m.blocks.size() == 2);
    CHECK(m.blocks[0].name == "L/1");
    CHECK(total_volume(m) == doctest::Approx(0.5 * (1.0 * 0.4 + 0.4 * 0.6)).epsilon(1e-12));
    int inside = 0;
    for (std::size_t j = 0; j < m.assembly.joints.size(); ++j) {
      if (m.assembly.joints[j].element_b < 0) continue;
      ++inside;
      CHECK(m.laws[static_cast<std::size_t>(m.joint_law[j])].never_breaks);
      CHECK(m.assembly.joints[j].area == doctest::Approx(0.4 * 0.5));
    }
    CHECK(inside == 1);
    CHECK(says(c.stones[0].stones[0].change, "not convex, cut into 2 pieces that never part"));
  }
  SUBCASE("a cross needs two cuts, a star with five points three to five") {
    const Named cross = extruded(
        "cross",
        {{0.4, 0}, {0.6, 0}, {0.6, 0.4}, {1, 0.4}, {1, 0.6}, {0.6, 0.6}, {0.6, 1}, {0.4, 1}, {0.4, 0.6}, {0, 0.6}, {0, 0.4}, {0.4, 0.4}},
        0.5);
    CHECK(model_of(load(folder.write("a.obj", obj({cross})), "", kBase)).blocks.size() == 3);
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < 10; ++i) {
      const double angle = 0.2 * 3.141592653589793 * (i - 2.5), r = i % 2 == 0 ? 1.0 : 0.45;
      points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    const Model star = model_of(load(folder.write("b.obj", obj({extruded("star", points, 0.5)})), "supports = \"ground\""));
    CHECK(star.blocks.size() >= 4);
    CHECK(star.blocks.size() <= 6);
    CHECK(total_volume(star) == doctest::Approx(0.5 * 10.0 * 0.5 * 0.45 * std::sin(0.2 * 3.141592653589793)).epsilon(1e-12));
  }
  SUBCASE("with a law for its inside") {
    const std::string law = "[joint_laws.crack]\ntension = 1e6\ncohesion = 1e6\nfriction = 40.0\ncompression = 1e8\n";
    auto c = voussoir::io::read_case({"t", "[materials.stone]\ndensity = 2000.0\nyoung = 1e9\npoisson = 0.2\ninside = \"crack\"\n" + law +
                                               kBase + "[[stones]]\nunit = \"m\"\nfile = \"" + folder.write("a.obj", obj({l})) + "\"\n"})
                 .value;
    voussoir::io::load_stones(c);
    const Model m = model_of(c);
    bool found = false;
    for (const std::int32_t law_of : m.joint_law) found = found || m.laws[static_cast<std::size_t>(law_of)].name == "crack";
    CHECK(found);
  }
  SUBCASE("in triangles, turned and moved") {
    Named turned = l;
    turned.mesh = in_triangles(l.mesh);  // the L-shaped ends as fans would overlap: cut them by hand
    turned.mesh.faces.erase(turned.mesh.faces.end() - 8, turned.mesh.faces.end());
    for (const auto& t : {std::array{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
      turned.mesh.faces.push_back({t[0], t[1], t[2]});
      turned.mesh.faces.push_back({t[2] + 6, t[1] + 6, t[0] + 6});
    }
    const auto c =
        load(folder.write("a.obj", obj({turned})), "turn = { axis = [1, 2, 3], angle = 37.0 }\nplace = [5, -3, 7]\nsupports = \"ground\"");
    const Model m = model_of(c);
    CHECK(m.blocks.size() == 2);
    CHECK(total_volume(m) == doctest::Approx(0.5 * (1.0 * 0.4 + 0.4 * 0.6)).epsilon(1e-11));
  }
  SUBCASE("a voussoir with a hollow intrados of eight facets") {
    std::vector<std::array<double, 2>> outline;
    for (int i = 0; i <= 8; ++i) outline.push_back({std::sin(-0.3 + 0.075 * i), std::cos(-0.3 + 0.075 * i)});
    outline.push_back({1.6 * std::sin(0.3), 1.6 * std::cos(0.3)});
    outline.push_back({1.6 * std::sin(-0.3), 1.6 * std::cos(-0.3)});
    const Named v = extruded("v", outline, 0.4);
    const double whole = voussoir::geometry::volume(v.mesh);
    REQUIRE(whole > 0.0);
    const Model m = model_of(load(folder.write("a.obj", obj({v})), "supports = \"ground\""));
    CHECK(m.blocks.size() == 8);
    CHECK(total_volume(m) == doctest::Approx(whole).epsilon(1e-12));
    // Cut between the facets, not along one of them: wedges of about one size, no slivers.
    for (const auto& element : m.assembly.elements) CHECK(element.mass.volume > 0.1 * whole);
  }
  SUBCASE("a plate with a hole") {
    Mesh m = box({0, 0, 0}, {3, 3, 1});
    const Mesh hole = box({1, 1, 0}, {2, 2, 1});
    m.vertices.insert(m.vertices.end(), hole.vertices.begin(), hole.vertices.end());
    m.faces.erase(m.faces.begin() + 4, m.faces.end());  // bottom and top give way to rings of quadrilaterals
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      m.faces.push_back({next, i, i + 8, next + 8});
      m.faces.push_back({i + 4, next + 4, next + 12, i + 12});
      m.faces.push_back({i + 8, i + 12, next + 12, next + 8});
    }
    const auto c = load(folder.write("a.obj", obj({{"plate", m}})), "", kBase);
    const Model model = model_of(c);
    CHECK(model.blocks.size() == 4);
    CHECK(total_volume(model) == doctest::Approx(8.0).epsilon(1e-12));
  }
}

TEST_CASE("a stone is the same whichever of its faces are drawn inside out, and says how many were") {
  const TempFolder folder;
  std::mt19937 random(9);
  Mesh angle = box({0, 0, 0}, {1, 1, 1});  // an L: not convex
  angle.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0},
                    {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
  angle.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}, {0, 1, 7, 6},   {1, 2, 8, 7},
                 {2, 3, 9, 8},       {3, 4, 10, 9},        {4, 5, 11, 10}, {5, 0, 6, 11}};
  for (const Mesh& good : {box({0, 0, 0}, {1, 2, 3}), angle}) {
    const auto as_drawn = load(folder.write("good.obj", obj({{"s", good}}))).stones[0].stones[0];
    for (int k = 0; k < 20; ++k) {
      Mesh odd = good;
      std::size_t turned = 0;
      for (auto& loop : odd.faces) {
        if (k > 0 && random() % 2 == 0) continue;  // first: all of them
        std::reverse(loop.begin() + 1, loop.end());
        ++turned;
      }
      const auto stone = load(folder.write("odd.obj", obj({{"s", odd}}))).stones[0].stones[0];
      REQUIRE(stone.pieces.size() == as_drawn.pieces.size());
      for (std::size_t p = 0; p < stone.pieces.size(); ++p) CHECK(stone.pieces[p].shape.vertices == as_drawn.pieces[p].shape.vertices);
      CHECK(says(stone.change, std::to_string(turned) + (turned == 1 ? " face" : " faces") + " drawn inside out turned round") ==
            (turned > 0));
    }
  }
}

TEST_CASE("what cannot be mended is refused with the stone's name, where it is and what to do") {
  const TempFolder folder;
  const Mesh cube = box({0, 0, 0}, {1, 1, 1});
  int n = 0;
  const auto fault = [&](const std::vector<Named>& all, const std::string& keys = "") {
    return refusal(folder.write(std::to_string(n++) + ".obj", obj(all)), keys, kBase);
  };
  SUBCASE("open") {
    Mesh m = cube;
    m.faces.pop_back();
    const std::string message = fault({{"lid", m}});
    CHECK(says(message, "stones[0].file"));
    CHECK(says(message, "stone \"lid\""));
    CHECK(says(message, "is open: 4 edges of one face only, the first from (0, 0, 1) to"));
    CHECK(says(message, "close it where it was drawn"));
  }
  SUBCASE("faces turned against each other where it is open") {
    Mesh m = cube;
    std::reverse(m.faces[2].begin(), m.faces[2].end());
    m.faces.pop_back();
    CHECK(says(fault({{"odd", m}}), "turned against their neighbours"));
  }
  SUBCASE("warped") {
    Mesh m = cube;
    m.vertices[6].z += 0.0124;
    CHECK(says(fault({{"skew", m}}), "has a face warped by 3.1"));
    CHECK(fault({{"skew", m}}, "snap = 0.005").empty());
  }
  SUBCASE("overlapping") {
    const std::string message = fault({{"low", cube}, {"high", box({0.2, 0, 0.992}, {0.9, 1, 2})}});
    CHECK(says(message, "stone \"high\" (element 1)"));
    CHECK(says(message, "overlaps"));
    CHECK(says(message, "by 0.008 m"));
    CHECK(says(message, "part them where they were drawn"));
  }
  SUBCASE("a small overlap is resolved") {
    const auto c = load(folder.write("a.obj", obj({{"low", cube}, {"high", box({0.2, 0, 0.9994}, {0.9, 1, 2})}})), "", kBase);
    CHECK(model_of(c).assembly.joints.size() == 2);
    CHECK(says(c.stones[0].stones[0].change, "moved by up to 0.3 mm"));
  }
  SUBCASE("touching nothing") { CHECK(says(fault({{"low", cube}, {"high", box({0, 0, 1.01}, {1, 1, 2})}}), "touches nothing")); }
  SUBCASE("no volume") {
    Mesh m = box({0, 0, 0}, {1, 1, 1e-10});
    const auto c = load(folder.write("b.obj", obj({{"leaf", m}, {"cube", cube}})), "", kBase);
    CHECK(c.stones[0].stones.size() == 1);
    CHECK(says(c.stones[0].notes.at(0), "1 flat surface passed over"));
  }
  SUBCASE("a name that stands twice") {
    auto c = voussoir::io::read_case(
                 {"t", kMaterial + kBase + "[[stones]]\nunit = \"m\"\nfile = \"" + folder.write("c.obj", obj({{"a", cube}})) +
                           "\"\n[[stones]]\nunit = \"m\"\nplace = [3, 0, 0]\nfile = \"" + folder.path("c.obj") + "\"\n"})
                 .value;
    voussoir::io::load_stones(c);
    CHECK_THROWS_WITH(model_of(c), doctest::Contains("has the name of another stone or block"));
    c.stones[1].name = "B";
    CHECK(model_of(c).blocks[1].name == "B/a");
  }
  SUBCASE("not a solid at all") {
    Mesh m = cube;
    m.faces.resize(1);
    CHECK(says(fault({{"interface", m}}), "holds no solid"));
  }
}

TEST_CASE("a load acts on a stone, on each stone of a group, on a stone in pieces") {
  const TempFolder folder;
  const Named l = extruded("L", {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.5);
  std::string text = obj({l, {"cube", box({2, 0, 0}, {3, 1, 1})}});
  text.insert(text.find("f "), "g all\n");
  const Model m = model_of(load(folder.write("a.obj", text), "name = \"x\"", kBase));
  using Parts = std::vector<std::vector<std::int32_t>>;
  CHECK(voussoir::cases::parts_named(m, "x/cube") == Parts{{2}});
  CHECK(voussoir::cases::parts_named(m, "x/L") == Parts{{0, 1}});
  CHECK(voussoir::cases::parts_named(m, "x/L/2") == Parts{{1}});
  CHECK(voussoir::cases::parts_named(m, "x/all") == Parts{{0, 1}, {2}});
  CHECK(voussoir::cases::parts_named(m, "all").empty());
  // The force goes through the centroid of the whole L: pieces of 1 x 0.4 and 0.4 x 0.6 m.
  voussoir::cases::Load load;
  load.block = "x/L";
  Vec3 point;
  double parts = 0.0;
  for (const auto& s : voussoir::cases::load_shares(m, load, 0)) parts += s.part, point += s.part * s.point;
  CHECK(parts == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(point.x == doctest::Approx((0.4 * 0.5 + 0.24 * 0.2) / 0.64).epsilon(1e-9));
  CHECK(point.z == doctest::Approx((0.4 * 0.2 + 0.24 * 0.7) / 0.64).epsilon(1e-9));
}

TEST_CASE("stones in a checkpoint come back as they were; what does not fit is not taken") {
  const TempFolder folder;
  const Named l = extruded("L", {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.5);
  const auto c = load(folder.write("a.obj", obj({l, {"cube", box({2, 0, 0}, {3, 1, 1})}})), "", kBase);
  const Model m = model_of(c);
  const auto packed = voussoir::io::packed_stones(m.stones);
  const auto back = voussoir::io::unpacked_stones(packed);
  REQUIRE(back);
  REQUIRE(back->size() == 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto &a = m.stones[0][i], &b = (*back)[0][i];
    CHECK(a.name == b.name);
    CHECK(a.fixed == b.fixed);
    REQUIRE(a.pieces.size() == b.pieces.size());
    for (std::size_t p = 0; p < a.pieces.size(); ++p) {
      CHECK(a.pieces[p].shape.vertices == b.pieces[p].shape.vertices);
      CHECK(a.pieces[p].shape.faces == b.pieces[p].shape.faces);
    }
  }
  for (std::size_t i = 0; i < packed.numbers.size(); ++i) {
    for (const int by : {-1, 1, 1000000}) {
      auto bad = packed;
      bad.numbers[i] += by;
      voussoir::io::unpacked_stones(bad);  // must not crash
    }
  }
  auto shorter = packed;
  shorter.vertices.pop_back();
  CHECK_FALSE(voussoir::io::unpacked_stones(shorter));
}

TEST_CASE("stones: sizes that only a wrong unit makes are told, with file, unit and sizes") {
  const TempFolder folder;
  const std::string in_m = obj({{"a", box({0, 0, 0}, {0.5, 0.3, 0.2})}, {"b", box({0.5, 0, 0}, {1, 0.3, 0.2})}});
  const std::string in_mm = obj({{"a", box({0, 0, 0}, {500, 300, 200})}, {"b", box({500, 0, 0}, {1000, 300, 200})}});
  const auto told = [&](const std::string& text, const std::string& unit) {
    const auto all = voussoir::io::unusual_sizes(load(folder.write("arch.obj", text), "", "", unit));
    return all.empty() ? std::string() : all.front().key() + " " + all.front().what();
  };
  CHECK(told(in_m, "m").empty());
  CHECK(told(in_mm, "mm").empty());
  CHECK(told(in_m, "ft").empty());
  for (const std::string& text : {told(in_mm, "m"), told(in_m, "mm")}) {
    CAPTURE(text);
    CHECK(text.starts_with("stones[0].unit"));
    CHECK(text.find("arch.obj are ") != std::string::npos);
    CHECK(text.find("allowed: m, cm, mm, in, ft") != std::string::npos);
  }
  CHECK(told(in_mm, "m").find("are 500 m to 500 m long, and 1000 m together") != std::string::npos);
}
