// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/vec3.h"

/// Output of a run. The solver calls a Recorder between steps; io implements it. Time zero is the start of the shaking; settling has
/// negative times.
namespace voussoir::solver {

enum class FailureMode : std::uint8_t { none = 0, tension = 1, shear = 2, compression = 3 };

/// Motion of one followed element relative to the base: displacement of its centroid [m], velocity [m/s], rotation vector [rad].
struct HistorySample {
  Vec3 displacement, velocity, rotation;
};

/// A tie: its force [N, tension positive], elongation and plastic elongation [m], and whether it has broken.
struct TieSample {
  double force = 0.0, elongation = 0.0, plastic = 0.0;
  bool broken = false;
};

/// The bars of a deck or a mesh together: each figure is that of the bar in which it is largest in magnitude.
struct TieGroupSample {
  double force = 0.0, elongation = 0.0;  // N, m; tension is positive
  double utilisation = 0.0;              // magnitude of the force over the yield force; NaN: all bars are elastic
  std::int64_t yielded = 0, broken = 0;  // bars that have yielded (and are not broken), bars that have broken
};

/// All shares of one [[load]]: their force [N], and the displacement of the place where they act, from time zero [m]; the mean of several
/// places by their shares. NaN: it acts nowhere.
struct LoadSample {
  Vec3 force, displacement;
};

/// The energy ledger [J]: stores (strain: of bonds and ties), work put in, losses since time zero (or since the start while settling),
/// residual as a ratio.
struct EnergyRow {
  double time = 0;                                           // s
  double kinetic = 0, strain = 0, contact = 0, gravity = 0;  // stores
  double input = 0;                                          // ground, loads, supports, initial
  double dashpot = 0, friction = 0, fracture = 0, damping = 0;
  double residual = 0;
};

/// Parameters of a quasi-static analysis, chosen before its first step (solver/analysis/drive.h).
struct Drive {
  double frequency = 0;   // Hz, first frequency, with all joints closed
  double damping = 0;     // 1/s, mass damping
  double pace = 0;        // s, time in which the displacement of the moving end grows by a factor e; 0: not chosen
  double compliance = 0;  // m, conjugate displacement at a load factor of 1 before cracking
  double stiffness = 0;   // 1/m, load factor of the spring per displacement
  double first = 0;       // m, initial displacement from which the moving end grows
  double fastest = 0;     // m/s, greatest speed of the moving end
  double weight = 0;      // N, of all forces at a load factor of 1
  double speed = 1;       // factor on the time in histories of supports
  double quiet = 0;       // J: kinetic energy that a structure following its supports does not exceed, but a falling one does
};

/// State of a quasi-static analysis. Displacements are relative to time zero, along its direction.
struct AssessmentRow {
  double time = 0;           // s
  double factor = 0;         // load factor; tangent of the tilt
  double displacement = 0;   // m, of the control point
  double drift = 0;          // displacement over the control point's height above the base
  double moved = 0;          // m, conjugate to the forces: their work is the integral of factor x weight over this displacement
  double base_shear = 0;     // N, on base and supports, mean over a first period
  double support_moved = 0;  // m, greatest displacement of a support
  double over = 0;           // 1 once the analysis has reached its end; 2: here it has found no state of rest
  // Largest unbalanced force over the mean weight of an element, or moment over that and the element's radius; NaN: it moves
  double unbalanced = std::numeric_limits<double>::quiet_NaN();
};

/// Force and moment about the origin that the base exerts on the structure.
struct ForcesRow {
  double time = 0;               // s
  Vec3 base_shear, base_moment;  // N, N m
};

/// Force through a cut: that of the part before its plane (where the normal points) on the part behind it, and the moment of that force
/// about the cut's point. The force times the normal is thus tension.
struct CutSample {
  Vec3 force, moment;  // N, N m
};

/// Segment sides that have failed, by the limit that they reached first.
struct FirstLimits {
  std::int64_t tension = 0, shear = 0, compression = 0;
};

/// Segment sides by state: bonded includes slipped; tension, shear and compression are broken sides, by the mode that opened them.
struct DamageRow {
  double time = 0;  // s
  std::int64_t bonded = 0, slipped = 0, tension = 0, shear = 0, compression = 0;
  FirstLimits first;
};

/// A broken segment.
struct CrackRow {
  double time = 0;                                       // s
  std::int32_t joint = 0, element_a = 0, element_b = 0;  // joint of the assembly; element −1: the base
  Vec3 position, normal;                                 // current, m
  double area = 0;                                       // m2
  FailureMode mode = FailureMode::none;                  // mode that opened it
  FailureMode first_mode = FailureMode::none;            // limit reached first
  double first_time = 0;                                 // s, when it reached that limit
};

/// A snapshot of all n elements: displacement of the centroid from the start (n×3, m), orientation (n×4: w, x, y, z), broken
/// fraction of the element's bonds (n).
struct FrameView {
  double time = 0;  // s
  std::span<const float> displacement, quaternion, broken;
};

/// Damage by the building's own weight: segment sides as in DamageRow, at the start of the shaking or so far.
struct SettlingDamage {
  std::int64_t tension = 0, shear = 0, compression = 0, slipped = 0;
  double first_crack_time = 0;  // s, below 0; 0: none

  [[nodiscard]] std::int64_t opened() const noexcept { return tension + shear + compression; }
};

struct Summary {
  bool collapsed = false;
  double fallen_mass_fraction = 0;
  double first_crack_time = -1;                                       // s, during the shaking; < 0: none
  std::int64_t tension = 0, shear = 0, compression = 0, slipped = 0;  // segment sides, as in DamageRow
  FirstLimits first;
  SettlingDamage settling;     // part of the counts above
  double peak_base_shear = 0;  // N
  double peak_speed = 0;       // m/s
  double worst_residual = 0;
  bool settled = true;
  double end_time = 0;  // s reached
};

class Recorder {
 public:
  virtual ~Recorder() = default;
  /// One sample per Output::history entry, in order.
  virtual void history(double time, std::span<const HistorySample> samples) = 0;
  /// One sample per tie outside meshes, in order, before history() of the same time; not called without such ties.
  virtual void ties(double /*time*/, std::span<const TieSample> /*samples*/) {}
  /// Decks and meshes, in the order of cases::tie_groups; before the history of the same time. Only of a model that has some.
  virtual void tie_groups(double /*time*/, std::span<const TieGroupSample> /*samples*/) {}
  /// Loads of the case, in order; before the history of the same time. Only of a case that has some.
  virtual void loads(double /*time*/, std::span<const LoadSample> /*samples*/) {}
  virtual void energy(const EnergyRow& row) = 0;
  virtual void forces(const ForcesRow& row) = 0;
  /// One sample per Output::cuts entry, in order; not called without cuts.
  virtual void cuts(double /*time*/, std::span<const CutSample> /*samples*/) {}
  virtual void damage(const DamageRow& row) = 0;
  virtual void cracks(std::span<const CrackRow> rows) = 0;
  virtual void frame(const FrameView& frame) = 0;
  virtual void summary(const Summary& s) = 0;
  /// For quasi-static analyses only: drive() once before the rows (also in a resumed run), assessment() at the ledger's interval.
  virtual void drive(const Drive&) {}
  /// The element that is the control point; with drive().
  virtual void control(std::int32_t /*element*/) {}
  virtual void assessment(const AssessmentRow&) {}
};

}  // namespace voussoir::solver
