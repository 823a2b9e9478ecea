// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/rules/contact_rules.h"

#include <doctest/doctest.h>

#include "cases/input_error.h"
#include "cases/tables/contact.h"

using namespace voussoir::cases;

namespace {

const std::vector<NamedMaterial> kMaterials{{"adobe", {}}, {"wood", {}}, {"roof of adobe", {}, 0}};
constexpr std::size_t kAdobe = 0, kWood = 1, kRoof = 2, kBase = 3, kCount = 4;

/// What is wrong with the rules; "accepted".
std::string refusal(std::vector<ContactRule> rules) {
  try {
    contact_friction({.friction = 30.0, .between = std::move(rules)}, kMaterials);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("contact friction: one for all pairs of materials, but for those that have their own, in either order") {
  const Contact contact{.friction = 30.0, .between = {{{"wood", "wood"}, 20.0}, {{"base", "adobe"}, 40.0}, {{"wood", "adobe"}, 0.0}}};
  const std::vector<double> phi = contact_friction(contact, kMaterials);
  REQUIRE(phi.size() == kCount * kCount);
  const auto of = [&](std::size_t a, std::size_t b) {
    CHECK(phi[a * kCount + b] == phi[b * kCount + a]);
    return phi[a * kCount + b];
  };
  CHECK(of(kAdobe, kAdobe) == 30.0);
  CHECK(of(kWood, kWood) == 20.0);
  CHECK(of(kAdobe, kBase) == 40.0);
  CHECK(of(kWood, kBase) == 30.0);
  CHECK(of(kAdobe, kWood) == 0.0);
  SUBCASE("a material made from another has its friction") {
    CHECK(of(kRoof, kBase) == 40.0);
    CHECK(of(kRoof, kWood) == 0.0);
    CHECK(of(kRoof, kRoof) == 30.0);
  }
}

TEST_CASE("contact friction: what is refused") {
  CHECK(refusal({{{"wood", "mud"}, 20.0}}) == "contact.between[0].materials: unknown material \"mud\"; known: adobe, wood, roof of adobe");
  CHECK(refusal({{{"wood", "base"}, 20.0}, {{"base", "wood"}, 20.0}}) ==
        "contact.between[1].materials: = [\"base\", \"wood\"] stands in contact.between[0] already; a pair has one friction");
  CHECK(refusal({{{"wood", "wood"}, 90.0}}) == "contact.between[0].friction: 90 degrees; allowed: 0 to below 90");
  CHECK(refusal({{{"wood", "wood"}, -1.0}}).starts_with("contact.between[0].friction: -1 degrees"));
  CHECK(refusal({{{"wood", "base"}, 20.0}, {{"base", "base"}, 20.0}}) == "accepted");
}
