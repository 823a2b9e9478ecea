// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "cases/model.h"

/// Criterion of collapse of a building, common to the summary of a run and to quantities derived from its frames.
namespace voussoir::solver {

/// Sums the mass of elements and of fallen elements.
class FallenMass {
 public:
  /// Whether an element has fallen: it has sunk by more than half its initial height above the base (without one, above the lowest
  /// corner of the model), or by more than 1 m. (Only the latter
  /// if it began below the base, as a structure on fixed blocks may.)
  static constexpr bool has_fallen(double sunk, double height) noexcept {
    return sunk > (height > 0.0 ? std::min(0.5 * height, 1.0) : 1.0);
  }

  /// \param mass  [kg] \param sunk  from the reference configuration [m] \param height  of the centroid above the base in it [m]
  void add(cases::PartKind kind, double mass, double sunk, double height) noexcept {
    const double fallen = has_fallen(sunk, height) ? mass : 0.0;
    const bool is_roof = kind == cases::PartKind::beam || kind == cases::PartKind::voussoir;
    all_ += mass;
    fallen_ += fallen;
    roof_ += is_roof ? mass : 0.0;
    fallen_roof_ += is_roof ? fallen : 0.0;
  }

  /// Fallen fraction of all mass.
  [[nodiscard]] double fraction() const noexcept { return all_ > 0.0 ? fallen_ / all_ : 0.0; }
  /// Whether more than half of the roof's mass has fallen; without a roof, of all mass.
  [[nodiscard]] bool is_collapse() const noexcept { return roof_ > 0.0 ? fallen_roof_ > 0.5 * roof_ : fallen_ > 0.5 * all_; }

 private:
  double all_ = 0.0, fallen_ = 0.0, roof_ = 0.0, fallen_roof_ = 0.0;  // kg
};

}  // namespace voussoir::solver
