// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/output/measures/building/wall_drift.h"

#include <cmath>

#include "tests/io/output/measures/hut.h"

// Which elements are part of a wall still, and damage from settling and from shaking apart.

namespace voussoir::io {
namespace {

using namespace test;

/// Joints between the lowest course of a wall and the next.
std::vector<std::size_t> first_bed(const Hut& hut, const std::string& tag) {
  std::vector<std::size_t> found;
  const cases::Model& m = hut.model();
  for (std::size_t j = 0; j < m.assembly.joints.size(); ++j) {
    const geometry::Joint& joint = m.assembly.joints[j];
    const bool level = std::abs(joint.frame().normal.z) > 0.9 && std::abs(joint.centre.z - 0.1) < 1e-6;
    if (level && hut.tag(static_cast<std::size_t>(joint.element_a)) == tag && hut.tag(static_cast<std::size_t>(joint.element_b)) == tag)
      found.push_back(j);
  }
  REQUIRE(found.size() > 3);
  return found;
}

/// In-plane drift of a front wall whose top is moved: its left half by 10 mm, the brick in its middle, if there is one, by 50 mm.
double drift_of_moved_top(const std::string& inner_length, const std::string& origin) {
  std::string text = kHut;
  const std::string size = "inner_size = [1.0, 0.8]";
  text.replace(text.find(size), size.size(),
               "inner_size = [" + inner_length + ", 0.8]\nbond = \"running\"\norigin = [" + origin + ", 0.0]");
  Hut hut(text);
  const double middle = std::stod(origin) + 0.5 * std::stod(inner_length) + 0.2;
  hut.frame(0.0, stays);
  hut.frame(0.1, [&](std::size_t e, Vec3 x) {
    if (hut.tag(e) == "front wall" && x.z > 0.3) x.x += std::abs(x.x - middle) < 0.01 ? 0.05 : x.x < middle ? 0.01 : 0.0;
    return x;
  });
  return wall(hut.measures(), "front wall").peak_in_plane_drift;
}

}  // namespace

TEST_CASE("a brick that flies off leaves its wall, whether it sinks or rises") {
  Hut hut;
  const auto thrown = [&hut](double by) {
    return [&hut, by, first = true](std::size_t e, Vec3 x) mutable {
      if (hut.tag(e) != "front wall" || x.z < 0.3 || !first) return x;
      first = false;  // one of the uppermost course
      return x + Vec3{0.0, -by, 0.5};
    };
  };
  hut.frame(0.0, stays);
  hut.frame(0.1, thrown(0.3));  // no farther than the wall is high, and no more than 1 m from its neighbours: still counted
  hut.frame(0.2, thrown(10.7));
  hut.frame(0.3, [&](std::size_t e, Vec3 x) { return hut.tag(e) == "front wall" && x.z > 0.3 ? x + Vec3{0, -5.0, 0.1} : x; });
  hut.frame(0.4, [&](std::size_t e, Vec3 x) {  // a brick of the lowest course, which cannot sink, is kicked away
    return hut.tag(e) == "front wall" && x.z < 0.1 && x.x < 0.2 ? x + Vec3{0, -5.0, 0.0} : x;
  });
  const Measures m = hut.measures();
  const std::size_t front = static_cast<std::size_t>(&wall(m, "front wall") - m.walls.data()), n = m.walls.size();
  CHECK(m.series.drift[1 * n + front] > 0.0);
  CHECK(m.series.drift[2 * n + front] == doctest::Approx(0.0));
  CHECK(std::isnan(m.series.drift[3 * n + front]));
  CHECK(m.series.drift[4 * n + front] == doctest::Approx(0.0));
  CHECK(wall(m, "front wall").peak_drift < 0.3 / 0.4);
}

TEST_CASE("a brick 1.2 m from where its neighbours are is no part of a wall, though the wall is higher than that") {
  Wall wall;
  wall.box.low = {0.0, 0.0, 0.0}, wall.box.high = {2.0, 0.2, 2.4};
  wall.across = 1, wall.outward = -1.0;
  wall.foot = {0}, wall.top = {{1, 2, 3}};
  const std::vector<Pose> start(4);
  std::vector<Pose> poses(4);
  const std::vector<std::uint8_t> fallen(4, 0);
  poses[3].centre.y = -1.2;
  CHECK(*wall_drift(wall, start, poses, fallen) == doctest::Approx(0.0));
  poses[3].centre.y = -0.6;  // leans out with them
  CHECK(*wall_drift(wall, start, poses, fallen) == doctest::Approx(0.2 / 2.4));
  poses[1].centre.y = poses[2].centre.y = poses[3].centre.y = -1.2;  // all do
  CHECK(*wall_drift(wall, start, poses, fallen) == doctest::Approx(0.5));
}

TEST_CASE("a brick in the middle between two pieces of a top counts in both, wherever the house stands") {
  for (const char* inner_length : {"1.6", "1.8"}) {  // the middle is between two bricks of the top, or in one
    const double drift = drift_of_moved_top(inner_length, "0.0");
    for (const char* origin : {"0.1", "0.258", "0.7", "1.37", "-0.911", "12.757", "60.304", "7.13"}) {
      CHECK(drift_of_moved_top(inner_length, origin) == doctest::Approx(drift).epsilon(1e-3));
    }
  }
}

TEST_CASE("damage from settling and from shaking are told apart") {
  Hut hut;
  const std::vector<std::size_t> early = first_bed(hut, "front wall"), late = first_bed(hut, "rear wall");
  for (const std::size_t joint : early) hut.crack_whole_joint(-0.4, joint);
  // From its second course on the front wall stands 2 mm off when the shaking begins, the rear wall later.
  const auto lifted = [&hut](bool rear) {
    return [&hut, rear](std::size_t e, Vec3 x) {
      const bool moves = hut.tag(e) == "front wall" || (rear && hut.tag(e) == "rear wall");
      return moves && x.z > 0.1 ? x + Vec3{0, 0, 2e-3} : x;
    };
  };
  hut.frame(0.0, lifted(false));
  for (const std::size_t joint : late) hut.crack_whole_joint(0.05, joint);
  hut.frame(0.1, lifted(true));
  const Measures m = hut.measures();
  CHECK(m.settling_cracks == static_cast<std::int64_t>(early.size()));
  CHECK(m.shaking_cracks == static_cast<std::int64_t>(late.size()));
  CHECK(m.settling_first_crack_time == -0.4);
  CHECK(m.first_crack_time == 0.05);
  CHECK(m.settling_damage_grade == 2);  // one wall of four has a crack of 1 mm along it
  CHECK(m.damage_grade == 2);
  CHECK(wall(m, "front wall").settling_crack_extent > 0.5);
  CHECK(wall(m, "front wall").settling_crack_extent == doctest::Approx(wall(m, "front wall").crack_extent));
  CHECK(wall(m, "front wall").first_open_joint_time == kNeverReached);
  CHECK(wall(m, "front wall").opened_extent == 0.0);
  CHECK(wall(m, "rear wall").first_open_joint_time == 0.05);
  CHECK(wall(m, "rear wall").settling_crack_extent == 0.0);
  CHECK(wall(m, "rear wall").crack_extent > 0.5);
}

TEST_CASE("a run that nothing broke has neither, and no grade of settling") {
  Hut hut;
  hut.frame(0.0, stays);
  hut.frame(0.1, stays);
  const Measures m = hut.measures();
  CHECK(m.settling_cracks == 0);
  CHECK(m.shaking_cracks == 0);
  CHECK(std::isnan(m.settling_first_crack_time));
  CHECK(m.settling_damage_grade == 0);
}

}  // namespace voussoir::io
