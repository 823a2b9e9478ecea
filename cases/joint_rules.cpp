// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/joint_rules.h"

#include "cases/house/house.h"
#include "cases/names.h"

namespace voussoir::cases {

JointRules::JointRules(const Case& c, const Model& model) {
  for (const NamedMaterial& m : model.materials) made_from_.push_back(m.made_from);
  if (c.house) {
    masonry_ = find_law(model.laws, c.house->joint, "house.joint");
    // The keys of what a house does not have may name laws that the case does not have.
    if (has_timber(*c.house)) {
      within_member_ = find_law(model.laws, c.house->wood.within_member, "house.wood.within_member");
      between_members_ = find_law(model.laws, c.house->wood.between_members, "house.wood.between_members");
    }
    if (c.house->roof.kind == RoofKind::flat)
      between_beams_ = find_law(model.laws, c.house->roof.between_beams, "house.roof.between_beams");
  }
  for (std::size_t i = 0; i < c.joints.between.size(); ++i) {
    const JointRule& rule = c.joints.between[i];
    Rule resolved{{geometry::kBase, geometry::kBase}, find_law(model.laws, rule.law, indexed_key("joints.between", i, "law"))};
    for (std::size_t k = 0; k < 2; ++k) {
      if (rule.materials[k] == "base") continue;
      resolved.materials[k] = find_material(model.materials, rule.materials[k], indexed_key("joints.between", i, "materials"));
    }
    between_.push_back(resolved);
  }
  default_ = find_law(model.laws, c.joints.default_law, "joints.default");
}

std::int32_t JointRules::rule_material(const Block& block) const noexcept {
  const std::int32_t made_from = made_from_[static_cast<std::size_t>(block.material)];
  return made_from < 0 ? block.material : made_from;
}

std::int32_t JointRules::law_in_house(const Block& a, const Block& b) const noexcept {
  if (a.member < 0 && b.member < 0) return masonry_;
  if (a.member < 0 || b.member < 0) return between_members_;
  if (a.member == b.member) return within_member_;
  if (a.kind == PartKind::beam && b.kind == PartKind::beam) return between_beams_;
  return between_members_;
}

std::int32_t JointRules::law(const Block& a, const Block* b) const noexcept {
  // Columns stand fixed to the ground (paper 3.3).
  if (a.house >= 0 && b == nullptr) return a.kind == PartKind::column ? within_member_ : masonry_;
  if (a.house >= 0 && b != nullptr && a.house == b->house) return law_in_house(a, *b);
  const std::array<std::int32_t, 2> pair{rule_material(a), b == nullptr ? geometry::kBase : rule_material(*b)};
  for (const Rule& rule : between_) {
    if (rule.materials == pair || rule.materials == std::array{pair[1], pair[0]}) return rule.law;
  }
  return default_;
}

}  // namespace voussoir::cases
