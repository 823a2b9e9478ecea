// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/rules/contact_rules.h"

#include <cstdint>
#include <optional>

#include "cases/input_error.h"
#include "cases/names.h"
#include "geometry/nth.h"

namespace voussoir::cases {

std::vector<double> contact_friction(const Contact& contact, std::span<const NamedMaterial> materials) {
  const std::size_t n = materials.size() + 1, base = materials.size();
  std::vector<std::optional<std::size_t>> rule_of(n * n);
  for (std::size_t i = 0; i < contact.between.size(); ++i) {
    const ContactRule& rule = contact.between[i];
    const std::string key = indexed_key("contact.between", i, "materials");
    const auto index = [&](const std::string& name) {
      return name == "base" ? base : static_cast<std::size_t>(find_material(materials, name, key));
    };
    const std::size_t a = index(rule.materials[0]), b = index(rule.materials[1]);
    if (rule_of[a * n + b]) {
      throw InputError(key, "= [" + quoted(rule.materials[0]) + ", " + quoted(rule.materials[1]) + "] stands in " +
                                indexed_key("contact.between", *rule_of[a * n + b], "") + " already; a pair has one friction");
    }
    if (!(rule.friction >= 0.0 && rule.friction < 90.0)) {
      throw InputError(indexed_key("contact.between", i, "friction"), text(rule.friction) + " degrees; allowed: 0 to below 90");
    }
    rule_of[a * n + b] = rule_of[b * n + a] = i;
  }
  const auto own = [&](std::size_t m) {
    if (m == base || materials[m].is_ground) return base;
    return materials[m].made_from >= 0 ? static_cast<std::size_t>(materials[m].made_from) : m;
  };
  std::vector<double> friction;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const auto rule = rule_of[own(a) * n + own(b)];
      friction.push_back(rule ? contact.between[*rule].friction : contact.friction);
    }
  }
  return friction;
}

double friction_without_bond(const Model& model, std::size_t joint) {
  const JointLaw& law = nth(model.laws, model.joint_law[joint]).value;
  if (law.residual_friction) return *law.residual_friction;
  const std::size_t base = model.materials.size();
  const auto material = [&](std::int32_t element) {
    return element == geometry::kBase ? base : static_cast<std::size_t>(nth(model.blocks, element).material);
  };
  const geometry::Joint& j = model.assembly.joints[joint];
  return model.contact_friction[material(j.element_a) * (base + 1) + material(j.element_b)];
}

}  // namespace voussoir::cases
