// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cases/walls/spans/wall_vault_profile.h"
#include "cases/walls/spans/wall_vault_room.h"
#include "geometry/polyhedron.h"

/// Courses of vaults over whole rooms. Internal to cases/.
///
/// Over each side of the room lies a barrel of one profile, stretched to the room; neighbours are cut off at the upright plane through the
/// centre and the corner between them, and divided into the same courses, so that their voussoirs meet face to face. Of a cross vault the
/// courses run towards the sides, of pavilion vaults and domes along them.
namespace voussoir::cases {

/// A voussoir of such a vault. The base is z = 0.
struct VaultStone {
  geometry::Polyhedron shape;
  std::string part;    // "course 2", "web at outer 1", "keystone"
  bool whole = false;  // not cut off at a corner
  double outer = 0.0;  // m2, of its outer face
};

/// All voussoirs, side by side of the room, from the walls up. Head joints of neighbouring courses are half a voussoir apart; those that
/// would leave less than a third of one are left out.
std::vector<VaultStone> vault_stones(const WallsPlan& plan, const VaultRoom& room, const VaultProfile& profile, const WallVault& vault);

}  // namespace voussoir::cases
