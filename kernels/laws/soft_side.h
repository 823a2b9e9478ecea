// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Constants and memory of bonds that soften; their law is softening.h.
namespace voussoir::kernels {

/// Softening parameters of the bonds of a side. All zero: as segment_law.h.
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

}  // namespace voussoir::kernels
