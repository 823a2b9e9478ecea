// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/capacity/hanging_walls.h"

#include <doctest/doctest.h>

#include <string>

#include "io/output/measures/capacity/capacity_file.h"
#include "tests/io/output/measures/hut.h"

// Walls that the ground has left: of a hut whose corner or lowest courses sink by hand.
namespace voussoir::io {
namespace {

using namespace test;

std::vector<HangingWall> hanging(Hut& hut) {
  hut.results().finish();
  const Hdf5File run = Hdf5File::open(hut.file());
  const FrameReader frames(run);
  return hanging_walls(run, building_of(run), first_poses(frames), poses_of(frames, frames.frames() - 1));
}

/// The hut on a block below x = 0.6 m and another beside it, without a base.
std::string on_blocks() {
  std::string text = kHut;
  text.replace(text.find("[base]\nz = 0.0\n"), 15, "");
  for (const auto& [name, from, to] : {std::tuple{"moves", "-0.1", "0.6"}, std::tuple{"stays", "0.6", "1.5"}})
    text += std::string("[[block]]\nname = \"") + name + "\"\nmaterial = \"adobe\"\nfixed = true\nbox = [[" + from + ", -0.1, -0.5], [" +
            to + ", 1.3, 0.0]]\n";
  return text;
}

}  // namespace

TEST_CASE("hanging walls: a support that leaves a wall without a brick of it") {
  Hut hut(on_blocks());
  hut.frame(0.0, stays);
  hut.frame(1.0, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "moves" ? x - Vec3{0, 0, 0.03} : x; });
  const std::vector<HangingWall> walls = hanging(hut);
  REQUIRE(walls.size() == 3);
  for (const HangingWall& w : walls) {
    CAPTURE(w.wall);
    CHECK(w.gap == doctest::Approx(0.03).epsilon(1e-4));
    CHECK(w.height == doctest::Approx(0.0));
    const bool front = w.wall == "front wall";
    if (w.wall == "left wall") {
      CHECK(w.length == doctest::Approx(1.2).epsilon(0.01));  // whichever wall the bricks of a corner are counted to
      continue;
    }
    CHECK(w.length == doctest::Approx(0.6).epsilon(0.01));
    CHECK((front ? w.from : 1.4 - w.to) == doctest::Approx(0.0).epsilon(0.01));  // the left end is seen from outside
  }
}

TEST_CASE("hanging walls: nothing where all sinks, where the gap is narrower than 1 mm, or where the wall has risen") {
  for (const Vec3 support : {Vec3{0, 0, -0.03}, Vec3{0, 0, -0.9e-3}, Vec3{}}) {
    Hut hut(on_blocks());
    hut.frame(0.0, stays);
    hut.frame(1.0, [&](std::size_t e, Vec3 x) {
      const bool ground = hut.tag(e) == "moves";
      if (norm(support) > 0.01) return ground || hut.tag(e) != "stays" ? x + support : x;  // all but one block, and the wall upon it
      return norm(support) == 0.0 ? (hut.tag(e) == "stays" || ground ? x : x + Vec3{0, 0, 0.02}) : ground ? x + support : x;
    });
    CHECK(hanging(hut).empty());
  }
}

TEST_CASE("hanging walls: a gap above a course that has gone down with the ground, and what summary says of it") {
  Hut hut(on_blocks());
  const auto sinks = [&](std::size_t e, Vec3 x) {
    return hut.tag(e) == "moves" || (hut.tag(e) == "front wall" && x.z < 0.1 && x.x < 0.5) ? x - Vec3{0, 0, 0.03} : x;
  };
  hut.frame(0.0, stays);
  hut.frame(1.0, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "front wall" || hut.tag(e) == "moves" ? sinks(e, x) : x; });
  const std::vector<HangingWall> walls = hanging(hut);
  const auto front = std::ranges::find(walls, "front wall", &HangingWall::wall);
  REQUIRE(front != walls.end());
  CHECK(front->height > 0.05);
  CHECK(front->gap == doctest::Approx(0.03).epsilon(1e-4));
  Capacity c;
  c.kind = cases::AnalysisKind::settlement, c.ended = "history", c.curve.support_moved = {0.03};
  c.hanging = {{"front wall", 0.9, 0.0, 0.9, 0.0297, 0.4}};
  CHECK(capacity_text(c).find("the ground has left the front wall over 0.90 m (0.00 to 0.90 m from its left end): a gap of up to 29.7 mm, "
                              "at 0.40 m; what is above hangs by the bond of its mortar") != std::string::npos);
  CHECK(capacity_json(c, false).find("\"hanging_length\":0.9") != std::string::npos);
  CHECK(capacity_json(c, false).find("\"hanging\":[{\"wall\":\"front wall\"") != std::string::npos);
  c.hanging.clear();
  CHECK(capacity_text(c).find("hangs") == std::string::npos);
}

}  // namespace voussoir::io
