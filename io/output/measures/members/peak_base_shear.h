// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace voussoir::io {

class Hdf5File;

/// The largest horizontal force of the base on the structure, √(x² + y²).
struct PeakBaseShear {
  double value = 0;  // N: the largest that the run looked at (every output.history_interval) and of the rows of /forces
  double time = 0;   // s, of the largest row of /forces, which are rarer; 0: there are no rows

  /// Over a weight [N]; NaN if there is none.
  [[nodiscard]] double over(double weight) const noexcept;
};

/// The peak base shear of a run, so far if it goes on: the one source for `summary` and `assess`. \throw FileError
PeakBaseShear peak_base_shear(const Hdf5File& run);

/// Weight of all elements that are not fixed, N; `gravity`: its acceleration, m/s². \throw FileError
double weight_of(const Hdf5File& run, double gravity);

}  // namespace voussoir::io
