// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

/// Tables [joint_laws.NAME] of the case file.
namespace voussoir::cases {

enum class SofteningCurve { exponential, linear };

/// Strength of a joint (Eqs. 5-7), and the mortar (Eq. 3) or the stiffness of the joint. With neither, its stiffness is that of Eq. 2.
struct JointLaw {
  double tension = 0.0;      // f_t, Pa
  double cohesion = 0.0;     // c, Pa
  double friction = 0.0;     // phi, degrees, while the bond holds
  double compression = 0.0;  // f_m, Pa
  double cap = 9.0;          // C_s
  double thickness = 0.0;    // t_M, m
  double young = 0.0;        // E_M, Pa
  double poisson = 0.0;
  double fracture_energy_tension = 0.0, fracture_energy_shear = 0.0;  // J/m2; 0: brittle in tension, failure.post_shear in shear
  SofteningCurve softening = SofteningCurve::exponential;
  std::optional<double> residual_friction{};  // degrees, of the joint without its bond; none: friction of [contact]
  double dilatancy = 0.0;                     // degrees, of the first slip; decreases to zero with the wear of the bond
  std::optional<double> normal_stiffness{},
      shear_stiffness{};                    // k_n, k_s, Pa/m: of the joint alone, in series with its blocks; both or none
  std::optional<double> maximum_closure{};  // V, m: closure limit of a dry joint that stiffens as it closes, k_n at no pressure; else none

  [[nodiscard]] bool stiffens() const noexcept { return maximum_closure.has_value(); }  // a joint that stiffens has no bond
};

}  // namespace voussoir::cases
