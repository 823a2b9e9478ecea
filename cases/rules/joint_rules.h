// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"

/// Choice of the law of a joint. Internal to cases/, except unused_joint_rules.
namespace voussoir::cases {

/// The joint keys of a case with all names resolved.
class JointRules {
 public:
  /// \throw InputError with the key of a name that is not known.
  JointRules(const Case& c, const Model& model);

  [[nodiscard]] std::int32_t default_law() const noexcept { return default_; }
  /// Index into Model::laws for the joint of two blocks; `b` is null for the base. Rules of stones are not considered (see StoneLaws).
  [[nodiscard]] std::int32_t law(const Block& a, const Block* b) const noexcept;
  /// Whether joints.between[rule] applies to the materials of the two blocks.
  [[nodiscard]] bool fits(std::size_t rule, const Block& a, const Block* b) const noexcept;
  /// Whether the two blocks are cells of one unit.
  [[nodiscard]] static bool are_of_one_unit(const Block& a, const Block* b) noexcept;
  /// Whether one of the two is a beam or rafter between walls, which has separate keys for its joints.
  [[nodiscard]] static bool is_of_span(const Block& a, const Block* b) noexcept;
  /// Whether the joint belongs to a house, which has separate keys for its joints.
  [[nodiscard]] static bool is_in_house(const Block& a, const Block* b) noexcept;

 private:
  struct Rule {
    std::array<std::int32_t, 2> materials;  // kBase: the base
    std::int32_t law;
  };
  [[nodiscard]] std::int32_t rule_material(const Block& block) const noexcept;
  [[nodiscard]] std::int32_t law_in_house(const Block& a, const Block& b) const noexcept;

  /// The law of a joint with a beam or rafter between walls; `b` is null for the base.
  [[nodiscard]] std::int32_t law_of_span(const Block& a, const Block* b) const noexcept;

  [[nodiscard]] bool is_edge_beam(const Block& block) const noexcept;

  std::int32_t masonry_ = 0, within_member_ = 0, collar_ = 0, between_members_ = 0, timber_on_timber_ = 0, between_beams_ = 0,
               edge_beams_ = 0;                       // of the house
  std::array<std::int32_t, 2> edge_members_{-1, -1};  // the first and the last beam of a flat roof
  std::vector<std::int32_t> inside_;                  // by material, between the cells of a unit; −1: none
  std::vector<std::int32_t> floors_;                  // between beams and walls, by House::floors
  std::vector<std::int32_t> made_from_;               // by material
  struct Span {
    std::int32_t within = 0, joint = 0, between = 0;  // within a member; of members with all else; of members of one roof
  };
  std::vector<Span> bays_, roofs_;  // by Case::floors, Case::roofs
  std::vector<Rule> between_;
  std::int32_t default_ = 0;
};

/// Rules of joints.between that determine no joint's law, each with the reason: "joints.between[1] (stone, base) applies to no joint: ...".
/// \throw InputError as JointRules
std::vector<std::string> unused_joint_rules(const Case& c, const Model& model);

}  // namespace voussoir::cases
