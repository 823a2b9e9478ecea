// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/input/case_file/case_file.h"

namespace CLI {
class App;
}

/// The options by which a command is told of a case, and the case that they give.
namespace voussoir::io {

/// The words of the command line, before they mean anything.
struct CaseWords {
  std::string name;                                            // CASE
  std::vector<std::string> set;                                // --set key=value
  std::vector<std::string> motion;                             // --motion axis=file
  std::string direction, record, scale, duration, dt, frames;  // short names of keys of the case
  int threads = 0;                                             // -j; 0: as OpenMP decides
};

/// CASE, --set and -j.
void add_case(CLI::App& command, CaseWords& w);

/// Short names of keys of the case: --direction, --record, ... What they say becomes overrides, so the resolved case holds it.
void add_short_keys(CLI::App& command, CaseWords& w);

/// Reads the case, its stones and its record, prints its notes and warnings, and calls `use`. A fault of the input that `use` throws is
/// told with file, line and key. \param raw_stones  leave the stones to `use`, which also shows what is refused \return the exit code
/// \throw cases::InputError, FileError of the case itself
int with_case(const CaseWords& w, const std::function<int(const LoadedCase&)>& use, bool raw_stones = false);

}  // namespace voussoir::io
