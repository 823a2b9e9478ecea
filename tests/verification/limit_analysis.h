// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model.h"

/// Limit analysis of plane assemblies of rigid blocks with dry joints (Livesley 1978; Ferris and Tin-Loi 2001), by linear programmes.
namespace voussoir::testing {

/// Factors of a horizontal body force, over the weight.
struct CollapseFactors {
  /// The largest under which forces at the contact points of the joints keep every block in balance: no tension, |shear| <= tan φ ×
  /// compression at each point. By the static theorem the collapse factor where slip opens joints by tan φ of its amount (associated flow).
  /// Where slip does not, as in Coulomb's law, no collapse factor is higher (Drucker 1954, Radenkovic 1961).
  double associated = 0.0;
  /// A collapse factor with slip that does not open joints: the limits of shear hold their ground while the mechanism forms (Gilbert,
  /// Casapulla and Ahmed 2006). There may be others: forces before collapse are not unique.
  double coulomb = 0.0;
};

/// Contact points are the centres of the segments, as in the method; those behind one another are one.
///
/// \param model  blocks that touch in planes through the normal of (along, z); every joint dry; fixed blocks and the base are supports
/// \param friction  angle φ [degrees]
/// \param along  horizontal unit vector: where the body force points
/// \throw std::runtime_error if the blocks do not stand under their weight alone, no factor is too large, or iterations find no end (they
/// may not where tan φ > 1 and blocks interlock).
CollapseFactors collapse_factors(const cases::Model& model, double friction, Vec3 along);

}  // namespace voussoir::testing
