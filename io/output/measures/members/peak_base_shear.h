// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace voussoir::io {

class Hdf5File;

/// The largest horizontal force of the base on the structure, √(x² + y²).
struct PeakBaseShear {
  double value = 0;  // N: the largest that the run looked at (every output.history_interval) and of the rows of /forces
  double time = 0;   // s, of the largest row of /forces, which are rarer; 0: there are no rows
};

/// The peak base shear of a run, so far if it goes on: the one source for `summary` and `assess`. \throw FileError
PeakBaseShear peak_base_shear(const Hdf5File& run);

}  // namespace voussoir::io
