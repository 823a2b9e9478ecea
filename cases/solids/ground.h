// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cases/model.h"

/// Parts of the ground that are higher than the base, or move: Case::base's parts. Internal to cases/.
namespace voussoir::cases {

/// The case with House::ground, so that walls begin upon the parts; none: the case has no parts under a house.
/// \throw InputError with the key at fault: a part without a place, off every wall of the house, in another part.
std::optional<Case> with_ground(const Case& c);

/// What ground is made of: hundreds of times stiffer than all else, and of the base's friction. Appended after all other materials.
/// \pre the case has parts
void add_ground_material(Model& model);

/// Appends one fixed element a part, and the motions of those that have one. \pre all other blocks are there, and the material
void add_ground(const Case& c, Model& model);

/// The block on the other side of a joint from element_a; null: the base, or ground.
const Block* beyond(const Model& model, const geometry::Joint& joint) noexcept;

}  // namespace voussoir::cases
