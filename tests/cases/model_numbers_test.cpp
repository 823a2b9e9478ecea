// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdint>

#include "cases/model.h"
#include "tests/cases/paper_house.h"

// The numbers by which a model refers to its own materials, laws, elements and tables exist.
namespace voussoir {
namespace {

using namespace cases;

template <class List>
void check_number(std::int32_t number, const List& of, std::int32_t none) {
  if (number == none) return;
  CHECK(number >= 0);
  CHECK(number < static_cast<std::int32_t>(of.size()));
}

/// That the numbers of all blocks in these members are in these lists, or none.
void check_blocks(const Case& c, const Model& m) {
  for (const Block& b : m.blocks) {
    check_number(b.material, m.materials, 0);
    check_number(b.set, m.stones, -1);
    check_number(b.support_motion, m.support_motions, -1);
    if (c.base) check_number(b.ground, c.base->parts, -1);
    if (c.house) check_number(b.floor, c.house->floors, -1);
    if (b.house < 0 && b.set < 0 && b.ground < 0) check_number(b.given, c.blocks, 0);
  }
}

void check_numbers(const Case& c) {
  const Model m = build_model(c);
  for (std::size_t i = 0; i < m.materials.size(); ++i) {
    check_number(m.materials[i].made_from, m.materials, -1);
    CHECK(m.materials[i].made_from != static_cast<std::int32_t>(i));
  }
  for (const NamedLaw& law : m.laws) check_number(law.made_from, m.laws, -1);
  for (const std::int32_t law : m.joint_law) check_number(law, m.laws, 0);
  for (const std::int32_t history : m.load_history) check_number(history, m.support_motions, -1);
  for (const std::int32_t path : m.load_path) check_number(path, m.support_motions, -1);
  CHECK(m.joint_law.size() == m.assembly.joints.size());
  CHECK(m.joint_strength.size() == m.assembly.joints.size());
  CHECK(m.contact_friction.size() == (m.materials.size() + 1) * (m.materials.size() + 1));
  check_blocks(c, m);
  for (const TieBar& tie : m.ties) {
    for (const auto& end : tie.ends) {
      for (const TieHold& hold : end) check_number(hold.element, m.blocks, geometry::kBase);
    }
  }
}

void stand_on_two_levels(Case& c) {
  BasePart& part = c.base->parts.emplace_back();
  part.x = {2.8, 6.0}, part.y = {-1.0, 5.0}, part.level = 0.6;
}

Case house_with_rod() {
  Case c = testing::paper_flat20();
  c.house->openings.clear();
  c.ties.push_back({.name = "rod", .from = {0.0, 0.1, 1.5}, .to = {5.4, 0.1, 1.5}, .area = 1e-4, .young = 2e11});
  return c;
}

}  // namespace

TEST_CASE("model: the numbers of materials, laws, elements and tables exist") {
  SUBCASE("of a house with a rod") { check_numbers(house_with_rod()); }
  SUBCASE("of a house on ground at two levels, whose roof bears a load") {
    Case c = house_with_rod();
    c.house->roof.surcharge = 100.0;
    stand_on_two_levels(c);
    check_numbers(c);
  }
  SUBCASE("of a house of bricks in halves on ground that moves") {
    Case c = house_with_rod();
    c.house->halves = true;
    c.materials["adobe"].inside = "strong";
    stand_on_two_levels(c);
    c.base->parts[0].motion.emplace().velocity = Vec3{0.0, 0.0, -0.01};
    check_numbers(c);
  }
  SUBCASE("of blocks on a part of the ground, with scatter") {
    Case c = testing::stack_of_blocks(2, {0.2, 0.1, 0.1});
    BasePart& part = c.base->parts.emplace_back();
    part.x = {-1.0, 1.0}, part.y = {-1.0, 1.0}, part.level = 0.1;
    c.base->z = -0.1;
    c.blocks[1].halves = true;
    c.materials["adobe"].inside = "strong";
    check_numbers(c);
  }
}

TEST_CASE("model: the parts of the ground have the rules of the base") {
  Case c = house_with_rod();
  stand_on_two_levels(c);
  c.contact.between = {{{"base", "adobe"}, 12.0}, {{"base", "wood"}, 7.0}};
  const Model m = build_model(c);
  const std::size_t base = m.materials.size(), ground = base - 1;
  REQUIRE(m.materials[ground].name == "base");
  for (std::size_t k = 0; k <= base; ++k) CHECK(m.contact_friction[ground * (base + 1) + k] == m.contact_friction[base * (base + 1) + k]);
  for (const Block& b : m.blocks) {
    if (b.ground >= 0) CHECK(b.material == static_cast<std::int32_t>(ground));
  }
}

}  // namespace voussoir
