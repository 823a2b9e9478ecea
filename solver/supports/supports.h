// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/world/world.h"

/// Motion of fixed elements by their histories (World::supports). Like all velocities, theirs are half a step behind positions: (22)-(24).
namespace voussoir::solver {

/// Whether a support turns.
[[nodiscard]] bool supports_turn(const World& w) noexcept;

/// Puts all supports where their histories have them. \param t  in the histories [s] \return the largest displacement above the limit of
/// a search (Travel::displacement_over_limit) [m]
double place_supports(World& w, double t);

/// Sets the velocities with which supports go on to the next step, and takes the dashpots' loss by them into the books. To be called
/// between the forces and the kick. \param now, next  in the histories [s]
void move_supports_on(World& w, double now, double next);

/// How far a point of a support has moved at most: the way of its centroid, and where it turns that of its farthest corner about it [m].
[[nodiscard]] double moved(const World& w, const Support& s) noexcept;
/// The same at a time of its history [s].
[[nodiscard]] double moved_at(const World& w, const Support& s, double t) noexcept;

/// Sets the angular velocities that move_supports_on has found: the drift leaves fixed elements without one. To be called after the drift.
void spin_supports(World& w) noexcept;

}  // namespace voussoir::solver
