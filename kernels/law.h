// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

/// Strength and contact constants of a spring, and options where the paper leaves a choice. Passed to kernels by value.
namespace voussoir::kernels {

/// Limits of Eqs. 5-7. All stresses in Pa, tension positive.
struct Strength {
  double tension = 0.0;      // f_t
  double cohesion = 0.0;     // c
  double tan_phi = 0.0;      // of the bond (Eq. 6)
  double compression = 0.0;  // f_m
  double cap = 9.0;          // C_s
  double friction = 0.0;     // tan φ of the two materials, for the contact that a broken bond becomes (Eq. 8)
};

/// Amount by which dashpots may exceed the bounds of THEORY.md (17) and (19): zero, or without limit (contact.dashpots).
inline constexpr double kBounded = 0.0, kUnbounded = std::numeric_limits<double>::infinity();

/// Springs and dashpots per area.
struct Stiffness {
  double kn = 0.0, ks = 0.0;  // Pa/m, Eqs. 1-3
  double cn = 0.0, cs = 0.0;  // Pa s/m, Eq. 9, already divided by 1 + dt·beta (semi-implicit, THEORY.md (20))
};

enum class ShearInTension : std::uint8_t { cohesion, none, coulomb };

/// The options [failure] of the case file, and the bound of the dashpots.
struct FailureOptions {
  bool shear = true;
  bool brittle = false;
  ShearInTension in_tension = ShearInTension::cohesion;
  double dashpot_excess = kBounded;  // kBounded or kUnbounded
};

/// State of one segment of a joint. Bonded springs have no history but plastic slip; contact springs keep their elongation.
enum class Bond : std::uint8_t {
  bonded = 0,   // elastic
  slipped = 1,  // bonded, has reached the shear limit: slip is plastic
  crushed = 2,  // broken in compression, still closed: cap and friction, no tension
  contact = 3   // broken or never bonded: friction contact while closed (Eq. 8)
};
constexpr bool holds(Bond b) noexcept { return b == Bond::bonded || b == Bond::slipped; }

enum class Mode : std::uint8_t { none = 0, tension = 1, shear = 2, compression = 3 };

}  // namespace voussoir::kernels
