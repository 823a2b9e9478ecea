// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "cases/walls/wall_plan.h"

/// The room under a vault that walls bear on all sides. Internal to cases/.
namespace voussoir::cases {

/// A straight part of the inner faces round a room.
struct RoomSide {
  std::size_t leg = 0;
  Vec3 from, to;          // m, corners of the room, counter-clockwise; z = 0
  double distance = 0.0;  // m, of the centre
};

/// A convex room. Its centre: where the diagonals of a quadrilateral cross, the centroid of any other.
struct VaultRoom {
  Vec3 centre;
  std::vector<RoomSide> sides;  // counter-clockwise
  double seat = 0.0;            // m, height of the walls' tops above the base

  /// Twice the least distance of a side from the centre [m].
  [[nodiscard]] double span() const noexcept;
};

/// The room of a vault: within one round wall under a dome, else between four straight sides. \throw InputError
VaultRoom find_room(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index);

/// Refuses a room whose corners the walls leave open, or feet that do not stand on the walls. \param foot  m, over the least distance
/// \param spare  m, of each wall behind the feet
void check_feet(const std::vector<WallSpec>& walls, const WallsPlan& plan, const WallVault& vault, std::size_t index, const VaultRoom& room,
                double foot, double spare);

}  // namespace voussoir::cases
