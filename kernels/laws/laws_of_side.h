// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The optional laws of a side, those that few models have, behind one view, which kernels and solver ask by side_laws.h. A new law has its
/// constants and its member here. What it computes stands in a header of its own, which only side_laws.h includes, so that the solver need
/// not be compiled again with it. Free patches, which have their own kernels, know of crushing alone.
namespace voussoir::kernels {

/// Softening parameters of the bonds of a side (softening.h). All zero: as segment_law.h.
struct Softening {
  double opening = 0.0;    // u_c k̄_n / f_t: opening that adds a wear of 1, in elastic openings at the limit; 0: brittle in tension
  double slip = 0.0;       // m, s_c: slip that adds a wear of 1; 0: slip adds none
  double dilatancy = 0.0;  // tan ψ of the first slip
  bool linear = false;     // share_left is 1 − κ/2, else exp(−κ)
};

/// A side whose bonds soften.
struct SoftSide {
  Softening law;
  double* wear = nullptr;  // by segment; nullptr: this side does not soften

  [[nodiscard]] SoftSide from(int i) const noexcept { return {law, wear + i}; }
};

/// A dry joint that stiffens as it closes (closing.h).
struct Closing {
  double most = 0.0;    // m, V: greatest closure of the joint under any pressure; 0: its stiffness is constant
  double scale = 0.0;   // Pa, k_n V: pressure at which the joint has closed by V/2
  double blocks = 0.0;  // Pa/m, stiffness of the two blocks without the joint, (4)

  [[nodiscard]] bool on() const noexcept { return most > 0.0; }
};

/// Pressure that contacts bear (crushing.h).
struct Crushing {
  double strength = 0.0;  // Pa; 0: contacts bear any pressure
  double residual = 0.0;  // Pa, of crushed material
  double slope = 0.0;     // Pa/m, loss of strength per crushed depth, down to `residual`; 0: no loss
  double depth = 0.0;     // m, greatest crushed depth; at that depth a point bears any pressure

  [[nodiscard]] bool on() const noexcept { return strength > 0.0; }
};

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
