// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "io/input/motion/spectra/demand_spectrum.h"
#include "io/output/measures/capacity/capacity_curve.h"

/// The demand of a spectrum on a capacity curve: the target displacement of EN 1998-1:2004, annex B (N2: Fajfar 2000), the same by
/// Circolare 7/2019, C7.3.4.2 (method A), and the capacity spectrum of its method B. Equations and sources: io/MEASURES.md.
namespace voussoir::io {

/// The structure with one degree of freedom that stands for the building: d* = d/Γ, F* = F/Γ, of mass m* (EN 1998-1, B.2).
struct EquivalentSystem {
  double participation = Bilinear::kNone;  // Γ = Σ m φ / Σ m φ²
  double mass = Bilinear::kNone;           // kg, m* = Σ m φ
  double all_mass = Bilinear::kNone;       // kg, of what moves
  double shape_at = Bilinear::kNone;       // m, displacement of the control point at which φ was taken

  /// Share of the mass that moves as φ does, Γ m* / Σ m: 1 where all go alike, little where parts move by themselves.
  [[nodiscard]] double effective_share() const noexcept { return participation * mass / all_mass; }
};

/// φ is the displacement along the push over that of the control point. \param mass  kg, by element \param along  m, by element \param
/// control  m \return none (NaN) without a displacement of the control point
EquivalentSystem equivalent_system(const std::vector<double>& mass, const std::vector<double>& along, double control);

/// The result of one method. Forces and displacements of the equivalent system are marked with a star in the equations.
struct PerformancePoint {
  std::string name, words;               // "n2_ec8"; "N2, EC 8"
  double force = Bilinear::kNone;        // N, F*_y
  double yield = Bilinear::kNone;        // m, d*_y
  double period = Bilinear::kNone;       // s, T*; of the capacity spectrum: secant to the point
  double spectral = Bilinear::kNone;     // m/s2, S_e(T*)
  double ratio = Bilinear::kNone;        // q_u = S_e m* / F*_y: elastic demand over strength; of the capacity spectrum: none
  double elastic = Bilinear::kNone;      // m, d*_et
  double target_star = Bilinear::kNone;  // m, d*_t
  double target = Bilinear::kNone;       // m, Γ d*_t: target displacement of the control point
  double damping = Bilinear::kNone;      // of critical, with what yielding adds; of N2: that of the spectrum
  double demand = Bilinear::kNone;       // target over the displacement at near collapse; NaN: not known
  bool at_most = false;                  // near collapse was not reached, and `demand` is over the farthest displacement of the curve
  std::vector<std::string> open;         // sentences: what is not proven
};

/// A spectrum as acceleration [m/s2] over displacement [m].
struct SpectrumCurve {
  std::vector<double> displacement, acceleration;
};
/// The spectrum at its own damping, at 200 periods from 0.01 to 10 s as far as it has values, up to a displacement.
SpectrumCurve spectrum_curve(const DemandSpectrum& spectrum, double until);

struct Performance {
  std::string spectrum;
  double damping = 0.05, corner = 0.0;  // of critical; s
  EquivalentSystem system;
  double near_collapse = Bilinear::kNone, end = Bilinear::kNone;  // m, capacity; farthest point of the curve
  std::vector<PerformancePoint> points;
  SpectrumCurve curve;  // up to twice what capacity and targets have of displacement
};

/// N2 with a given bilinear curve of the building. \param name, words  of the method \param most_ratio  of q_u, beyond which the method is
/// not allowed (NaN: no limit)
PerformancePoint n2_point(const std::string& name, const std::string& words, const Bilinear& bilinear, const EquivalentSystem& system,
                          const DemandSpectrum& spectrum, double most_ratio);

/// Capacity spectrum: the displacement at which the spectrum, damped by what the curve dissipates up to there, meets the curve. Damping is
/// ξ + 2 k (F_y d − F d_y) / (π F d) with k = 0.33 (low dissipation), F_y and d_y of the bilinear curve with the first stiffness and the
/// area below the curve up to d. \param curve  of the building \param stiffness  N/m, the first
PerformancePoint capacity_spectrum_point(const CapacityCurve& curve, double stiffness, const EquivalentSystem& system,
                                         const DemandSpectrum& spectrum);

/// Says so where less than 60 % of the mass moves as the shape does.
void doubt_shape(PerformancePoint& p, const EquivalentSystem& system);

/// Compares the target displacement of a point with the capacity. \param near_collapse  m; NaN: not reached \param peak  m, displacement at
/// the largest base shear \param end  m, farthest displacement
void compare_with_capacity(PerformancePoint& p, double near_collapse, double peak, double end);

}  // namespace voussoir::io
