// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

/// Contacts that return a fixed share of the energy of an impact: the hysteretic spring of Walton and Braun, THEORY.md (20a)-(20b). While a
/// point is loaded, a part of its penetration becomes an indentation, which bears nothing and recovers once the point is unloaded. As with
/// crushing, only the closure of the point changes; the laws of contact then apply unchanged.
namespace voussoir::kernels {

/// Share of the penetration that becomes indentation under first loading.
inline double part_pressed_in(double restitution) noexcept { return 1.0 - restitution * restitution; }

/// Indentation [m] at a penetration of p [m] since first touch (below 0: outside), after an indentation of `pressed` [m] in the last step.
inline double pressed_at(double p, double pressed, double restitution) noexcept {
  return p < pressed ? std::max(0.0, p) : std::max(pressed, part_pressed_in(restitution) * p);
}

/// Whether the point has been deeper than now. Its spring is then elastic, so a dashpot has to damp it.
inline bool was_deeper(double p, double pressed, double restitution) noexcept { return part_pressed_in(restitution) * p < pressed; }

/// Indentation [m] of a point taken over from a joint whose spring is closed by x [m], as if it had never been closed further.
inline double pressed_at_closure(double x, double restitution) noexcept {
  return x * part_pressed_in(restitution) / (restitution * restitution);
}

}  // namespace voussoir::kernels
