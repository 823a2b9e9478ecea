// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cases/house/house_case.h"
#include "cases/model.h"

namespace voussoir::cases {

/// Turns a described house into blocks: walls in bond with toothed corners, openings with lintels, the roof; all copies.
///
/// The base is z = 0; the outer corner of copy 0 stands at `origin`, about which the house is turned; copy (i, j) has the number i + j *
/// copies[0] and is shifted by (i, j) * spacing along the global axes. Blocks of a copy come course by course from the bottom, round the
/// house (front, right, rear, left), each lintel in its lowest course, after a storey's outer walls its inner ones, then floors beam by
/// beam, columns, ring beams, and the roof: beam by beam, or gables course by course and the vault ring by ring. `Block::member` counts the
/// timber members of a copy from 0.
/// \param materials  Model::materials and the result of loaded_materials(); must include `house.material` and, if the house has timber,
/// `house.wood.material`
/// \throw InputError with the key at fault and, for a size that does not fit, the nearest one that does
std::vector<Block> build_house(const House& house, std::span<const NamedMaterial> materials);

/// The materials of a roof with a surcharge and of floors with a load: the material of their beams or voussoirs, with the mass of the load
/// added to the density. The load thus acts in weight, inertia and wave speed, has no stiffness, and has the centroid of the beams. Empty
/// without loads. \throw InputError at the key of the load, or for a material that is not known.
std::vector<NamedMaterial> loaded_materials(const House& house, std::span<const NamedMaterial> materials);

/// Whether any part of the house is of timber, so that the keys of `house.wood` apply.
bool has_timber(const House& house) noexcept;

}  // namespace voussoir::cases
