// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/stones/stones.h"

#include <algorithm>
#include <string>
#include <vector>

#include "solver/limit/limit.h"
#include "solver/limit/programme/linear_programme.h"
#include "tests/io/input/stones/stones_fixture.h"
#include "tests/verification/collapse.h"

// V17: an arch and a dome out of files of meshes, which go the whole way that a user's own stones go.
namespace voussoir::testing {
namespace {

using stones::Mesh;
using stones::Named;

constexpr double kMeanRadius = 1.5;  // m

/// A stone between two angles (or a patch of a sphere) by its corners: the inner four, then the outer four over them.
Named stone_of(const std::string& name, const std::vector<Vec3>& inner, const std::vector<Vec3>& outer) {
  Named n{name, {inner, {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}};
  n.mesh.vertices.insert(n.mesh.vertices.end(), outer.begin(), outer.end());
  if (geometry::volume(n.mesh) < 0.0) {
    for (auto& loop : n.mesh.faces) std::reverse(loop.begin(), loop.end());
  }
  return n;
}

std::vector<Named> mesh_arch(double thickness, int count) {
  std::vector<Named> all;
  const auto at = [&](double r, int k, double y) {
    const double a = kPi * k / count;
    return Vec3{r * std::cos(a), y, k == 0 || k == count ? 0.0 : r * std::sin(a)};
  };
  const auto ring = [&](double r, int k) { return std::vector{at(r, k, 0.0), at(r, k + 1, 0.0), at(r, k + 1, 0.2), at(r, k, 0.2)}; };
  for (int k = 0; k < count; ++k)
    all.push_back(stone_of("v" + std::to_string(k), ring(kMeanRadius - 0.5 * thickness, k), ring(kMeanRadius + 0.5 * thickness, k)));
  return all;
}

/// A hemisphere of rings of stones between meridians, with a small eye.
std::vector<Named> mesh_dome(double thickness, int rings, int meridians) {
  std::vector<Named> all;
  constexpr double kEye = 6.0;  // degrees from the top
  const auto at = [&](double r, int ring, int meridian) {
    const double up = radians((90.0 - kEye) * ring / rings), round = 2.0 * kPi * (meridian % meridians) / meridians;
    return Vec3{r * std::cos(up) * std::cos(round), r * std::cos(up) * std::sin(round), r * std::sin(up)};
  };
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < meridians; ++k) {
      const auto patch = [&](double r) { return std::vector{at(r, i, k), at(r, i, k + 1), at(r, i + 1, k + 1), at(r, i + 1, k)}; };
      all.push_back(stone_of("r" + std::to_string(i) + "m" + std::to_string(k), patch(kMeanRadius - 0.5 * thickness),
                             patch(kMeanRadius + 0.5 * thickness)));
    }
  }
  return all;
}

struct Shell {
  bool dome = false, rim = true;
  int rings = 10, meridians = 12, voussoirs = 25, points = 4;

  [[nodiscard]] cases::Case shaped(double ratio) const {
    const double thickness = ratio * kMeanRadius;
    const TempFolder folder;
    const std::string file =
        folder.write("shell.obj", stones::obj(dome ? mesh_dome(thickness, rings, meridians) : mesh_arch(thickness, voussoirs)));
    cases::Case c = load("arch_stands").value;
    c.blocks.clear();
    c.output.history.clear();
    cases::StonesSpec spec;
    spec.file = file, spec.unit = "m";
    c.stones.push_back(spec);
    io::load_stones(c);
    c.contact.friction = 75.0;  // nothing slides
    c.segment_size = thickness / points;
    c.segment_rule = rim ? geometry::SegmentRule::rim : geometry::SegmentRule::centres;
    return c;
  }
  /// Whether forces that keep every stone in balance exist.
  [[nodiscard]] bool stands_by_limit_analysis(double ratio) const {
    const cases::Case c = shaped(ratio);
    try {
      solver::LimitOptions options;
      options.coulomb = false;  // whether it stands at all is asked before any multiplier
      return solver::limit_analysis(c, cases::build_model(c), options).associated.multiplier > 0.0;
    } catch (const cases::InputError&) {
      return false;
    }
  }
  [[nodiscard]] bool stands(double ratio) const { return movement(shaped(ratio)) < kFalls; }
};

}  // namespace

TEST_CASE("V17: an arch out of a mesh stands and falls where it should") {
  const Shell arch;
  CHECK(arch.stands(1.04 * 0.107));
  CHECK_FALSE(arch.stands(0.96 * 0.107));
}

TEST_CASE("V17: least thickness of an arch out of a mesh" * doctest::skip()) {
  for (const bool rim : {true, false}) {
    const Shell arch{.rim = rim};
    const double known = rim ? 0.107 : 0.107 / (1.0 - 1.0 / arch.points);
    const double found = bisect(0.95 * known, 1.05 * known, 0.005 * known, [&](double ratio) { return arch.stands(ratio); });
    expect_near(std::string("V17 mesh arch: least t/R") + (rim ? ", points to the rim" : ", n = 4"), found, known, 3e-2);
  }
}

TEST_CASE("V17: least thickness of a hemispherical dome out of a mesh, aligned meridians" * doctest::skip()) {
  REQUIRE_MESSAGE(solver::has_linear_programmes(), "this build has no Clp (Debian: coinor-libclp-dev)");
  const Shell dome{.dome = true};
  const double limit = bisect(0.030, 0.055, 0.0005, [&](double ratio) { return dome.stands_by_limit_analysis(ratio); });
  expect_near("V17 mesh dome: least t/R by limit analysis of the mesh", limit, 0.042, 6e-2);
  CHECK(dome.stands(1.05 * limit));
  CHECK_FALSE(dome.stands(0.95 * limit));
}

}  // namespace voussoir::testing
