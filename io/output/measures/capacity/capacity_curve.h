// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

/// The curve of a quasi-static analysis, and its bilinear forms.
namespace voussoir::io {

/// Rows of /assessment, and energies at the same times.
struct CapacityCurve {
  std::vector<double> time;                                            // s
  std::vector<double> factor, displacement, drift, moved, base_shear;  // 1, m, 1, m, N
  std::vector<double> support_moved, over;                             // m, 0 or 1
  std::vector<double> input, kinetic, damping, losses, stored;         // J; losses include damping, stored includes kinetic
  std::vector<double> unbalanced;  // 1, how far each row is from a state of rest; empty: rows of a motion
  double lost_residual = std::numeric_limits<double>::quiet_NaN();  // 1, of the ledger where no further state of rest was found
};

/// An elastic-perfectly plastic curve.
struct Bilinear {
  double stiffness = kNone, force = kNone, yield = kNone, ultimate = kNone, ductility = kNone;  // N/m, N, m, m, 1
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace voussoir::io
