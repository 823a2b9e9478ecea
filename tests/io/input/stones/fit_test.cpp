// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "geometry/solids/fit/half_spaces.h"
#include "tests/geometry/random_masonry.h"
#include "tests/io/input/stones/written_files.h"

// Stones of files with fit = "planes". What the planes are: tests/geometry/fit_planes_test.cpp.
using namespace stones;
using namespace voussoir;

namespace {

std::vector<Named> named(const std::vector<Mesh>& meshes) {
  std::vector<Named> out;
  for (std::size_t i = 0; i < meshes.size(); ++i) out.push_back({"s" + std::to_string(i), meshes[i]});
  return out;
}

const std::string kPlanes = "fit = \"planes\"\n";

/// Boxes along an arc of a circle: their ends are in each other inside and gape outside.
std::vector<Named> curved_wall(int count, double radius, double length) {
  std::vector<Named> all;
  for (int course = 0; course < 2; ++course) {
    for (int k = 0; k < count; ++k) {
      Mesh m = box({radius - 0.15, -0.5 * length, 0.2 * course}, {radius + 0.15, 0.5 * length, 0.2 * (course + 1)});
      m.vertices = geometry::rotated({m.vertices, {}}, {0, 0, 1}, (k + 0.5 * course) * length / radius, {}).vertices;
      all.push_back({"c" + std::to_string(course) + "_" + std::to_string(k), m});
    }
  }
  return all;
}

std::size_t joints_between(const cases::Model& model) {
  std::size_t n = 0;
  for (const auto& j : model.assembly.joints) n += j.element_b >= 0 ? 1 : 0;
  return n;
}

}  // namespace

TEST_CASE("fit: exact stones have the same bits as without it") {
  const TempFolder folder;
  masonry::Numbers any(72);
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    const std::string file = folder.write("exact.obj", obj(named(k % 2 == 0 ? masonry::arch(any) : masonry::wall(any))));
    const auto without = load(file), with = load(file, kPlanes);
    REQUIRE(with.stones[0].stones.size() == without.stones[0].stones.size());
    for (std::size_t i = 0; i < with.stones[0].stones.size(); ++i) {
      const auto &a = with.stones[0].stones[i].pieces, &b = without.stones[0].stones[i].pieces;
      REQUIRE(a.size() == b.size());
      for (std::size_t p = 0; p < a.size(); ++p) {
        CHECK(a[p].shape.vertices == b[p].shape.vertices);
        CHECK(a[p].shape.faces == b[p].shape.faces);
      }
      CHECK(with.stones[0].stones[i].change == without.stones[0].stones[i].change);
    }
    CHECK(with.stones[0].notes.front().starts_with("fit to planes: 0 of "));
  }
}

TEST_CASE("fit: stones that are not convex are cut along their folds, and keep their bits where they fit") {
  const TempFolder folder;
  Mesh angle;
  for (const double y : {0.0, 0.3}) {
    for (const auto& [x, z] : {std::pair(0.0, 0.2), {1.0, 0.2}, {1.0, 0.4}, {0.3, 0.4}, {0.3, 0.7}, {0.0, 0.7}})
      angle.vertices.push_back({x, y, z});
  }
  angle.faces = {{0, 1, 2, 3, 4, 5}, {11, 10, 9, 8, 7, 6}};
  for (int i = 0; i < 6; ++i) angle.faces.push_back({i, 6 + i, 6 + (i + 1) % 6, (i + 1) % 6});
  std::vector<Named> all{{"sill", box({0, 0, 0}, {1, 0.3, 0.2})}, {"angle", angle}, {"on", box({0.3, 0, 0.4}, {1, 0.3, 0.7})}};
  const auto exact = load(folder.write("angle.obj", obj(all)), kPlanes);
  CHECK(exact.stones[0].stones[1].pieces.size() == 2);
  CHECK(joints_between(model_of(exact)) == 5);
  // The third stone stands off from both sides of the fold by some millimetres.
  for (Vec3& v : all[2].mesh.vertices) v += Vec3{0.004, 0, 0.005};
  const auto fitted = load(folder.write("angle.obj", obj(all)), kPlanes);
  CHECK(joints_between(model_of(fitted)) >= 5);
  CHECK(fitted.stones[0].stones[2].change.find("moved by up to 2.5 mm") != std::string::npos);
}

