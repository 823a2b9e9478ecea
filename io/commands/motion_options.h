// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/commands/motion_command.h"

namespace CLI {
class App;
}

/// Options of `voussoir motion` on the command line.
namespace voussoir::io {

inline constexpr const char* kMotion = "peaks, durations, Arias intensity and response spectra of records";

void add_motion_options(CLI::App& command, std::vector<std::string>& files, MotionOptions& o);

}  // namespace voussoir::io
