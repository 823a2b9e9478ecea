// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"

namespace voussoir::cases {

/// Turns a described house into blocks: walls in bond with toothed corners, openings with lintels, the roof; all copies.
///
/// The base is z = 0; the outer corner of copy 0 stands at `origin`, about which the house is turned; copy (i, j) has the number
/// i + j * copies[0] and is shifted by (i, j) * spacing along the global axes. Blocks of a copy come course by course from the bottom,
/// round the house (front, right, rear, left), each lintel in its lowest course, then columns, ring beams, and the roof: beam by beam, or
/// gables course by course and the vault ring by ring. `Block::member` counts the timber members of a copy from 0.
/// \param materials  Model::materials, where `house.material` and, if anything is of timber, `house.wood.material` must be found, and
/// what surcharged_roof() gives.
/// \throw InputError with the key at fault and, where a size does not fit, the nearest that does.
std::vector<Block> build_house(const House& house, std::span<const NamedMaterial> materials);

/// The material of a roof that carries a surcharge: that of its beams or voussoirs, the denser by the surcharge's mass. So the surcharge
/// acts in weight, inertia and wave speed, has no stiffness, and lies where the roof's own mass lies. Nothing if there is none. \throw
/// InputError at house.roof.surcharge, or for a material that is not known.
std::optional<NamedMaterial> surcharged_roof(const House& house, std::span<const NamedMaterial> materials);

/// True if any part of the house is of timber, so that the keys of `house.wood` count.
bool has_timber(const House& house) noexcept;

}  // namespace voussoir::cases
