// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "cases/forward.h"
#include "cases/input_error.h"
#include "kernels/rows.h"
#include "solver/limit/contacts.h"
#include "solver/limit/limit_proof.h"
#include "solver/limit/live_load.h"
#include "solver/limit/programme/linear_programme.h"

/// Limit analysis of dry assemblies of rigid blocks (Livesley 1978; Ferris and Tin-Loi 2001), by linear programmes: no tension, friction at
/// contact points, no crushing; bonds count as broken. Nothing moves before collapse, so dynamics and stiffness are not considered.
namespace voussoir::solver {

/// No collapse: contacts bear live forces of any size.
class NothingFalls : public cases::InputError {
 public:
  using cases::InputError::InputError;
};

struct LimitOptions {
  LiveLoad live{};                                                // the load scaled by the multiplier
  int facets = 8;                                                 // of the friction cone, >= 4; in a plane there are two, which are exact
  bool outer = false;                                             // circumscribed facets instead of inscribed ones
  std::function<void(int programmes, double multiplier)> tick{};  // called after every programme; may be empty
  LpWatch iterated{};                                             // called after every iteration of a large programme; may be empty
  bool coulomb = true;                // false: only the associated multiplier, by one programme; LimitResult::coulomb stays empty
  std::size_t inside_from = kLpHuge;  // number of unknowns from which on programmes are solved by an interior-point method instead of Clp
};

/// Result for one flow rule.
struct LimitState {
  double multiplier = 0.0;
  /// By body, of the mechanism, about its centre of mass; the fastest contact point or centre has the speed 1.
  std::vector<kernels::Twist> motion;
  std::vector<double> ties;  // N, tension, by LimitContacts::ties
  int programmes = 0;
  double last_change = 0.0;  // relative change of the multiplier in the last iteration; 0: a single programme
  LimitProof proof;
};

struct LimitResult {
  LimitContacts contacts;
  bool plane = false;       // programmes were solved in a plane
  double weight = 0.0;      // N, of all bodies
  double cone_error = 0.0;  // greatest relative error of the friction by the facets, too low (outer: too high)
  bool has_loads = false;   // [[load]]s of the case act as dead loads, at full size
  bool is_tilt = false;     // no loads, on a level base: the multiplier is the tangent of the base's tilt at collapse
  /// Associated flow: slip opens joints by tan φ of its amount. By the static theorem, the largest multiplier under which forces keep every
  /// body in equilibrium. With flow rules without this opening, as Coulomb's, no collapse multiplier is higher (Drucker 1954, Radenkovic
  /// 1961).
  LimitState associated;
  /// Coulomb's flow, without opening by slip: forces within Coulomb's limit, and a mechanism admissible for them. Found by the iterations
  /// of Gilbert, Casapulla and Ahmed (2006), in which each point's yield line T = c + m N is rotated about the compression last found.
  /// Other such multipliers may exist, since forces before collapse are not unique. Those of this mechanism are between proof.lower and
  /// proof.upper.
  LimitState coulomb;
  /// Whether a Coulomb multiplier was requested and found, with its proof.
  [[nodiscard]] bool coulomb_proven() const noexcept { return coulomb.proof.holds; }

  static constexpr int kLeastProgrammes = 18, kMostProgrammes = 140;  // of both flow rules together
};

/// Runs the analysis. The multiplier of `associated` is always proven. That of `coulomb` is given without a proof if none is found
/// (coulomb_proven()).
/// \throw cases::InputError if there is no gravity, nothing can move, or the blocks do not stand under dead loads alone (proven by a
/// mechanism) \throw NothingFalls (proven by forces) \throw NumericalError if neither can be proven \throw std::logic_error without linear
/// programmes (has_linear_programmes)
LimitResult limit_analysis(const cases::Case& c, const cases::Model& model, const LimitOptions& options);

}  // namespace voussoir::solver
