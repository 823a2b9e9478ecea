// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/output/measures/debris/bodies.h"
#include "io/output/measures/members/member_words.h"
#include "tests/io/output/measures/hut.h"

// A gable is a part of its own: its drift, its name in a mechanism.
namespace voussoir::io {
namespace {

using namespace test;

/// The hut under a pitched roof.
std::string pitched() {
  std::string text = kHut;
  const std::string flat = "roof = { kind = \"flat\" }";
  text.replace(text.find(flat), flat.size(), "roof = { kind = \"pitched\", pitch = 45.0 }");
  return text;
}

}  // namespace

TEST_CASE("a gable has a drift of its own, which no drift of its wall hides") {
  Hut hut(pitched());
  double top = 0.0, foot = 10.0;
  for (std::size_t e = 0; e < hut.model().blocks.size(); ++e) {
    if (hut.tag(e) == "left gable") top = std::max(top, hut.centroid(e).z), foot = std::min(foot, hut.centroid(e).z);
  }
  REQUIRE(top > foot + 0.2);
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "left gable" && x.z > foot + 0.05 ? x - Vec3{0.02, 0, 0} : x; });
  hut.frame(0.2, stays);
  const Measures m = hut.measures();
  const Building b = building_of(Hdf5File::open(hut.file()));
  REQUIRE(b.gables.size() == 2);
  const auto left = std::ranges::find_if(b.gables, [](const Gable& g) { return g.part.name == "left gable"; });
  REQUIRE(left != b.gables.end());
  const WallMeasures& of = wall(m, "left wall");
  CHECK(of.peak_gable_drift == doctest::Approx(0.02 / left->part.height()).epsilon(1e-3));
  CHECK(of.peak_gable_drift_time == 0.1);
  CHECK(of.peak_drift == doctest::Approx(0.0));
  CHECK(wall(m, "right wall").peak_gable_drift == doctest::Approx(0.0));
  CHECK(std::isnan(wall(m, "front wall").peak_gable_drift));
  CHECK(m.peak_gable == "left gable");
  CHECK(m.peak_gable_drift == doctest::Approx(std::abs(of.peak_gable_drift)));
  const std::string words = storeys_text(m);
  const std::size_t at = words.find("its gable");
  REQUIRE(at != std::string::npos);
  CHECK(words.find("its gable", words.find("its gable", at + 1) + 1) == std::string::npos);  // two gables, not four
}

TEST_CASE("a house without gables has no drift of them") {
  Hut hut;
  hut.frame(0.0, stays);
  const Measures m = hut.measures();
  CHECK(std::isnan(m.peak_gable_drift));
  CHECK(m.peak_gable.empty());
}

TEST_CASE("a body that is a gable is named as gable, with its place in it") {
  Hut hut(pitched());
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "left gable" ? x - Vec3{0.05, 0, 0} : x; });
  hut.results().finish();
  const Hdf5File run = Hdf5File::open(hut.file());
  const Building b = building_of(run);
  const FrameReader frames(run);
  std::vector<std::int32_t> part;
  for (std::size_t e = 0; e < hut.model().blocks.size(); ++e) part.push_back(hut.tag(e) == "left gable" ? 1 : 0);
  BodyFinder finder(run, b, first_poses(frames));
  finder.take(part, 0.0);
  const BodiesInFrame found = finder.find(0.1, poses_of(frames, 1));
  const auto gable = std::ranges::find_if(found.bodies, [](const Body& body) { return body.gable; });
  REQUIRE(gable != found.bodies.end());
  CHECK(body_name(*gable, b) == "left gable, moves out");
}

}  // namespace voussoir::io
