// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

/// Impacts that give back a share of what they take: the hysteretic spring of Walton and Braun, THEORY.md (20a)-(20b). A point is pressed
/// in by a part of its penetration, and this part comes out again while nothing presses. So, as with crushing, the closure of a point
/// moves, and the laws of contact go on from there as they are.
namespace voussoir::kernels {

/// Part of the penetration that stays while the point is pressed more than ever since it touched.
inline double part_pressed_in(double restitution) noexcept { return 1.0 - restitution * restitution; }

/// How far a point is pressed in [m], at a penetration of p [m] since it touched, below 0 outside, and `pressed` [m] before.
inline double pressed_at(double p, double pressed, double restitution) noexcept {
  return p < pressed ? std::max(0.0, p) : std::max(pressed, part_pressed_in(restitution) * p);
}

/// Whether the point has been pressed more than now: then it takes no more than it gave back, and a dashpot must still its motion.
inline bool was_deeper(double p, double pressed, double restitution) noexcept { return part_pressed_in(restitution) * p < pressed; }

/// Of a point that goes on from a joint, whose spring is closed by x [m]: how far it is pressed in if that is the most that it ever was.
inline double pressed_at_closure(double x, double restitution) noexcept {
  return x * part_pressed_in(restitution) / (restitution * restitution);
}

}  // namespace voussoir::kernels
