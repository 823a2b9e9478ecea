// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/laws/closing.h"
#include "kernels/laws/crushing.h"
#include "kernels/laws/soft_side.h"

/// The optional laws of a side, those that few models have, behind one view, which kernels and solver ask by side_laws.h. A new law has its
/// member here. Free patches, which have their own kernels, know of crushing alone.
namespace voussoir::kernels {

struct SideLaws {
  SoftSide soft;                       // its bonds soften
  Closing closing;                     // it stiffens as it closes
  const Crushing* crushing = nullptr;  // of all contacts; nullptr: they bear any pressure
  double* crushed = nullptr;           // m, by segment

  /// The same of the segments from `i` on.
  [[nodiscard]] SideLaws from(int i) const noexcept {
    return {softens() ? soft.from(i) : soft, closing, crushing, crushed == nullptr ? nullptr : crushed + i};
  }

  [[nodiscard]] bool softens() const noexcept { return soft.wear != nullptr; }
  /// Whether its bonds follow another law than advance_segment, once they have reached a limit.
  [[nodiscard]] bool has_bonds_of_its_own() const noexcept { return softens(); }
  /// Whether its contacts give way before the law of contact is asked.
  [[nodiscard]] bool moves_contacts() const noexcept { return closing.on() || crushing != nullptr; }
  /// Whether slip can leave contacts that touch before the faces meet.
  [[nodiscard]] bool opens_by_slip() const noexcept { return softens() && soft.law.dilatancy != 0.0; }
};
/// A side without any.
inline constexpr SideLaws kNoLaws{};

}  // namespace voussoir::kernels
