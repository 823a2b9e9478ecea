// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/input/motion/spectra/demand_spectrum.h"
#include "solver/limit/kinematics/kinematic_curve.h"

/// The kinematic verification of a local mechanism by Circolare 7/2019, C8.7.1.2.1 (Italy, to NTC 2018), linear and non-linear, at the base
/// of a building or at a height in it. Equation numbers are those of the Circolare, read in a transcription of it that its makers have not
/// reviewed.
namespace voussoir::io {

/// The building in which a mechanism lies, for a spectrum at its height: C7.2.3, first mode alone, linear with height.
struct BuildingAround {
  double height = 0.0;    // m, z: of the mechanism above the ground
  double top = 0.0;       // m, H
  double period = 0.0;    // s, T_1
  double damping = 0.05;  // ξ_1, of critical
  int storeys = 1;        // n: γ_1 = 3 n / (2 n + 1), (C7.2.10)

  [[nodiscard]] double participation() const noexcept { return 3.0 * storeys / (2.0 * storeys + 1.0); }
};

struct KinematicQuestion {
  double confidence = 1.35;  // FC; 1.35 is that of knowledge level LC1, which goes with limit analysis: it does not limit compression
  double behaviour = 2.0;    // q
  std::optional<DemandSpectrum> demand;
  std::optional<BuildingAround> around;  // none: at the base
};

/// Largest acceleration at the height, (C7.2.7, C7.2.8), at least that of the ground [m/s2]. Nothing where the spectrum has no value at
/// T_1.
std::optional<double> floor_acceleration(const DemandSpectrum& d, const BuildingAround& b);
/// Spectral acceleration at the height, (C7.2.5, C7.2.6) [m/s2]. In the factor 1.1 / sqrt(ξ_1) the damping is a fraction: in per cent, as
/// the list below the equation has it, the peak would lie below the acceleration of the floor.
std::optional<double> floor_spectrum(const DemandSpectrum& d, const BuildingAround& b, double period, double damping);

/// One line of the verification: a demand and what it may be.
struct KinematicLine {
  std::string name, words;                          // "linear_slv"; "linear, SLV, q = 2"
  double period = solver::KinematicCurve::kNone;    // s, secant; of the non-linear ones
  double demand = solver::KinematicCurve::kNone;    // m/s2 or m
  double capacity = solver::KinematicCurve::kNone;  // likewise
  std::string open{};                               // what is not proven

  [[nodiscard]] double ratio() const noexcept { return demand / capacity; }
};

struct KinematicCheck {
  double activation = solver::KinematicCurve::kNone;  // m/s2, a_0 = α_0 g / (e* FC), (C8.7.1.3)
  double zero = solver::KinematicCurve::kNone;        // m, d_0: spectral displacement at which a is zero
  std::vector<KinematicLine> lines;                   // with a demand
};

/// \param gravity  m/s2
KinematicCheck check_kinematics(const solver::KinematicCurve& curve, const KinematicQuestion& asked, double gravity);

/// Text for the user, with line ends. \param rule  the flow rule of the mechanism
std::string kinematic_text(const solver::KinematicCurve& curve, const KinematicQuestion& asked, const KinematicCheck& check,
                           const std::string& rule, Vec3 origin);
/// As one JSON object.
std::string kinematic_json(const solver::KinematicCurve& curve, const KinematicQuestion& asked, const KinematicCheck& check, Vec3 origin);

}  // namespace voussoir::io
