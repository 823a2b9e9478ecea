// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "cases/rules/joint_rules.h"

#include <algorithm>
#include <cmath>

#include "cases/case.h"
#include "cases/house/house.h"
#include "cases/input_error.h"
#include "cases/names.h"
#include "cases/solids/ground.h"
#include "geometry/nth.h"

namespace voussoir::cases {
namespace {

/// Checks that the mortar's thickness agrees with the house: bricks are extended to the middle of the mortar, so the thickness is both a
/// size and a stiffness (Eq. 3).
void check_mortar(const House& house, const NamedLaw& law) {
  if (house.mortar == 0.0 || std::abs(house.mortar - law.value.thickness) < 1e-9) return;
  throw InputError("house.mortar", text(house.mortar) + " m, but joint_laws." + law.name + ".thickness is " + text(law.value.thickness) +
                                       " m; give both the same");
}

/// The first and the last beam of the roof, the same members in all copies of the house. Beams are numbered along the roof.
std::array<std::int32_t, 2> end_beams(const Model& model) noexcept {
  std::array<std::int32_t, 2> ends{-1, -1};
  for (const Block& block : model.blocks) {
    if (block.kind != PartKind::beam || block.house < 0) continue;
    ends[0] = ends[0] < 0 ? block.member : std::min(ends[0], block.member);
    ends[1] = std::max(ends[1], block.member);
  }
  return ends;
}

/// Whether two blocks lie in the two leaves of one wall.
bool are_leaves(const Block& a, const Block& b) noexcept { return a.leaf >= 0 && b.leaf >= 0 && (a.leaf ^ b.leaf) == 1; }

}  // namespace

JointRules::JointRules(const Case& c, const Model& model) {
  for (const NamedMaterial& m : model.materials) made_from_.push_back(m.made_from);
  Faults faults;
  const auto law = [&](const std::string& name, const std::string& key) {
    std::int32_t found = 0;
    faults.attempt([&] { found = find_law(model.laws, name, key); });
    return found;
  };
  const auto mortar = [&](const NamedLaw& named) { faults.attempt([&] { check_mortar(*c.house, named); }); };
  if (c.house) {
    masonry_ = law(c.house->joint, "house.joint");
    mortar(nth(model.laws, masonry_));
    collar_ = masonry_;
    if (c.house->leaves && c.house->leaves->joint) {
      collar_ = law(*c.house->leaves->joint, "house.leaves.joint");
      if (const NamedLaw& own = nth(model.laws, collar_); own.value.thickness > 0.0) mortar(own);
    }
    // Keys of parts that the house lacks may name laws that the case lacks.
    if (has_timber(*c.house)) {
      within_member_ = law(c.house->wood.within_member, "house.wood.within_member");
      between_members_ = law(c.house->wood.between_members, "house.wood.between_members");
      const auto& timber = c.house->wood.timber_on_timber;
      timber_on_timber_ = timber ? law(*timber, "house.wood.timber_on_timber") : between_members_;
    }
    if (c.house->roof.kind == RoofKind::flat || c.house->roof.kind == RoofKind::pitched)
      between_beams_ = law(c.house->roof.between_beams, "house.roof.between_beams");
    edge_beams_ = between_beams_;
    if (c.house->roof.kind == RoofKind::flat && c.house->roof.edge_beams) {
      edge_beams_ = law(*c.house->roof.edge_beams, "house.roof.edge_beams");
      edge_members_ = end_beams(model);
    }
    for (std::size_t i = 0; i < c.house->floors.size(); ++i)
      floors_.push_back(law(c.house->floors[i].joint, indexed_key("house.floor", i, "joint")));
  }
  for (std::size_t i = 0; i < c.floors.size(); ++i) {
    const WallFloor& f = c.floors[i];
    const std::int32_t joint = law(f.beams.joint, indexed_key("floor", i, "joint"));
    bays_.push_back({law(f.within_member, indexed_key("floor", i, "within_member")), joint, joint});
  }
  for (std::size_t i = 0; i < c.roofs.size(); ++i) {
    const WallRoof& r = c.roofs[i];
    roofs_.push_back({law(r.within_member, indexed_key("roof", i, "within_member")), law(r.joint, indexed_key("roof", i, "joint")),
                      law(r.rafters.between_beams, indexed_key("roof", i, "between_beams"))});
  }
  for (std::size_t i = 0; i < c.joints.between.size(); ++i) {
    const JointRule& rule = c.joints.between[i];
    Rule resolved{{geometry::kBase, geometry::kBase}, law(rule.law, indexed_key("joints.between", i, "law"))};
    for (std::size_t k = 0; k < 2; ++k) {
      if (rule.materials[k] == "base") continue;
      faults.attempt([&] {
        resolved.materials[k] = find_material(model.materials, rule.materials[k], indexed_key("joints.between", i, "materials"));
      });
    }
    between_.push_back(resolved);
  }
  default_ = law(c.joints.default_law, "joints.default");
  inside_.assign(model.materials.size(), -1);
  for (const Block& block : model.blocks) {
    const auto m = static_cast<std::size_t>(block.material);
    if (block.unit < 0 || inside_[m] >= 0) continue;
    const NamedMaterial& material = model.materials[m];
    const std::string key = "materials." + material.name + ".inside";
    inside_[m] = 0;
    if (material.value.inside)
      inside_[m] = law(*material.value.inside, key);
    else
      faults.add({key, "is missing: units in cells (house.cells, wall.cells, block.cells; halves) need the law between them"});
  }
  faults.raise();
}

std::int32_t JointRules::rule_material(const Block& block) const noexcept {
  const std::int32_t made_from = nth(made_from_, block.material);
  return made_from < 0 ? block.material : made_from;
}

bool JointRules::is_edge_beam(const Block& block) const noexcept {
  return block.member == edge_members_[0] || block.member == edge_members_[1];
}

std::int32_t JointRules::law_in_house(const Block& a, const Block& b) const noexcept {
  if (a.member < 0 && b.member < 0) return are_leaves(a, b) ? collar_ : masonry_;
  if (a.member < 0 || b.member < 0) {
    const std::int32_t floor = std::max(a.floor, b.floor);
    return floor < 0 ? between_members_ : nth(floors_, floor);
  }
  if (a.member == b.member) return within_member_;
  if (a.kind == PartKind::beam && b.kind == PartKind::beam) return is_edge_beam(a) || is_edge_beam(b) ? edge_beams_ : between_beams_;
  return timber_on_timber_;
}

std::int32_t JointRules::law_of_span(const Block& a, const Block* b) const noexcept {
  const auto of = [&](const Block& x) -> const Span& { return nth(x.kind == PartKind::floor_beam ? bays_ : roofs_, x.span); };
  if (b == nullptr) return of(a).joint;
  if (a.span < 0 || b->span < 0) return of(a.span < 0 ? *b : a).joint;
  if (a.member == b->member) return of(a).within;
  return a.kind == b->kind && a.span == b->span ? of(a).between : of(a).joint;
}

bool JointRules::fits(std::size_t rule, const Block& a, const Block* b) const noexcept {
  const std::array<std::int32_t, 2> pair{rule_material(a), b == nullptr ? geometry::kBase : rule_material(*b)};
  return between_[rule].materials == pair || between_[rule].materials == std::array{pair[1], pair[0]};
}

bool JointRules::are_of_one_unit(const Block& a, const Block* b) noexcept { return b != nullptr && a.unit >= 0 && a.unit == b->unit; }

bool JointRules::is_of_span(const Block& a, const Block* b) noexcept { return a.span >= 0 || (b != nullptr && b->span >= 0); }

bool JointRules::is_in_house(const Block& a, const Block* b) noexcept { return a.house >= 0 && (b == nullptr || a.house == b->house); }

std::int32_t JointRules::law(const Block& a, const Block* b) const noexcept {
  if (are_of_one_unit(a, b)) return nth(inside_, a.material);
  if (is_of_span(a, b)) return law_of_span(a, b);
  // Columns are fixed to the ground (paper 3.3).
  if (is_in_house(a, b)) return b != nullptr ? law_in_house(a, *b) : a.kind == PartKind::column ? within_member_ : masonry_;
  for (std::size_t i = 0; i < between_.size(); ++i) {
    if (fits(i, a, b)) return between_[i].law;
  }
  return default_;
}

namespace {

/// Whether a table of stones determines the law of two blocks, see StoneLaws.
bool is_of_stones(const Case& c, const Block& a, const Block* b) {
  if (b == nullptr || a.set < 0) return false;
  return a.stone == b->stone || (a.set == b->set && nth(c.stones, a.set).joint);
}

}  // namespace

std::vector<std::string> unused_joint_rules(const Case& c, const Model& model) {
  const JointRules rules(c, model);
  const std::size_t n = c.joints.between.size();
  std::vector<bool> used(n), taken(n);  // taken: faces that fit touch, but a rule with precedence gives their law
  for (const geometry::Joint& joint : model.assembly.joints) {
    const Block& a = nth(model.blocks, joint.element_a);
    const Block* b = beyond(model, joint);
    bool before =
        JointRules::is_in_house(a, b) || JointRules::are_of_one_unit(a, b) || JointRules::is_of_span(a, b) || is_of_stones(c, a, b);
    for (std::size_t i = 0; i < n; ++i) {
      if (!rules.fits(i, a, b)) continue;
      (before ? taken : used)[i] = true;
      before = true;
    }
  }
  std::vector<std::string> words;
  for (std::size_t i = 0; i < n; ++i) {
    if (used[i]) continue;
    const JointRule& rule = c.joints.between[i];
    words.push_back(indexed_key("joints.between", i, "") + " (" + rule.materials[0] + ", " + rule.materials[1] + ") applies to no joint: " +
                    (taken[i] ? std::string("wherever these touch, ") +
                                    (!c.floors.empty() || !c.roofs.empty()
                                         ? "the keys of [[floor]] and [[roof]] (joint, within_member) or an earlier rule come"
                                     : c.house ? "the house's own keys (house.joint, house.wood.*, house.roof.*) or an earlier rule come"
                                     : c.stones.empty() ? "an earlier rule comes"
                                                        : "stones.joint or an earlier rule comes") +
                                    " first"
                              : "no faces of these two touch"));
  }
  return words;
}

}  // namespace voussoir::cases
