// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cases/forward.h"
#include "cases/model.h"

/// Parts of the ground that are higher than the base, or move: Base::parts of the case. Internal to cases/.
namespace voussoir::cases {

/// A copy of the case with House::ground set, so that walls begin on the parts; none: the case has no parts under a house.
/// \throw InputError with the key at fault: a part without a place, outside every wall of the house, inside another part.
std::optional<Case> with_ground(const Case& c);

/// Appends the material of the ground after all other materials: hundreds of times stiffer than any other, with the friction of the base.
/// \pre the case has parts
void add_ground_material(Model& model);

/// Appends one fixed element per part, and the motions of moving parts. \pre all other blocks and the ground's material are in the model
void add_ground(const Case& c, Model& model);

/// The block on the other side of a joint from element_a; null for the base or ground.
const Block* beyond(const Model& model, const geometry::Joint& joint) noexcept;

}  // namespace voussoir::cases
