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
/// round the house (front, right, rear, left), each lintel in its lowest course, after a storey's outer walls its inner ones, then floors
/// beam by beam, columns, ring beams, and the roof: beam by beam, or gables course by course and the vault ring by ring. `Block::member`
/// counts the timber members of a copy from 0. \param materials  Model::materials, where `house.material` and, if anything is of timber,
/// `house.wood.material` must be found, and what loaded_materials() gives. \throw InputError with the key at fault and, where a size does
/// not fit, the nearest that does.
std::vector<Block> build_house(const House& house, std::span<const NamedMaterial> materials);

/// The materials of a roof that carries a surcharge and of floors with a load: that of their beams or voussoirs, the denser by the mass of
/// the load. So it acts in weight, inertia and wave speed, has no stiffness, and lies where the beams' own mass lies. None where there is
/// no load. \throw InputError at the key of the load, or for a material that is not known.
std::vector<NamedMaterial> loaded_materials(const House& house, std::span<const NamedMaterial> materials);

/// True if any part of the house is of timber, so that the keys of `house.wood` count.
bool has_timber(const House& house) noexcept;

}  // namespace voussoir::cases
