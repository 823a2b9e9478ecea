// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <chrono>
#include <map>

#include "tests/io/input/stones/random_hulls.h"
#include "tests/io/input/stones/stones_fixture.h"

namespace {

using namespace hulls;

stones::Named named(const std::string& name, const Hull& h) {
  stones::Named n{name, {h.vertices, {}}};
  for (const auto& face : h.faces) n.mesh.faces.emplace_back(face.begin(), face.end());
  return n;
}

void check_same(const voussoir::geometry::MassProperties& m, const Integrals& r) {
  const double scale = r.inertia[0] + r.inertia[1] + r.inertia[2];
  const std::array<double, 6> inertia{m.inertia.r0.x, m.inertia.r1.y, m.inertia.r2.z, m.inertia.r0.y, m.inertia.r0.z, m.inertia.r1.z};
  double worst = std::max(std::abs(m.volume / r.volume - 1.0), norm(m.centroid - r.centroid));
  for (std::size_t i = 0; i < 6; ++i) worst = std::max(worst, std::abs(inertia[i] - r.inertia[i]) / scale);
  CHECK(worst < 1e-11);
}

std::vector<double> sorted_areas(const Hull& h) {
  std::vector<double> areas;
  for (const auto& face : h.faces) areas.push_back(area_of(h, face));
  std::sort(areas.begin(), areas.end());
  return areas;
}

}  // namespace

TEST_CASE("5,000 random convex stones: volume, inertia, areas and joints as brute force has them, in under 5 s") {
  std::mt19937 random(40);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<stones::Named> all;
  std::vector<Hull> hull;
  std::map<std::pair<std::size_t, std::size_t>, double> joints;  // area of the section
  for (int i = 0; all.size() < 5000; ++i) {
    const Hull whole = hull_of(random_points(random, {}, 5 + i % 8));
    if (shortest_edge(whole) < 1e-3) continue;
    const Vec3 place{2.0 * (i % 60), 2.0 * (i / 60), 0.0};
    if (i % 4 == 0) {
      hull.push_back(moved(whole, place));
      all.push_back(named("whole " + std::to_string(i), hull.back()));
      continue;
    }
    const Vec3 n = normalised({unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5});
    const Halves halves = halves_of(whole, n, dot(n, integrals_of(whole).centroid));
    // A cut within a millimetre of a corner makes faces that brute force cannot tell from a point.
    if (std::min(shortest_edge(halves.below), shortest_edge(halves.above)) < 1e-3) continue;
    joints[{all.size(), all.size() + 1}] = halves.section;
    hull.push_back(moved(halves.below, place));
    all.push_back(named("below " + std::to_string(i), hull.back()));
    hull.push_back(moved(halves.above, place));
    all.push_back(named("above " + std::to_string(i), hull.back()));
  }
  const TempFolder folder;
  const std::string file = folder.write("many.obj", stones::obj(all));
  const auto start = std::chrono::steady_clock::now();
  const auto c = stones::load(file, "supports = 1e6", "[segments]\nsize = 0.2\n");
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  MESSAGE("import of " << all.size() << " stones: " << taken << " s");
  const auto model = stones::model_of(c);
  REQUIRE(model.blocks.size() == all.size());
  for (std::size_t e = 0; e < all.size(); ++e) {
    check_same(model.assembly.elements[e].mass, integrals_of(hull[e]));
    const auto& element = model.assembly.elements[e];
    std::vector<double> areas;
    for (int f = 0; f < element.face_count; ++f)
      areas.push_back(model.assembly.faces[static_cast<std::size_t>(element.first_face + f)].area);
    std::sort(areas.begin(), areas.end());
    const std::vector<double> expected = sorted_areas(hull[e]);
    REQUIRE(areas.size() == expected.size());
    for (std::size_t f = 0; f < areas.size(); ++f) CHECK(std::abs(areas[f] - expected[f]) < 1e-11);
  }
  REQUIRE(model.assembly.joints.size() == joints.size());
  for (const auto& joint : model.assembly.joints) {
    const auto found = joints.find({static_cast<std::size_t>(joint.element_a), static_cast<std::size_t>(joint.element_b)});
    REQUIRE(found != joints.end());
    CHECK(joint.area == doctest::Approx(found->second).epsilon(1e-9));
  }
  CHECK(taken < 5.0);
}
