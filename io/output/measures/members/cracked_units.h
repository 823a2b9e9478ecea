// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace voussoir::io {

class Hdf5File;

/// Units in cells, and those of them in which a spring between two cells has broken.
struct CrackedUnits {
  std::int64_t units = 0, cells = 0;  // 0: no unit of the model is in cells
  std::int64_t cracked = 0;           // of `units`, by the rows of /cracks
  std::int64_t through = 0;           // of `cracked`: some joint between two cells has lost all its area
};

/// \throw FileError
CrackedUnits cracked_units(const Hdf5File& run);

}  // namespace voussoir::io
