// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cases/model.h"
#include "cases/walls/wall_plan.h"

/// Vaults between walls. Internal to cases/.
namespace voussoir::cases {

/// Finds the bays of barrel vaults (WallsPlan::vaults), and raises their gables and the walls under cross vaults (Leg::hills). \pre walls
/// have met \throw InputError, InputErrors
void plan_wall_vaults(const std::vector<WallSpec>& walls, const std::vector<WallVault>& vaults, WallsPlan& plan);

/// Materials of voussoirs under a surcharge.
std::vector<NamedMaterial> loaded_vault_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                  const std::vector<WallVault>& vaults, std::span<const NamedMaterial> materials);

/// Appends the voussoirs, vault by vault: of a barrel vault ring by ring, from the first side to the second. The base is z = 0.
void add_vaults(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallVault>& vaults,
                std::span<const NamedMaterial> materials, std::vector<Block>& blocks);

}  // namespace voussoir::cases
