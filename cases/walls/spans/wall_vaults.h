// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cases/model.h"
#include "cases/walls/wall_plan.h"

/// Barrel vaults between walls. Internal to cases/.
namespace voussoir::cases {

/// Finds the bays of all vaults (WallsPlan::vaults) and raises their gables (Leg::hills). \pre walls have met \throw InputError,
/// InputErrors
void plan_wall_vaults(const std::vector<WallSpec>& walls, const std::vector<WallVault>& vaults, WallsPlan& plan);

/// Materials of voussoirs under a surcharge.
std::vector<NamedMaterial> loaded_vault_materials(const std::vector<WallSpec>& walls, const WallsPlan& plan,
                                                  const std::vector<WallVault>& vaults, std::span<const NamedMaterial> materials);

/// Appends the voussoirs, vault by vault, ring by ring, from the first side to the second. The base is z = 0.
void add_vault_rings(const std::vector<WallSpec>& walls, const WallsPlan& plan, const std::vector<WallVault>& vaults,
                     std::span<const NamedMaterial> materials, std::vector<Block>& blocks);

}  // namespace voussoir::cases
