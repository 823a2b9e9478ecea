// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include "cases/census.h"
#include "tests/cases/paper_house.h"
#include "tests/cases/refused.h"

using namespace voussoir;
using namespace voussoir::cases;
using voussoir::testing::opening;

namespace {

struct Sort {
  double area = 0.0;  // m2
  std::set<std::string> laws;
};

/// Joints with timber of the reinforcement, by what they join: "brick - column", "same column".
std::map<std::string, Sort> sorts(const Model& m) {
  std::map<std::string, Sort> all;
  for (std::size_t i = 0; i < m.joint_law.size(); ++i) {
    const geometry::Joint& j = m.assembly.joints[i];
    const Block& a = m.blocks[static_cast<std::size_t>(j.element_a)];
    const Block* b = j.element_b == geometry::kBase ? nullptr : &m.blocks[static_cast<std::size_t>(j.element_b)];
    std::array<std::string, 2> names{name(a.kind), b == nullptr ? "base" : name(b->kind)};
    std::sort(names.begin(), names.end());
    const bool same = b != nullptr && a.member >= 0 && a.member == b->member;
    Sort& sort = all[same ? "same " + names[0] : names[0] + " - " + names[1]];
    sort.area += j.area;
    sort.laws.insert(m.laws[static_cast<std::size_t>(m.joint_law[i])].name);
  }
  return all;
}

void check_refused(const std::function<void(House&)>& change, const std::string& key, const std::string& says) {
  testing::check_refused(testing::reinforced(testing::paper_flat20()), change, key, says);
}

}  // namespace

TEST_CASE("columns and ring beams of the paper's reinforced house") {
  const Model model = build_model(testing::reinforced(testing::paper_flat20()));
  std::map<std::string, int> elements;
  double timber = 0.0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    if (b.kind != PartKind::column && b.kind != PartKind::ring_beam) continue;
    ++elements[b.tag];
    timber += model.assembly.elements[i].mass.volume;
    CHECK(b.segment_size == doctest::Approx(0.025));
  }
  CHECK(elements.size() == 2 * 6 + 2 * 2 + 4);
  CHECK(elements["column 0"] == 11 + 1);  // 2.3 m: eleven of 0.2 m and one of 0.1 m
  CHECK(elements["front ring beam"] == 25);
  CHECK(elements["left ring beam"] == 14);
  CHECK(timber == doctest::Approx(16 * 0.01 * 2.3 + 0.01 * (2 * 5.0 + 2 * 2.8)).epsilon(1e-9));
  CHECK(census(model).step_bound == doctest::Approx(5.03e-5).epsilon(0.001).scale(0.0));
}

TEST_CASE("timber is fixed to the ground, mortared to all else, and touches what it leans on") {
  Case c = testing::reinforced(testing::paper_flat20());
  c.joint_laws["members"] = c.joint_laws["normal"];
  c.house->wood.between_members = "members";
  const std::map<std::string, Sort> found = sorts(build_model(c));
  const auto check = [&](const std::string& sort, double area, const std::string& law) {
    CAPTURE(sort);
    REQUIRE(found.count(sort) == 1);
    CHECK(found.at(sort).area == doctest::Approx(area).epsilon(1e-9));
    CHECK(found.at(sort).laws == std::set<std::string>{law});
  };
  check("base - column", 16 * 0.01, "wood");
  check("same column", 16 * 11 * 0.01, "wood");
  check("same ring beam", (2 * 24 + 2 * 13) * 0.01, "wood");
  check("column - ring beam", 16 * 0.01, "members");
  check("column - lintel", 4 * 0.1 * 0.1, "members");                        // those beside door and window
  check("brick - column", (16 + 4) * 2.3 * 0.1 - 4 * 0.1 * 0.1, "members");  // those in the corners lean on two walls
  check("brick - ring beam", (2 * 5.0 + 4 * 0.1 + 2 * 2.8) * 0.1, "members");
  check("ring beam - ring beam", 4 * 0.01, "members");
  check("ring beam - roof beam", 0.1 * (2 * 5.0 + 2 * 2.8), "members");
}

