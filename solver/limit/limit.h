// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "cases/case.h"
#include "cases/model.h"
#include "kernels/rows.h"
#include "solver/limit/contacts.h"
#include "solver/limit/limit_proof.h"
#include "solver/limit/live_load.h"
#include "solver/limit/programme/linear_programme.h"

/// Limit analysis of dry assemblies of rigid blocks (Livesley 1978; Ferris and Tin-Loi 2001), by linear programmes: no tension, friction at
/// contact points, no crushing; bonds are taken as broken. Nothing moves before it collapses, so no dynamics and no stiffness are in it.
namespace voussoir::solver {

/// Contacts bear the live forces however large they are.
class NothingFalls : public cases::InputError {
 public:
  using cases::InputError::InputError;
};

struct LimitOptions {
  LiveLoad live{};                                                // what the multiplier multiplies
  int facets = 8;                                                 // of the friction cone, >= 4; in a plane there are two, which are exact
  bool outer = false;                                             // facets round the cone instead of in it
  std::function<void(int programmes, double multiplier)> tick{};  // after every programme; may be empty
  bool coulomb = true;                // false: the associated multiplier alone, which is one programme; LimitResult::coulomb stays empty
  std::size_t inside_from = kLpHuge;  // unknowns from which on programmes are solved by an interior-point method in place of Clp
};

/// What one rule of flow gives.
struct LimitState {
  double multiplier = 0.0;
  /// Of each body in the mechanism, about its centre of mass; the fastest contact point or centre has the speed 1.
  std::vector<kernels::Twist> motion;
  int programmes = 0;
  double last_change = 0.0;  // of the multiplier in the last iteration, a ratio; 0: there is one programme
  LimitProof proof;
};

struct LimitResult {
  LimitContacts contacts;
  bool plane = false;       // programmes were solved in a plane
  double weight = 0.0;      // N, of all bodies
  double cone_error = 0.0;  // by how much, at most, the facets take friction too low (outer: too high): a ratio
  bool has_loads = false;   // [[load]]s of the case act as dead loads, at their full size
  bool is_tilt = false;     // no loads, on a level base: a multiplier is the tangent of the base's tilt at collapse
  /// Slip opens joints by tan φ of its amount. By the static theorem the largest multiplier under which forces keep every body in balance.
  /// Where slip does not open joints, as in Coulomb's law, no collapse multiplier is higher (Drucker 1954, Radenkovic 1961).
  LimitState associated;
  /// Slip opens nothing: forces within Coulomb's limit, and a mechanism that they let move. It is looked for by the iterations of Gilbert,
  /// Casapulla and Ahmed (2006), in which each point's yield line T = c + m N is rotated about the compression last found. There may be
  /// other such multipliers: forces before collapse are not unique. Those of this mechanism lie between proof.lower and proof.upper.
  LimitState coulomb;
  /// Whether a Coulomb multiplier was asked for and found, with its proof.
  [[nodiscard]] bool coulomb_proven() const noexcept { return coulomb.proof.holds; }

  static constexpr int kLeastProgrammes = 18, kMostProgrammes = 140;  // of both rules together
};

/// The multiplier of `associated` is never given without its proof. That of `coulomb` is given without one if none is found
/// (coulomb_proven()).
/// \throw cases::InputError if there is no gravity, nothing can move, the blocks do not stand under dead loads alone (a mechanism proves
/// it) \throw NothingFalls (forces prove it) \throw NumericalError if nothing is found that proves either \throw std::logic_error without
/// linear programmes (has_linear_programmes)
LimitResult limit_analysis(const cases::Case& c, const cases::Model& model, const LimitOptions& options);

}  // namespace voussoir::solver
