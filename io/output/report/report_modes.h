// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/analysis/modes.h"

namespace voussoir::io {

/// Mode shapes in the form of the report page.
struct ReportModes {
  /// JSON list: frequency [Hz]; share: fraction of the mass that moves along x, y, z; move, turn: units of the shape, m and rad.
  std::string json;
  /// For each mode and element displacement and rotation (x, y, z), in units of `move` and `turn`. The largest component of a displacement
  /// in a mode is 1 m.
  std::vector<std::int16_t> shape;
};

/// Packs modes. \param modes  each with a nonzero displacement
ReportModes report_modes(const std::vector<solver::Mode>& modes);

}  // namespace voussoir::io
