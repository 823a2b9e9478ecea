// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/commands/assess/assess_command.h"
#include "io/commands/assess/limit_command.h"

namespace CLI {
class App;
}

/// Options of `voussoir assess` and `voussoir limit` on the command line.
namespace voussoir::io {

inline constexpr const char* kAssess = "crack widths and crack maps, storey drift, forces through cuts, floor spectra of a run";
inline constexpr const char* kLimit = "collapse multiplier and mechanism of dry blocks by limit analysis; runs nothing";

void add_assess_options(CLI::App& command, AssessOptions& o);

/// All but the case.
void add_limit_options(CLI::App& command, LimitCommandOptions& o);

}  // namespace voussoir::io
