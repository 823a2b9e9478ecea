// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/model.h"

/// The stones of files as blocks. Internal to cases/.
namespace voussoir::cases {

/// Appends the stones of `c.stones`, piece by piece, to the model, whose materials and other blocks are there.
/// \throw InputError with the key at fault: no stones were read, a name that stands twice, an unknown material.
void add_stone_blocks(const Case& c, Model& model);

/// Whether some stone, or a group of stones, has this name.
bool is_stone_or_group(const Case& c, const std::string& name);

/// How a stone is called in the model: with the name of its table before it.
std::string stone_name(const StonesSpec& spec, const std::string& name);

/// The laws between stones. Adds to the model what they need: a law that never breaks for the insides of stones in pieces, and a law with
/// mortar for each table with a gap.
class StoneLaws {
 public:
  /// \throw InputError with the key of a law that is not known, or of mortar without a modulus
  StoneLaws(const Case& c, Model& model, std::int32_t default_law);

  /// Of two blocks, if the tables of stones say one. \param b  null: the base
  [[nodiscard]] std::optional<std::int32_t> law(const Block& a, const Block* b) const noexcept;
  /// The same law with the mortar of the gap, if both faces stand on a bed of it.
  [[nodiscard]] std::int32_t on_bed(std::int32_t law, const Block& a, std::int32_t face_a, const Block& b,
                                    std::int32_t face_b) const noexcept;

 private:
  std::vector<std::int32_t> of_set_;            // -1: none
  std::vector<std::int32_t> of_material_;       // inside
  std::vector<std::vector<std::int32_t>> bed_;  // by table and law
};

}  // namespace voussoir::cases