TEST_CASE("columns that cannot stand are refused") {
  check_refused([](House& h) { h.reinforcement->bearing[1] = 1.2; }, "house.reinforcement.bearing[1]",
                "1.2 m puts a column in front of house.opening[0] (from 1 to 2.2 m) in the front wall; nearest that fits: 0.95 m");
  check_refused([](House& h) { h.openings.push_back(opening("rear", 2.0, 1.0, 1.0, 1.0)); }, "house.reinforcement.bearing[2]",
                "in front of house.opening[2] (from 2 to 3 m) in the rear wall; nearest that fits: 1.95 m");
  check_refused([](House& h) { h.openings.push_back(opening("right", 1.0, 0.5, 1.0, 1.0)); }, "house.reinforcement.nonbearing[0]",
                "in front of house.opening[2]");
  check_refused([](House& h) { h.reinforcement->bearing[0] = 0.22; }, "house.reinforcement.bearing[0]",
                "outside the room; allowed: 0.25 to 5.15 m");
  check_refused([](House& h) { h.reinforcement->bearing[1] = 0.3; }, "house.reinforcement.bearing[1]", "where that of");
  check_refused([](House& h) { h.reinforcement->nonbearing[0] = 0.3; }, "house.reinforcement.nonbearing[0]",
                "where that of house.reinforcement.bearing[");
  check_refused([](House& h) { h.reinforcement->ring_beam = {0.1, 2.4}; }, "house.reinforcement.ring_beam", "not below the height");
  check_refused([](House& h) { h.reinforcement->ring_beam = {1.5, 0.1}; }, "house.reinforcement.ring_beam", "at most 1.45 m");
  check_refused(
      [](House& h) {
        h.openings.clear(), h.inner_size[0] = 2.6, h.reinforcement->ring_beam = {1.3, 0.1};
      },
      "house.reinforcement.ring_beam", "at most 1.2");
  check_refused([](House& h) { h.reinforcement->column = {0.1, 3.5}; }, "house.reinforcement.column", "does not fit between the walls");
  check_refused([](House& h) { h.reinforcement->element = 0.001; }, "house.reinforcement.element", "more than 1000 parts");
  check_refused([](House& h) { h.walls = {"front", "rear"}; }, "house.reinforcement", "four walls");
}

TEST_CASE("timber on timber: mortar as the paper has it, or a law of its own, between members but not with bricks nor between roof beams") {
  Case c = testing::reinforced(testing::paper_flat20());
  const std::vector<std::int32_t> before = build_model(c).joint_law;
  c.house->wood.timber_on_timber = c.house->wood.between_members;
  CHECK(build_model(c).joint_law == before);
  c.joint_laws["carpenter"] = c.joint_laws["wood"];
  c.house->wood.timber_on_timber = "carpenter";
  const std::map<std::string, Sort> found = sorts(build_model(c));
  using Laws = std::set<std::string>;
  CHECK(found.at("column - ring beam").laws == Laws{"carpenter"});
  CHECK(found.at("ring beam - ring beam").laws == Laws{"carpenter"});
  CHECK(found.at("ring beam - roof beam").laws == Laws{"carpenter"});
  CHECK(found.at("brick - ring beam").laws == Laws{"normal"});
  CHECK(found.at("brick - column").laws == Laws{"normal"});
  CHECK(found.at("roof beam - roof beam").laws == Laws{"normal"});
  CHECK(found.at("same ring beam").laws == Laws{"wood"});
  c.house->wood.timber_on_timber = "glue";
  CHECK_THROWS_WITH_AS(build_model(c), doctest::Contains("house.wood.timber_on_timber"), InputError);
}

TEST_CASE("a ring beam over the walls' middle is a closed ring upon them, and carries the roof") {
  Case c = testing::reinforced(testing::paper_flat20());
  c.house->reinforcement->ring_beam_place = RingPlace::middle;
  const Model model = build_model(c);
  double timber = 0.0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    const auto [low, high] = geometry::bounds(b.shape);
    if (b.kind == PartKind::beam) CHECK(low.z == doctest::Approx(2.5));
    if (b.kind == PartKind::column) CHECK(high.z <= 2.4 + 1e-9);
    if (b.kind != PartKind::ring_beam) continue;
    CHECK(low.z == doctest::Approx(2.4));
    CHECK(high.z == doctest::Approx(2.5));
    timber += model.assembly.elements[i].mass.volume;
    if (b.tag == "front ring beam") {
      CHECK(low.y == doctest::Approx(0.05));
      CHECK(high.y == doctest::Approx(0.15));
    }
  }
  CHECK(timber == doctest::Approx(0.01 * (2 * 5.3 + 2 * 3.1)).epsilon(1e-9));  // axes 5.2 m and 3.2 m apart
  const std::map<std::string, Sort> found = sorts(model);
  CHECK(found.at("ring beam - ring beam").area == doctest::Approx(4 * 0.01).epsilon(1e-9));
  CHECK(found.at("brick - ring beam").area == doctest::Approx(0.1 * (2 * 5.3 + 2 * 3.1)).epsilon(1e-6));
  CHECK(found.count("brick - roof beam") == 0);

  c.house->reinforcement->ring_beam = {0.2, 0.1};  // as wide as the walls
  CHECK(sorts(build_model(c)).at("brick - ring beam").area == doctest::Approx(0.2 * (2 * 5.4 + 2 * 3.0)).epsilon(1e-6));
  const auto middle = [](House& h) { h.reinforcement->ring_beam_place = RingPlace::middle; };
  check_refused(
      [&](House& h) {
        middle(h), h.reinforcement->ring_beam = {0.3, 0.1};
      },
      "house.reinforcement.ring_beam", "wider than a wall");
  check_refused([&](House& h) { middle(h), h.roof.kind = RoofKind::gables; }, "house.reinforcement.ring_beam_place",
                "does not go with this roof");
}
