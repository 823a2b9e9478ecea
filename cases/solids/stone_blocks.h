// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/forward.h"
#include "cases/model.h"

/// Stones of files as blocks. Internal to cases/.
namespace voussoir::cases {

/// Appends the stones of `c.stones`, piece by piece, to the model. \pre materials and all other blocks are in the model
/// \throw InputError with the key at fault: no stones were read, a duplicate name, an unknown material.
void add_stone_blocks(const Case& c, Model& model);

/// Whether some stone, or some group of stones, has this name.
bool is_stone_or_group(const Case& c, const std::string& name);

/// The name of a stone in the model: that of its table, then its own.
std::string stone_name(const StonesSpec& spec, const std::string& name);

/// The laws between stones. Adds required laws to the model: a law that never breaks for the insides of stones in pieces, and a law with
/// mortar for each table with a gap.
class StoneLaws {
 public:
  /// \throw InputError with the key of a law that is not known, or of mortar without a modulus
  StoneLaws(const Case& c, Model& model, std::int32_t default_law);

  /// The law of two blocks, if tables of stones determine one. \param b  null: the base
  [[nodiscard]] std::optional<std::int32_t> law(const Block& a, const Block* b) const noexcept;
  /// The law with the mortar of the gap, if both faces lie on a mortar bed; else `law`.
  [[nodiscard]] std::int32_t on_bed(std::int32_t law, const Block& a, std::int32_t face_a, const Block& b,
                                    std::int32_t face_b) const noexcept;

 private:
  std::vector<std::int32_t> of_set_;            // by table of stones; −1: none
  std::vector<std::int32_t> of_material_;       // by material, its `inside`
  std::vector<std::vector<std::int32_t>> bed_;  // by table and law
};

}  // namespace voussoir::cases
