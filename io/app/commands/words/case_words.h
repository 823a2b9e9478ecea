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

/// Options that select and change a case, and the case that results.
namespace voussoir::io {

/// Words of the command line, not yet interpreted.
struct CaseWords {
  std::string name;                                            // CASE
  std::vector<std::string> set;                                // --set key=value
  std::vector<std::string> motion;                             // --motion axis=file
  std::string direction, record, scale, duration, dt, frames;  // short names of keys of the case
  int threads = 0;                                             // -j; once the program has begun to work, never 0
};

/// Adds CASE, --set and -j.
void add_case(CLI::App& command, CaseWords& w);

/// Adds short names of keys of the case: --direction, --record, ... Their values become overrides, so the resolved case contains them.
void add_short_keys(CLI::App& command, CaseWords& w);

/// Reads the case, its stones and its record, prints its notes and warnings, and calls `use`. Reports input faults thrown by `use` with
/// file, line and key. \param raw_stones  leave reading the stones to `use`, which also shows refused ones \return the exit code
/// \throw cases::InputError, FileError of the case itself
int with_case(const CaseWords& w, const std::function<int(const LoadedCase&)>& use, bool raw_stones = false);

}  // namespace voussoir::io
