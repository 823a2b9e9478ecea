// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/case_file/case_file.h"

namespace voussoir::io {

struct LimitCommandOptions {
  std::string direction = "x";  // x, -x, y, -y, or degrees from x towards y
  int facets = 8;               // of the friction cone
  bool outer = false;           // round the cone instead of in it
  std::string mechanism;        // CSV file of the mechanism; empty: none
  bool associated = false;      // alone
  bool json = false, overwrite = false, quiet = false;
};

/// `voussoir limit`: the collapse multiplier of a horizontal body force and its mechanism, by limit analysis of dry rigid blocks
/// (solver/analysis/limit.h). \throw cases::InputError, FileError
int limit_command(const LoadedCase& c, const LimitCommandOptions& o);

}  // namespace voussoir::io