TEST_CASE("fit: a curved wall of straight boxes is a ring of wedges; without the fit it is refused") {
  const TempFolder folder;
  const std::string file = folder.write("curved.obj", obj(curved_wall(9, 3.0, 0.5)));
  CHECK(refusal(file).find("overlaps") != std::string::npos);
  const auto c = load(file, kPlanes);
  CHECK(joints_between(model_of(c)) == 8 + 8 + 17);
  const std::string& note = c.stones[0].notes.front();
  CAPTURE(note);
  CHECK(note.starts_with("fit to planes: 18 of 18 stones changed; volume "));
  CHECK(note.find("largest movement 13.1 mm") != std::string::npos);
}

TEST_CASE("fit: warped faces become plane") {
  const TempFolder folder;
  std::vector<Named> all{{"below", box({0, 0, 0}, {0.5, 0.5, 0.3})}, {"above", box({0, 0, 0.3}, {0.5, 0.5, 0.6})}};
  for (Named& n : all) {
    for (Vec3& v : n.mesh.vertices)
      if (v.z == 0.3) v.z += v.x == v.y ? 0.01 : -0.01;
  }
  const std::string file = folder.write("warped.obj", obj(all));
  CHECK(refusal(file).find("warped") != std::string::npos);
  const auto c = load(file, kPlanes);
  CHECK(joints_between(model_of(c)) == 1);
  for (const auto& s : c.stones[0].stones) {
    CHECK(s.pieces[0].shape.faces.size() == 6);
    CHECK(s.change.starts_with("fitted: volume "));
  }
}

TEST_CASE("fit: what would move beyond its limit is refused, all of it") {
  const TempFolder folder;
  const std::string file =
      folder.write("deep.obj", obj({{"a", box({0, 0, 0}, {0.5, 0.3, 0.2})}, {"b", box({0.35, 0, 0}, {0.9, 0.3, 0.2})}}));
  const std::string words = refusal(file, kPlanes);
  CHECK(words.find("stone \"a\" of \"deep.obj\" would have to move by 75 mm at (0.5, ") != std::string::npos);
  CHECK(words.find("(allowed 50 mm); set stones.fit_limit if so much is right") != std::string::npos);
  CHECK(words.find("1 more stone is at fault: \"b\"") != std::string::npos);
  CHECK(refusal(file, kPlanes + "fit_limit = 0.08\n").empty());
  CHECK(refusal(file, kPlanes + "fit_limit = 0.07\n").find("(allowed 70 mm)") != std::string::npos);
}

TEST_CASE("fit: keys that do not go together are refused") {
  const TempFolder folder;
  const std::string file = folder.write("a.obj", obj({{"a", box({0, 0, 0}, {0.5, 0.3, 0.2})}}));
  CHECK(refusal(file, kPlanes + "gap = 0.01\n").find("gap") != std::string::npos);
  CHECK(refusal(file, kPlanes + "warped = \"triangles\"\n").find("warped") != std::string::npos);
  CHECK(refusal(file, "fit_limit = 0.01\n").find("is used with fit = \"planes\" alone") != std::string::npos);
  CHECK(refusal(file, "fit = \"plane\"\n").find("planes") != std::string::npos);
  const std::string second = "\n[[stones]]\nfile = \"" + file + "\"\nunit = \"m\"\nname = \"b\"\nplace = [1.0, 0.0, 0.0]\n";
  CHECK(refusal(file, kPlanes + second).find("the same in all tables") != std::string::npos);
  CHECK(refusal(file, kPlanes + second + kPlanes).empty());
}
