// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/case_file/case_file.h"

namespace voussoir::io {

struct LimitCommandOptions {
  std::string direction;         // x, -x, y, -y, z, -z, degrees from x towards y, or a vector X,Y,Z; empty: x, of point loads -z
  std::vector<std::string> on;   // blocks that are loaded
  std::optional<double> force;   // N, in place of weights
  std::vector<double> at, path;  // m, coordinates of a point; of the corners of a path, one after the other
  int positions = 21;            // on the path
  int facets = 8;                // of the friction cone
  bool outer = false;            // round the cone instead of in it
  std::string mechanism;         // CSV file of the mechanism; empty: none
  bool associated = false;       // alone
  bool json = false, overwrite = false, quiet = false;
};

/// `voussoir limit`: the collapse multiplier of a live load and its mechanism, by limit analysis of dry rigid blocks
/// (solver/limit/limit.h). \throw cases::InputError, FileError
int limit_command(const LoadedCase& c, const LimitCommandOptions& o);

}  // namespace voussoir::io
